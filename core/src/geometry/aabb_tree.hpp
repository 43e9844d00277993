#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace meshbound {

/// An axis-aligned bounding box; empty at first.
struct BoundingBox {
    glm::dvec3 lowest{std::numeric_limits<double>::infinity()}, highest{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& p) {
        lowest = glm::min(lowest, p);
        highest = glm::max(highest, p);
    }
    /// Without branches: they would be mispredicted.
    bool overlaps(const BoundingBox& other) const {
        return static_cast<bool>((int{lowest.x <= other.highest.x} & int{other.lowest.x <= highest.x}) &
                                 (int{lowest.y <= other.highest.y} & int{other.lowest.y <= highest.y}) &
                                 (int{lowest.z <= other.highest.z} & int{other.lowest.z <= highest.z}));
    }
};

/// An AABB tree over the slots of a surface. Its topology stays while the triangles in the slots change: a leaf's box
/// is exactly its triangle's; inner boxes contain those of their children, and only grow until the tree is rebuilt.
///
/// Threads may update and query at once. Whether a query sees a slot that another thread is updating is not
/// deterministic, but it sees it only where a box around the old and the new triangle overlaps the box of the query.
class AabbTree {
public:
    struct Item {
        std::uint32_t slot;
        BoundingBox box;
    };

    /// Builds the tree over these slots, all of them less than `slots`.
    void build(std::vector<Item> items, std::size_t slots);

    /// Sets the box of a slot over which the tree was built. An empty box is never found.
    void update(std::uint32_t slot, const BoundingBox& box);

    /// Whether `test(slot)` is true of any slot whose box overlaps the given one, which is finite. Stops at the first.
    template <class Test>
    bool any_overlapping(const BoundingBox& box, Test test) const {
        std::array<std::size_t, 2 * std::numeric_limits<std::size_t>::digits> stack;
        std::size_t count = 0;
        if (leaves_ > 0) stack[count++] = 1;
        while (count > 0) {
            const std::size_t node = stack[--count];
            if (!nodes_[node].box().overlaps(box)) continue;
            if (node >= leaves_) {
                if (test(slot_of_[node - leaves_])) return true;
                continue;
            }
            stack[count++] = 2 * node;
            stack[count++] = 2 * node + 1;
        }
        return false;
    }

private:
    /// A box that threads may read while another writes it: each coordinate is atomic by itself.
    class Node {
    public:
        BoundingBox box() const;
        void set(const BoundingBox& box);
        void grow(const BoundingBox& box);

    private:
        std::array<std::atomic<double>, 3> lowest_, highest_;
    };
    using Items = std::vector<Item>::iterator;
    BoundingBox build(std::size_t node, Items first, Items last);

    std::size_t leaves_ = 0;  // a power of two, or none
    std::vector<Node> nodes_; // the root is 1, below node n are 2n and 2n + 1, the leaves come last
    std::vector<std::uint32_t> slot_of_, leaf_of_;
};

inline BoundingBox AabbTree::Node::box() const {
    BoundingBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lowest[axis] = lowest_[static_cast<std::size_t>(axis)].load(std::memory_order_relaxed);
        box.highest[axis] = highest_[static_cast<std::size_t>(axis)].load(std::memory_order_relaxed);
    }
    return box;
}

} // namespace meshbound
