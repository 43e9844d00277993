#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "surface/surface.hpp"

namespace meshbound {

/// A place where an original edge crosses a current edge. Both run from their lower vertex to their upper one. Nothing is set
/// by default, so that blocks of them take memory only as they fill.
struct Crossing {
    double s;               ///< along the original edge, 0…1
    double t;               ///< along the current edge, 0…1
    std::uint32_t original; ///< the original edge
    std::uint32_t current;  ///< the current edge
    std::uint32_t previous; ///< the crossing before this one on the original edge, or no_index
    std::uint32_t next;     ///< the one behind it, or no_index
    std::uint32_t sibling;  ///< another crossing on the same current edge, or no_index
    bool rightward;         ///< with s rising, passes from the left of the current edge to its right
};

/// All crossings: each original edge is a chain of them in their order along it, each current edge a set. The chains make
/// sorting needless, and their order holds even where two crossings have the same s.
///
/// Several threads may change crossings at once, each with a Supply of its own, where no current and no original edge is
/// changed by two of them. Which name a crossing gets is then chance; nothing may depend on it.
class Crossings {
public:
    explicit Crossings(std::size_t edges) : blocks_(most_blocks), chains_(edges), on_(edges, no_index) {}

    /// Free places for crossings, of one thread.
    class Supply {
    public:
        explicit Supply(Crossings& crossings) : crossings_(crossings) {}
        Supply(const Supply&) = delete;
        Supply& operator=(const Supply&) = delete;
        ~Supply() { crossings_.take_back(*this); }

    private:
        friend class Crossings;
        Crossings& crossings_;
        std::uint32_t unused_ = no_index;   // chained by sibling
        std::uint32_t fresh_ = 0, end_ = 0; // never used so far
    };

    const Crossing& operator[](std::uint32_t id) const { return at(id); }

    /// First and last crossing of an original edge, or no_index.
    std::uint32_t first(std::uint32_t original) const { return chains_[original].first; }
    std::uint32_t last(std::uint32_t original) const { return chains_[original].last; }

    /// One crossing on a current edge (the others are its siblings), or no_index.
    std::uint32_t on(std::uint32_t current) const { return on_[current]; }

    /// Forgets all crossings on a current edge. The chains through them are left open: relink them.
    void clear(std::uint32_t current, Supply& supply);

    /// Adds a crossing to its current edge and returns its name.
    std::uint32_t add(const Crossing& crossing, Supply& supply);

    /// Makes two crossings neighbours on an original edge; no_index stands for its end.
    void link(std::uint32_t original, std::uint32_t before, std::uint32_t after);

private:
    struct Chain {
        std::uint32_t first = no_index, last = no_index;
    };
    /// Blocks of places, so that places never move while others look at them. As many as there may ever be: 500 million
    /// places, of which a surface takes about one for each of its triangles.
    static constexpr std::uint32_t block_bits = 17, block_size = 1 << block_bits, most_blocks = 1 << 12;

    Crossing& at(std::uint32_t id) const { return blocks_[id >> block_bits][id % block_size]; }
    void refill(Supply& supply);
    void take_back(Supply& supply);

    std::vector<std::unique_ptr<Crossing[]>> blocks_;
    std::vector<Chain> chains_;     // by original edge
    std::vector<std::uint32_t> on_; // by current edge
    std::mutex mutex_;              // of what follows
    std::uint32_t size_ = 0;        // places that were handed out
    /// The first place of a chain that was given back; its next is the first of another one.
    std::uint32_t returned_ = no_index;
};

} // namespace meshbound
