#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "surface/surface.hpp"

namespace meshbound {

/// Where an original edge crosses a current edge. Both run from their lower vertex to their upper one. No member has a
/// default value, so that the pages of a block are touched only as it fills.
struct Crossing {
    double s;               ///< along the original edge, 0…1
    double t;               ///< along the current edge, 0…1
    std::uint32_t original; ///< the original edge
    std::uint32_t current;  ///< the current edge
    std::uint32_t previous; ///< the crossing before this one on the original edge, or no_index
    std::uint32_t next;     ///< the one after it, or no_index
    std::uint32_t sibling;  ///< another crossing on the same current edge, or no_index
    bool rightward;         ///< with s rising, passes from the left of the current edge to its right
};

/// All crossings: each original edge has a doubly linked list of them in their order along it, each current edge a set.
/// Nothing has to be sorted, and the order is right even where two crossings have the same s.
///
/// Several threads may change crossings at once, each with a FreeList of its own, as long as no two of them change the
/// same current or original edge. The ids of crossings are then not deterministic; nothing may depend on them.
class Crossings {
public:
    explicit Crossings(std::size_t edges) : blocks_(most_blocks), lists_(edges), on_(edges, no_index) {}

    /// Free slots for crossings, of one thread.
    class FreeList {
    public:
        explicit FreeList(Crossings& crossings) : crossings_(crossings) {}
        FreeList(const FreeList&) = delete;
        FreeList& operator=(const FreeList&) = delete;
        ~FreeList() { crossings_.reclaim(*this); }

    private:
        friend class Crossings;
        Crossings& crossings_;
        std::uint32_t unused_ = no_index;   // a list, linked by `sibling`
        std::uint32_t fresh_ = 0, end_ = 0; // never used so far
    };

    const Crossing& operator[](std::uint32_t id) const { return at(id); }

    /// First and last crossing of an original edge, or no_index.
    std::uint32_t first(std::uint32_t original) const { return lists_[original].first; }
    std::uint32_t last(std::uint32_t original) const { return lists_[original].last; }

    /// One crossing on a current edge (the others are its siblings), or no_index.
    std::uint32_t on(std::uint32_t current) const { return on_[current]; }

    /// Releases all crossings on a current edge. The lists through them are left broken: link them again.
    void clear(std::uint32_t current, FreeList& free_list);

    /// Adds a crossing to its current edge and returns its id.
    std::uint32_t add(const Crossing& crossing, FreeList& free_list);

    /// Makes two crossings neighbours in the list of an original edge; no_index stands for its end.
    void link(std::uint32_t original, std::uint32_t before, std::uint32_t after);

private:
    struct List {
        std::uint32_t first = no_index, last = no_index;
    };
    /// Blocks of slots, so that crossings never move while other threads read them. Room for 500 million crossings; a
    /// surface has about one for each of its triangles.
    static constexpr std::uint32_t block_bits = 17, block_size = 1 << block_bits, most_blocks = 1 << 12;

    Crossing& at(std::uint32_t id) const { return blocks_[id >> block_bits][id % block_size]; }
    void refill(FreeList& free_list);
    void reclaim(FreeList& free_list);

    std::vector<std::unique_ptr<Crossing[]>> blocks_;
    std::vector<List> lists_;       // by original edge
    std::vector<std::uint32_t> on_; // by current edge
    std::mutex mutex_;              // of what follows
    std::uint32_t size_ = 0;        // slots that were handed out
    /// The first slot of a list that was given back; its `next` is the first slot of another such list.
    std::uint32_t returned_ = no_index;
};

} // namespace meshbound
