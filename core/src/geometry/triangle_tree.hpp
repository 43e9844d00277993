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

/// A box along the axes; empty at first.
struct BoundingBox {
    glm::dvec3 lowest{std::numeric_limits<double>::infinity()}, highest{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& p) {
        lowest = glm::min(lowest, p);
        highest = glm::max(highest, p);
    }
    /// Without branches, which could not be foretold.
    bool meets(const BoundingBox& other) const {
        return static_cast<bool>((int{lowest.x <= other.highest.x} & int{other.lowest.x <= highest.x}) &
                                 (int{lowest.y <= other.highest.y} & int{other.lowest.y <= highest.y}) &
                                 (int{lowest.z <= other.highest.z} & int{other.lowest.z <= highest.z}));
    }
};

/// Which triangles lie near a place: a binary tree of boxes over the slots of a surface, which keeps its shape while the
/// triangles in the slots change. A slot's box is exactly its triangle's; the boxes above it hold it, and only grow, until
/// the tree is built anew.
///
/// Threads may change slots and look at once. What one of them finds of slots that another changes meanwhile is chance, but
/// such a slot is found only where a box around its old and its new triangle meets the box that is asked for.
class TriangleTree {
public:
    struct Item {
        std::uint32_t slot;
        BoundingBox box;
    };

    /// Builds the tree over these slots, all of them less than `slots`.
    void build(std::vector<Item> items, std::size_t slots);

    /// Gives one of the slots that the tree was built over another box. An empty box is never found.
    void change(std::uint32_t slot, const BoundingBox& box);

    /// Whether `test(slot)` holds for one of the slots whose boxes meet the given one, which is finite; asks no more of them
    /// than need be.
    template <class Test>
    bool any(const BoundingBox& box, Test test) const {
        std::array<std::size_t, 2 * std::numeric_limits<std::size_t>::digits> waiting;
        std::size_t count = 0;
        if (leaves_ > 0) waiting[count++] = 1;
        while (count > 0) {
            const std::size_t node = waiting[--count];
            if (!nodes_[node].box().meets(box)) continue;
            if (node >= leaves_) {
                if (test(slot_of_[node - leaves_])) return true;
                continue;
            }
            waiting[count++] = 2 * node;
            waiting[count++] = 2 * node + 1;
        }
        return false;
    }

private:
    /// A box that threads may read while another changes it: each number by itself is whole.
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

inline BoundingBox TriangleTree::Node::box() const {
    BoundingBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lowest[axis] = lowest_[static_cast<std::size_t>(axis)].load(std::memory_order_relaxed);
        box.highest[axis] = highest_[static_cast<std::size_t>(axis)].load(std::memory_order_relaxed);
    }
    return box;
}

} // namespace meshbound
