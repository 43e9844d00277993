#pragma once

#include <cstdint>
#include <vector>

#include "surface.hpp"

namespace meshbound {

/// A place where an original edge crosses a current edge. Both run from their lower vertex to their upper one.
struct Crossing {
    double s = 0;                      ///< along the original edge, 0…1
    double t = 0;                      ///< along the current edge, 0…1
    std::uint32_t original = no_index; ///< the original edge
    std::uint32_t current = no_index;  ///< the current edge
    std::uint32_t previous = no_index; ///< the crossing before this one on the original edge
    std::uint32_t next = no_index;     ///< the one behind it
    std::uint32_t sibling = no_index;  ///< another crossing on the same current edge
    bool rightward = false;            ///< with s rising, passes from the left of the current edge to its right
};

/// All crossings: each original edge is a chain of them in their order along it, each current edge a set. The chains make
/// sorting needless, and their order holds even where two crossings have the same s.
class Crossings {
public:
    Crossings(std::size_t edges) : first_(edges, no_index), last_(edges, no_index), on_(edges, no_index) {}

    /// Names of crossings are below this.
    std::size_t size() const { return pool_.size(); }

    const Crossing& operator[](std::uint32_t id) const { return pool_[id]; }

    /// First and last crossing of an original edge, or no_index.
    std::uint32_t first(std::uint32_t original) const { return first_[original]; }
    std::uint32_t last(std::uint32_t original) const { return last_[original]; }

    /// One crossing on a current edge (the others are its siblings), or no_index.
    std::uint32_t on(std::uint32_t current) const { return on_[current]; }

    /// Forgets all crossings on a current edge. The chains through them are left open: relink them.
    void clear(std::uint32_t current);

    /// Adds a crossing to its current edge and returns its name.
    std::uint32_t add(const Crossing& crossing);

    /// Makes two crossings neighbours on an original edge; no_index stands for its end.
    void link(std::uint32_t original, std::uint32_t before, std::uint32_t after);

private:
    std::vector<Crossing> pool_;
    std::uint32_t unused_ = no_index;         // free places of the pool, chained by sibling
    std::vector<std::uint32_t> first_, last_; // by original edge
    std::vector<std::uint32_t> on_;           // by current edge
};

} // namespace meshbound
