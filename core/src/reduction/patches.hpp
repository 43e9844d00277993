#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "metric/rows.hpp"

namespace meshbound {

/// A k-d tree that cuts space into patches with about equally many vertices each. It depends on the positions of the
/// vertices alone, never on the number of threads, so that any number of threads gives the same bytes.
class Patches {
public:
    /// Cuts 2^depth patches. `shift` moves the first cut, and with it the others, off the median, so that the borders
    /// of one partition run through the patches of another.
    Patches(const Rows& rows, const std::vector<std::uint32_t>& vertices, int depth, std::uint32_t shift);

    std::size_t count() const { return first_leaf_; }

    /// The patch in which a position lies (in bounds of position, as rows have it).
    std::size_t patch_of(const glm::dvec3& position) const {
        std::size_t node = 1;
        while (node < first_leaf_)
            node = 2 * node + (position[static_cast<int>(cuts_[node].axis)] < cuts_[node].coordinate ? 0 : 1);
        return node - first_leaf_;
    }

    /// Whether a finite position lies in this patch: faster than patch_of.
    bool contains(std::size_t patch, const glm::dvec3& position) const {
        const Extent& extent = extents_[first_leaf_ + patch];
        return glm::all(glm::lessThanEqual(extent.low, position)) && glm::all(glm::lessThan(position, extent.high));
    }

private:
    using Sample = std::vector<glm::dvec3>::iterator;
    void cut(std::size_t node, Sample first, Sample last, double share);
    void find_extents();

    /// What lies below `coordinate` along the axis is on the one side, the rest on the other.
    struct Cut {
        double coordinate = 0;
        int axis = 0;
    };
    /// What lies neither below `low` nor at or above `high`, on any axis.
    struct Extent {
        glm::dvec3 low{-std::numeric_limits<double>::infinity()}, high{std::numeric_limits<double>::infinity()};
    };

    std::size_t first_leaf_;
    // By node: the root is 1, below node n are 2n and 2n + 1.
    std::vector<Cut> cuts_;
    std::vector<Extent> extents_;
};

} // namespace meshbound
