#include "geometry/aabb_tree.hpp"

#include <algorithm>
#include <bit>
#include <functional>

#include "geometry/longest_side.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

/// Atomically replaces a number by another one where that is `better`.
template <class Better>
void replace_if(std::atomic<double>& number, double value, Better better) {
    double before = number.load(std::memory_order_relaxed);
    while (better(value, before) && !number.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
    }
}

} // namespace

void AabbTree::Node::set(const BoundingBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
        lowest_[static_cast<std::size_t>(axis)].store(box.lowest[axis], std::memory_order_relaxed);
        highest_[static_cast<std::size_t>(axis)].store(box.highest[axis], std::memory_order_relaxed);
    }
}

void AabbTree::Node::grow(const BoundingBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
        replace_if(lowest_[static_cast<std::size_t>(axis)], box.lowest[axis], std::less<>());
        replace_if(highest_[static_cast<std::size_t>(axis)], box.highest[axis], std::greater<>());
    }
}

void AabbTree::build(std::vector<Item> items, std::size_t slots) {
    leaves_ = items.empty() ? 0 : std::bit_ceil(items.size());
    nodes_ = std::vector<Node>(2 * leaves_);
    slot_of_.assign(leaves_, no_index);
    leaf_of_.assign(slots, no_index);
    if (leaves_ > 0) build(1, items.begin(), items.end());
}

/// Splits at the median along the longest side of the box of the centres.
BoundingBox AabbTree::build(std::size_t node, Items first, Items last) {
    BoundingBox box;
    if (node >= leaves_) {
        if (first != last) {
            box = first->box;
            slot_of_[node - leaves_] = first->slot;
            leaf_of_[first->slot] = static_cast<std::uint32_t>(node - leaves_);
        }
    } else {
        BoundingBox centres; // times two
        for (auto item = first; item != last; ++item) centres.include(item->box.lowest + item->box.highest);
        const glm::dvec3 side = centres.highest - centres.lowest;
        const int axis = longest_side(side);
        const Items middle = first + (last - first + 1) / 2;
        if (middle != last)
            std::nth_element(first, middle, last, [axis](const Item& one, const Item& other) {
                return one.box.lowest[axis] + one.box.highest[axis] < other.box.lowest[axis] + other.box.highest[axis];
            });
        const BoundingBox left = build(2 * node, first, middle), right = build(2 * node + 1, middle, last);
        box.lowest = glm::min(left.lowest, right.lowest);
        box.highest = glm::max(left.highest, right.highest);
    }
    nodes_[node].set(box);
    return box;
}

/// From the root down, so that a concurrent query finds each box within its parent.
void AabbTree::update(std::uint32_t slot, const BoundingBox& box) {
    const std::size_t leaf = leaves_ + leaf_of_[slot];
    for (int level = std::bit_width(leaf) - 1; level > 0; --level) nodes_[leaf >> level].grow(box);
    nodes_[leaf].set(box);
}

} // namespace meshbound
