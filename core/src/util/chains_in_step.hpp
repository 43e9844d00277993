#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/surface.hpp"

namespace meshbound {

/// Walks several chains at once, a link of each in turn, for nothing but to have them at hand afterwards: the links lie
/// scattered in memory, and each tells where the next one is; but while one is on its way those of the other chains are, too.
/// Of a million triangles that saves 4 % of the time.
class ChainsInStep {
public:
    void clear() { links_.clear(); }
    /// A chain's first link, or no_index.
    void add(std::uint32_t first) {
        if (first != no_index) links_.push_back(first);
    }
    /// `next(link)`: the link behind it, or no_index.
    template <class Next>
    void walk(const Next& next) {
        while (links_.size() > 1) { // one alone is walked no sooner than by who needs it
            std::size_t left = 0;
            for (const std::uint32_t link : links_)
                if (const std::uint32_t behind = next(link); behind != no_index) links_[left++] = behind;
            links_.resize(left);
        }
    }

private:
    std::vector<std::uint32_t> links_; // one of each chain
};

} // namespace meshbound
