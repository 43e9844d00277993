#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "util/indexing.hpp"

namespace meshbound {

/// Brings several linked lists into the cache before they are walked. Their nodes lie scattered in memory, and each is
/// known only from the one before; following all lists in step lets the cache misses overlap.
class LinkedListPrefetcher {
public:
    void clear() { nodes_.clear(); }
    /// The first node of a list, or no_index.
    void add(std::uint32_t first) {
        if (first != no_index) nodes_.push_back(first);
    }
    /// `next(node)`: the node after it, or no_index.
    template <class Next>
    void follow(const Next& next) {
        while (nodes_.size() > 1) { // of a single list no misses would overlap
            std::size_t left = 0;
            for (const std::uint32_t node : nodes_)
                if (const std::uint32_t after = next(node); after != no_index) nodes_[left++] = after;
            nodes_.resize(left);
        }
    }

private:
    std::vector<std::uint32_t> nodes_; // the current node of each list
};

} // namespace meshbound
