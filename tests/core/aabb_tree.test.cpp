// The tree of triangles against looking at every box, while the triangles change as a reduction changes them.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/aabb_tree.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "surface/hole.hpp"
#include "surface/surface.hpp"

namespace {

using namespace meshbound;

using Slots = std::vector<std::uint32_t>;

/// Looked at one by one.
class AllBoxes {
public:
    explicit AllBoxes(std::size_t slots) : boxes_(slots) {}
    void change(std::uint32_t slot, const BoundingBox& box) { boxes_[slot] = box; }
    const BoundingBox& operator[](std::uint32_t slot) const { return boxes_[slot]; }
    Slots meeting(const BoundingBox& box) const {
        Slots found;
        for (std::uint32_t slot = 0; slot < boxes_.size(); ++slot)
            if (meet(boxes_[slot], box)) found.push_back(slot);
        return found;
    }

private:
    static bool meet(const BoundingBox& one, const BoundingBox& other) {
        for (int axis = 0; axis < 3; ++axis)
            if (one.lowest[axis] > other.highest[axis] || other.lowest[axis] > one.highest[axis]) return false;
        return true;
    }
    std::vector<BoundingBox> boxes_;
};

/// Rising; a slot that is found twice stands there twice.
Slots found(const AabbTree& tree, const BoundingBox& box) {
    Slots slots;
    EXPECT_FALSE(tree.any_overlapping(box, [&](std::uint32_t slot) {
        slots.push_back(slot);
        return false;
    }));
    std::sort(slots.begin(), slots.end());
    return slots;
}

BoundingBox random_box(meshes::Random& random, double size) {
    BoundingBox box;
    const glm::dvec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    box.include(p);
    box.include(p + glm::dvec3(random.uniform(0, size), random.uniform(0, size), random.uniform(0, size)));
    return box;
}

std::vector<AabbTree::Item> items_of(const AllBoxes& boxes, const Slots& slots) {
    std::vector<AabbTree::Item> items;
    for (const std::uint32_t slot : slots) items.push_back({slot, boxes[slot]});
    return items;
}

void expect_same(const AabbTree& tree, const AllBoxes& boxes, meshes::Random& random, int questions) {
    for (int i = 0; i < questions; ++i) {
        const BoundingBox box = random_box(random, i % 2 == 0 ? 0.3 : 0.02);
        ASSERT_EQ(found(tree, box), boxes.meeting(box));
    }
}

TEST(AabbTree, WithoutTrianglesFindsNothing) {
    AabbTree tree;
    meshes::Random random(1);
    EXPECT_TRUE(found(tree, random_box(random, 5)).empty());
    tree.build({}, 7);
    EXPECT_TRUE(found(tree, random_box(random, 5)).empty());
}

/// Around the powers of two, to which the leaves are rounded up.
TEST(AabbTree, FindsWhatABoxMeetsWhateverTheNumberOfTriangles) {
    meshes::Random random(2);
    for (const std::size_t count : {1, 2, 3, 4, 5, 7, 8, 9, 31, 32, 33, 100, 1000}) {
        SCOPED_TRACE(count);
        AllBoxes boxes(2 * count);
        Slots slots; // every other one
        for (std::uint32_t slot = 1; slot < 2 * count; slot += 2) {
            boxes.change(slot, random_box(random, 0.2));
            slots.push_back(slot);
        }
        AabbTree tree;
        tree.build(items_of(boxes, slots), 2 * count);
        expect_same(tree, boxes, random, 100);
    }
}

TEST(AabbTree, FindsBoxesThatTouch) {
    const BoundingBox left{{0, 0, 0}, {1, 1, 1}}, right{{1, 0, 0}, {2, 1, 1}}, point{{1, 0.5, 1}, {1, 0.5, 1}};
    AabbTree tree;
    tree.build({{0, left}, {1, right}}, 2);
    EXPECT_EQ(found(tree, point), (Slots{0, 1}));
    EXPECT_EQ(found(tree, {{2, 1, 1}, {3, 3, 3}}), (Slots{1}));
    EXPECT_TRUE(found(tree, {{2.0000001, 1, 1}, {3, 3, 3}}).empty());
}

TEST(AabbTree, FindsAllOfManyInOnePlace) {
    AllBoxes boxes(50);
    Slots slots;
    for (std::uint32_t slot = 0; slot < 50; ++slot) {
        boxes.change(slot, {{0, 0, 0}, {0, 0, 0}});
        slots.push_back(slot);
    }
    AabbTree tree;
    tree.build(items_of(boxes, slots), 50);
    EXPECT_EQ(found(tree, {{-1, -1, -1}, {0, 0, 0}}), slots);
    EXPECT_TRUE(found(tree, {{-1, -1, -1}, {-0.1, 0, 0}}).empty());
}

TEST(AabbTree, StopsAtTheFirstThatPassesTheTest) {
    AabbTree tree;
    const BoundingBox everywhere{{0, 0, 0}, {1, 1, 1}};
    tree.build({{0, everywhere}, {1, everywhere}, {2, everywhere}}, 3);
    int asked = 0;
    EXPECT_TRUE(tree.any_overlapping(everywhere, [&](std::uint32_t) { return ++asked == 2; }));
    EXPECT_EQ(asked, 2);
}

TEST(AabbTree, FindsTheSameAfterManyChanges) {
    meshes::Random random(3);
    constexpr std::uint32_t count = 300;
    AllBoxes boxes(count);
    Slots slots;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        boxes.change(slot, random_box(random, 0.1));
        slots.push_back(slot);
    }
    AabbTree tree;
    tree.build(items_of(boxes, slots), count);
    for (int round = 0; round < 100; ++round) {
        for (int i = 0; i < 30; ++i) { // smaller, larger, elsewhere, gone and there again
            const auto slot = static_cast<std::uint32_t>(random.below(count));
            const BoundingBox box = random.below(4) == 0 ? BoundingBox{} : random_box(random, 0.3);
            boxes.change(slot, box);
            tree.update(slot, box);
        }
        expect_same(tree, boxes, random, 20);
    }
    tree.build(items_of(boxes, slots), count); // and anew, the gone ones among them
    expect_same(tree, boxes, random, 100);
}

/// A surface that loses one vertex after the other: the triangles of each hole take some of the slots of the star.
class Shrinking {
public:
    explicit Shrinking(const Mesh& mesh)
        : mesh_(mesh), surface_(mesh.triangles, vertex_count(mesh)), boxes_(surface_.slot_count()) {
        for (std::uint32_t slot = 0; slot < surface_.slot_count(); ++slot) boxes_.change(slot, box_of(slot));
    }
    const AllBoxes& boxes() const { return boxes_; }
    Slots slots() const {
        Slots alive;
        for (std::uint32_t slot = 0; slot < surface_.slot_count(); ++slot)
            if (surface_.alive(slot)) alive.push_back(slot);
        return alive;
    }
    /// Fills a hole by the fan of its first corner.
    void remove(std::uint32_t vertex, AabbTree& tree) {
        Hole hole;
        gather_star(surface_, vertex, hole);
        if (!can_be_filled(hole)) return;
        Retriangulation fan;
        for (int b = hole.size() - 1; b > 1; --b) {
            NewTriangle triangle{0, b - 1, b};
            triangle.parent = static_cast<int>(fan.triangles.size()) - 1;
            if (b > 2) triangle.left = static_cast<int>(fan.triangles.size()) + 1;
            fan.triangles.push_back(triangle);
        }
        surface_.retriangulate(hole, fan);
        for (const std::uint32_t slot : hole.slots) {
            const BoundingBox box = surface_.alive(slot) ? box_of(slot) : BoundingBox{};
            boxes_.change(slot, box);
            tree.update(slot, box);
        }
    }

private:
    /// Whether none of the fan's edges, the closing edge of an open hole among them, exists yet.
    bool can_be_filled(const Hole& hole) const {
        if (hole.size() < 4 || hole.size() > largest_ring) return false;
        const std::uint32_t hub = hole.ring[0];
        const int end_of_edges =
            hole.open ? hole.size() : hole.size() - 1; // where the rim begins that leads back to the hub
        for (int b = 2; b < end_of_edges; ++b) {
            const std::uint32_t end = hole.ring[static_cast<std::size_t>(b)];
            if (!surface_.all_of_ring(hub, [&](std::uint32_t neighbour) { return neighbour != end; })) return false;
        }
        return true;
    }
    BoundingBox box_of(std::uint32_t slot) const {
        BoundingBox box;
        for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h) box.include(meshes::point(mesh_, surface_.origin(h)));
        return box;
    }

    const Mesh& mesh_;
    Surface surface_;
    AllBoxes boxes_;
};

TEST(AabbTree, FindsTheSameAllTheWayOfAReduction) {
    const Mesh mesh = meshes::terrain(5, 4);
    Shrinking surface(mesh);
    AabbTree tree;
    tree.build(items_of(surface.boxes(), surface.slots()), 2 * mesh.triangles.size());
    meshes::Random random(4);
    const std::size_t before = surface.slots().size();
    for (std::uint32_t vertex = 0; vertex < vertex_count(mesh); ++vertex) {
        if (random.below(4) == 0) continue;
        surface.remove(vertex, tree);
        if (vertex % 16 == 0) expect_same(tree, surface.boxes(), random, 10);
    }
    EXPECT_LT(surface.slots().size(), before / 2);
    expect_same(tree, surface.boxes(), random, 100);
    AabbTree anew;
    anew.build(items_of(surface.boxes(), surface.slots()), before);
    expect_same(anew, surface.boxes(), random, 100);
}

/// The boxes above a slot only grow, so that a slot that stands still is found at any time, whatever moves beside it.
TEST(AabbTree, NeverLosesASlotThatStandsStillWhileOthersMove) {
    meshes::Random random(5);
    constexpr std::uint32_t count = 64;
    AllBoxes still(count);
    std::vector<AabbTree::Item> items;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        const BoundingBox box = random_box(random, 0.1);
        if (slot % 2 == 0) still.change(slot, box);
        items.push_back({slot, box});
    }
    AabbTree tree;
    tree.build(items, count);
    std::atomic<bool> done{false};
    std::atomic<int> changes{0};
    std::thread mover([&] {
        meshes::Random random_there(6);
        while (!done) {
            const auto slot = static_cast<std::uint32_t>(2 * random_there.below(count / 2) + 1);
            tree.update(slot, random_there.below(3) == 0 ? BoundingBox{} : random_box(random_there, 0.5));
            ++changes;
        }
    });
    while (changes == 0) std::this_thread::yield();
    for (int i = 0; i < 20000; ++i) {
        const BoundingBox box = random_box(random, 0.2);
        const Slots expected = still.meeting(box), seen = found(tree, box);
        EXPECT_TRUE(std::includes(seen.begin(), seen.end(), expected.begin(), expected.end())) << i;
    }
    done = true;
    mover.join();
}

} // namespace
