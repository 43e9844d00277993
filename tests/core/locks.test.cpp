// What is locked does not change: vertices, and all that meets a box.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;
using Corners = std::array<std::uint32_t, 3>;

class Locks : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, std::vector<Box> boxes) const {
        Options options = GetParam().options();
        options.locked_boxes = std::move(boxes);
        return guarantee::reduced(mesh, guarantee::percent(3, 10), options);
    }
};
EVERY_MODE(Locks);

/// Corners in the order of the triangle, from the smallest on.
Corners turned(Corners t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

/// The triangles of the result by the vertices of the input.
std::set<Corners> triangles_left(const Reduction& reduction) {
    std::set<Corners> found;
    const auto& v = reduction.vertices;
    for (const glm::uvec3& t : reduction.mesh.triangles) found.insert(turned({v[t.x], v[t.y], v[t.z]}));
    return found;
}

/// Whether any of many points of a triangle lies in a box.
bool reaches(const Mesh& mesh, const glm::uvec3& t, const Box& box) {
    constexpr int steps = 12;
    const glm::dvec3 a = meshes::point(mesh, t.x), b = meshes::point(mesh, t.y), c = meshes::point(mesh, t.z);
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) {
            const glm::dvec3 p = a + (b - a) * (i / double(steps)) + (c - a) * (j / double(steps));
            bool within = true;
            for (int axis = 0; axis < 3; ++axis)
                within = within && box.lowest[axis] <= p[axis] && p[axis] <= box.highest[axis];
            if (within) return true;
        }
    return false;
}

TEST_P(Locks, EveryTriangleThatReachesIntoABoxStaysAsItIs) {
    const Box corner{{0.5, -2, -2}, {2, 2, 2}};
    const Box within_a_triangle{{-0.01, -0.01, -2}, {0.01, 0.01, 2}}; // smaller than any
    for (Mesh mesh : {meshes::noisy_sphere(10, 0.03, 5), meshes::jittered(meshes::plane(12, 12), 0.02, 4),
                      meshes::cylinder(30, 6)}) {
        meshes::add_usual_fields(mesh);
        const Reduction reduction = reduce(mesh, {corner, within_a_triangle});
        const std::set<Corners> left = triangles_left(reduction);
        std::size_t locked = 0;
        for (const glm::uvec3& t : mesh.triangles) {
            if (!reaches(mesh, t, corner) && !reaches(mesh, t, within_a_triangle)) continue;
            ++locked;
            EXPECT_TRUE(left.count(turned({t.x, t.y, t.z}))) << t.x << " " << t.y << " " << t.z;
        }
        EXPECT_GT(locked, 0U);
        EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() * 9 / 10) << "elsewhere it is reduced";
        guarantee::expect_everything(mesh, reduction, 5'000);
    }
}

TEST_P(Locks, ABoxBesideTheSurfaceLocksNothing) {
    Mesh mesh = meshes::plane(8, 8);
    const Reduction reduction = reduce(mesh, {{{0, 0, 0.001}, {1, 1, 1}}});
    EXPECT_EQ(reduction.mesh.triangles.size(), 2U);
    EXPECT_EQ(reduction.report.refused.locked, 0U);
}

TEST_P(Locks, TheReportNamesTheBoxesThatMeetNoTriangle) {
    const Mesh mesh = meshes::plane(8, 8);
    const Box beside{{0, 0, 0.001}, {1, 1, 1}}, away{{5, 5, 5}, {6, 6, 6}}, touching{{-1, -1, -1}, {0, 0, 0}};
    EXPECT_TRUE(reduce(mesh, {}).report.unused_locked_boxes.empty());
    EXPECT_EQ(reduce(mesh, {beside, touching, away}).report.unused_locked_boxes, (std::vector<std::size_t>{0, 2}));

    LevelOptions options{GetParam().options()};
    options.reduction.locked_boxes = {touching, away};
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, {guarantee::percent(1, 1), guarantee::percent(3, 3)}, options, levels).ok());
    for (const Reduction& level : levels.levels)
        EXPECT_EQ(level.report.unused_locked_boxes, std::vector<std::size_t>{1}) << "though nothing is left to lock";
}

TEST_P(Locks, ABoxAroundEverythingLocksEverything) {
    Mesh mesh = meshes::sphere(6);
    constexpr double far = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(guarantee::same_bits(reduce(mesh, {{glm::dvec3(-far), glm::dvec3(far)}}).mesh, mesh));
}

TEST_P(Locks, ABoxTurnedInsideOutIsRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Box& bad : {Box{{0, 1, 0}, {1, 0.5, 1}}, Box{{0, 0, nan}, {1, 1, 1}}}) {
        Options options = GetParam().options();
        options.locked_boxes = {{{0, 0, 0}, {1, 1, 1}}, bad};
        Reduction reduction;
        const Status status = meshbound::reduce(meshes::plane(2, 2), guarantee::percent(1, 1), options, reduction);
        EXPECT_EQ(status.fault, Fault::bad_option);
        EXPECT_EQ(status.index, 1U);
    }
}

} // namespace
