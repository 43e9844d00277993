// Whether two triangles pierce or touch each other, against CGAL's exact answer, on whole numbers, where most contacts are
// degenerate, and at random.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "geometry/point_ids.hpp"
#include "geometry/triangle_intersection.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "self_intersection/self_intersections.hpp"

namespace {

using namespace meshbound;

/// Six points: the corners of two triangles. Those at one place are one corner.
using Two = std::vector<glm::dvec3>;

SpatialTriangle placed(const Two& points, std::uint32_t first) {
    const std::vector<std::uint32_t> ids = point_ids(points);
    return {{ids[first], ids[first + 1], ids[first + 2]}, {points[first], points[first + 1], points[first + 2]}};
}

bool judged(const Two& points) {
    const Mesh mesh = meshes::from_points(points, {{0, 1, 2}, {3, 4, 5}});
    return !judge::soup_intersections(mesh, [](std::size_t, std::size_t) { return true; }).empty();
}

bool has_area(const Two& points, std::size_t first) {
    return glm::cross(points[first + 1] - points[first], points[first + 2] - points[first]) != glm::dvec3(0);
}

void expect_right(const Two& points) {
    const bool expected = judged(points);
    SpatialTriangle one = placed(points, 0), other = placed(points, 3);
    for (int turn = 0; turn < 3; ++turn) { // whatever the order of triangles and corners
        ASSERT_EQ(intersect_beyond_shared(one, other), expected);
        ASSERT_EQ(intersect_beyond_shared(other, one), expected);
        std::rotate(one.ids.begin(), one.ids.begin() + 1, one.ids.end());
        std::rotate(one.points.begin(), one.points.begin() + 1, one.points.end());
        std::swap(other.ids[0], other.ids[1]);
        std::swap(other.points[0], other.points[1]);
    }
}

/// Calls `look(points)` with pairs of triangles that have areas, on whole numbers up to `most`; z up to `height`.
template <class Look>
void for_whole_numbers(std::uint64_t seed, std::size_t most, std::size_t height, int count, const Look& look) {
    meshes::Random random(seed);
    while (count > 0) {
        Two points;
        for (int i = 0; i < 6; ++i)
            points.emplace_back(static_cast<double>(random.below(most + 1)),
                                static_cast<double>(random.below(most + 1)),
                                static_cast<double>(random.below(height + 1)));
        if (!has_area(points, 0) || !has_area(points, 3)) continue;
        --count;
        look(points);
    }
}

TEST(TriangleContact, IsRightOfTrianglesAtRandom) {
    meshes::Random random(1);
    int contacts = 0;
    for (int i = 0; i < 5000; ++i) {
        Two points;
        for (int n = 0; n < 6; ++n)
            points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        expect_right(points);
        contacts += judged(points);
    }
    EXPECT_GT(contacts, 500);
}

/// Touching, crossing and lying on each other, with none to three corners in common.
TEST(TriangleContact, IsRightOfTrianglesOnWholeNumbers) {
    std::array<std::array<int, 2>, 4> seen{}; // by corners in common, by contact
    for_whole_numbers(2, 2, 2, 20000, [&](const Two& points) {
        expect_right(points);
        std::size_t common = 0;
        for (std::size_t i = 0; i < 3; ++i) common += std::count(points.begin() + 3, points.end(), points[i]) > 0;
        ++seen[common][judged(points)];
    });
    for (std::size_t common = 0; common < 3; ++common)
        for (const int count : seen[common]) EXPECT_GT(count, 20) << common;
    EXPECT_EQ(seen[3][0], 0); // two triangles on the same corners lie on each other
    EXPECT_GT(seen[3][1], 0);
}

TEST(TriangleContact, IsRightOfTrianglesInOnePlane) {
    int contacts = 0;
    for_whole_numbers(3, 4, 0, 10000, [&](const Two& points) {
        expect_right(points);
        contacts += judged(points);
    });
    EXPECT_GT(contacts, 1000);
    EXPECT_LT(contacts, 9900);
}

/// The same contacts in a plane that is not along an axis: whole numbers, so that they stay exact.
TEST(TriangleContact, IsRightOfTrianglesInOneSlantingPlane) {
    for_whole_numbers(4, 4, 0, 10000, [&](Two points) {
        for (glm::dvec3& p : points) p = {p.x + 2 * p.y, 3 * p.x - p.y, p.x + p.y};
        expect_right(points);
    });
}

/// A corner that rounding puts next to the other triangle, on one side or the other.
TEST(TriangleContact, IsRightWhereACornerAllButTouches) {
    meshes::Random random(5);
    int contacts = 0;
    for (int i = 0; i < 5000; ++i) {
        Two points;
        for (int n = 0; n < 3; ++n)
            points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const double u = random.uniform(0, 0.5), v = random.uniform(0, 0.5);
        const glm::dvec3 touching = points[0] + u * (points[1] - points[0]) + v * (points[2] - points[0]);
        const glm::dvec3 away = glm::cross(points[1] - points[0], points[2] - points[0]);
        points.push_back(touching);
        points.push_back(touching + away + 0.1 * (points[1] - points[0]));
        points.push_back(touching + away);
        expect_right(points);
        contacts += judged(points);
    }
    EXPECT_GT(contacts, 1000);
    EXPECT_LT(contacts, 4500);
}

/// A triangle without area may see a contact that there is not, never miss one of its edges with a triangle that has an area.
TEST(TriangleContact, MissesNoEdgeOfATriangleWithoutArea) {
    meshes::Random random(6);
    int contacts = 0;
    for (int i = 0; i < 5000; ++i) {
        Two points;
        for (int n = 0; n < 5; ++n)
            points.emplace_back(static_cast<double>(random.below(5)), static_cast<double>(random.below(5)),
                                static_cast<double>(random.below(5)));
        points.push_back(2.0 * points[4] - points[3]); // on one line
        const bool middle_in_common =
            std::count(points.begin(), points.begin() + 3, points[4]) > 0; // as it cannot be below
        if (!has_area(points, 0) || points[3] == points[4] || middle_in_common) continue;
        // The line from 3 by 4 to 5, as a triangle with a corner off it, so thin that it meets nothing else.
        const bool meets_edge = [&] {
            Two thin = points;
            for (const int axis : {0, 1, 2})
                for (const double by : {-1e-9, 1e-9}) {
                    thin[4] = points[4];
                    thin[4][axis] += by;
                    if (has_area(thin, 3) && !judged(thin)) return false;
                }
            return true;
        }();
        if (!meets_edge) continue;
        ++contacts;
        ASSERT_TRUE(intersect_beyond_shared(placed(points, 0), placed(points, 3)));
        ASSERT_TRUE(intersect_beyond_shared(placed(points, 3), placed(points, 0)));
    }
    EXPECT_GT(contacts, 100);
}

} // namespace
