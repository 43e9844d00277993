// The tree of boxes finds what looking at every box finds, also after many of them have changed.

#include "triangle_tree.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "meshes/random.hpp"

namespace {

using namespace meshbound;

BoundingBox some_box(meshes::Random& random) {
    BoundingBox box;
    const glm::dvec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double size = random.below(10) == 0 ? 0 : random.uniform(0, random.below(10) == 0 ? 1.0 : 0.1);
    box.include(at);
    box.include(at + glm::dvec3(random.uniform(0, size), random.uniform(0, size), random.uniform(0, size)));
    return box;
}

class Boxes {
public:
    Boxes(meshes::Random& random, std::size_t slots) : boxes_(slots), present_(slots, false) {
        std::vector<TriangleTree::Item> items;
        for (std::uint32_t slot = 0; slot < slots; ++slot) {
            if (random.below(4) == 0) continue; // not every slot has a triangle
            boxes_[slot] = some_box(random);
            present_[slot] = true;
            items.push_back({slot, boxes_[slot]});
        }
        tree_.build(items, slots);
    }

    void change(std::uint32_t slot, const BoundingBox& box) {
        if (!present_[slot]) return;
        boxes_[slot] = box;
        tree_.change(slot, box);
    }

    void expect_found(const BoundingBox& box) const {
        std::set<std::uint32_t> expected, found;
        for (std::uint32_t slot = 0; slot < boxes_.size(); ++slot)
            if (present_[slot] && boxes_[slot].meets(box)) expected.insert(slot);
        tree_.any(box, [&](std::uint32_t slot) {
            EXPECT_TRUE(found.insert(slot).second) << "slot " << slot << " twice";
            return false;
        });
        EXPECT_EQ(found, expected);
    }

    const TriangleTree& tree() const { return tree_; }

private:
    TriangleTree tree_;
    std::vector<BoundingBox> boxes_;
    std::vector<bool> present_;
};

TEST(TriangleTree, FindsEveryBoxThatMeetsAnother) {
    for (const std::size_t slots : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{17},
                                    std::size_t{64}, std::size_t{500}}) {
        meshes::Random random(slots + 1);
        const Boxes boxes(random, slots);
        for (int i = 0; i < 200; ++i) boxes.expect_found(some_box(random));
    }
}

TEST(TriangleTree, FollowsManyChanges) {
    meshes::Random random(9);
    Boxes boxes(random, 300);
    for (int round = 0; round < 50; ++round) {
        for (int i = 0; i < 40; ++i) {
            const auto slot = static_cast<std::uint32_t>(random.below(300));
            boxes.change(slot,
                         random.below(5) == 0 ? BoundingBox{} : some_box(random)); // an empty one: it has vanished
        }
        for (int i = 0; i < 10; ++i) boxes.expect_found(some_box(random));
    }
}

TEST(TriangleTree, StopsAtTheFirstThatPasses) {
    meshes::Random random(4);
    const Boxes boxes(random, 200);
    BoundingBox all;
    all.include(glm::dvec3(-3));
    all.include(glm::dvec3(3));
    int asked = 0;
    EXPECT_TRUE(boxes.tree().any(all, [&](std::uint32_t) { return ++asked == 5; }));
    EXPECT_EQ(asked, 5);
    EXPECT_FALSE(boxes.tree().any(all, [](std::uint32_t) { return false; }));
}

} // namespace
