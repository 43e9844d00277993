// The nearest points of two triangles against a search over both.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "geometry/triangle_distance.hpp"
#include "meshes/random.hpp"

namespace {

using namespace meshbound;

glm::dvec3 random_point(meshes::Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TrianglePoints random_triangle(meshes::Random& random, const glm::dvec3& offset) {
    return {random_point(random) + offset, random_point(random) + offset, random_point(random) + offset};
}

/// The point of a triangle (its area or, where it has none, its edges) that is nearest to p: by projecting onto everything that
/// it consists of.
glm::dvec3 nearest_on(const TrianglePoints& t, const glm::dvec3& p) {
    glm::dvec3 best = t[0];
    const auto consider = [&](const glm::dvec3& q) {
        if (glm::length(q - p) < glm::length(best - p)) best = q;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &a = t[i], along = t[(i + 1) % 3] - a;
        const double square = glm::dot(along, along);
        consider(square > 0 ? a + std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) * along : a);
    }
    const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), determinant = uu * vv - uv * uv;
    if (!(determinant > 0)) return best;
    const double x = (glm::dot(w, u) * vv - glm::dot(w, v) * uv) / determinant;
    const double y = (glm::dot(w, v) * uu - glm::dot(w, u) * uv) / determinant;
    if (x >= 0 && y >= 0 && x + y <= 1) consider(t[0] + x * u + y * v);
    return best;
}

/// How near the search below comes: it creeps where two edges are nearly parallel.
constexpr double search_accuracy = 1e-5;

/// Two convex sets: going from one to the nearest point of the other and back ends at the nearest points of both.
double distance_by_search(const TrianglePoints& one, const TrianglePoints& other) {
    glm::dvec3 p = (one[0] + one[1] + one[2]) / 3.0, q = nearest_on(other, p);
    double best = glm::length(p - q);
    for (int round = 0; round < 20000; ++round) {
        p = nearest_on(one, q);
        q = nearest_on(other, p);
        const double here = glm::length(p - q);
        if (!(here < best)) break;
        best = here;
    }
    return best;
}

/// The part of a triangle that some of its corners span, as a triangle.
TrianglePoints part(const TrianglePoints& t, unsigned corners) {
    std::vector<glm::dvec3> points;
    for (unsigned i = 0; i < 3; ++i)
        if (corners >> i & 1) points.push_back(t[i]);
    const glm::dvec3 first = points.at(0);
    points.resize(3, first);
    return {points[0], points[1], points[2]};
}

/// The parts that are named have the distance of the whole, and no smaller parts do.
void expect_smallest_parts(const TrianglePoints& one, const TrianglePoints& other, const NearestPoints& nearest) {
    const double distance = std::sqrt(nearest.squared_distance);
    ASSERT_NEAR(distance_by_search(part(one, nearest.one), part(other, nearest.other)), distance, search_accuracy);
    for (unsigned i = 0; i < 3; ++i) {
        const unsigned fewer = nearest.one & ~(1U << i), fewer_there = nearest.other & ~(1U << i);
        if (fewer != nearest.one && fewer != 0) {
            ASSERT_GT(distance_by_search(part(one, fewer), part(other, nearest.other)), distance);
        }
        if (fewer_there != nearest.other && fewer_there != 0) {
            ASSERT_GT(distance_by_search(part(one, nearest.one), part(other, fewer_there)), distance);
        }
    }
}

void expect_right(const TrianglePoints& one, const TrianglePoints& other) {
    const NearestPoints nearest = nearest_points(one, other);
    const double searched = distance_by_search(one, other), distance = std::sqrt(nearest.squared_distance);
    ASSERT_NEAR(distance, searched, search_accuracy);
    ASSERT_LE(distance, searched + 1e-12); // the search comes from above
    const NearestPoints back = nearest_points(other, one);
    ASSERT_NEAR(back.squared_distance, nearest.squared_distance, 1e-12);
}

TEST(TriangleDistance, IsThatOfASearchForTrianglesApart) {
    meshes::Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const TrianglePoints one = random_triangle(random, {0, 0, 0}), other = random_triangle(random, {2.2, 0.3, 0});
        expect_right(one, other);
        expect_smallest_parts(one, other, nearest_points(one, other));
    }
}

/// Where a corner is nearest to a face: stacked upon each other.
TEST(TriangleDistance, IsThatOfASearchForTrianglesAboveOneAnother) {
    meshes::Random random(2);
    int faces = 0;
    for (int i = 0; i < 2000; ++i) {
        TrianglePoints one = random_triangle(random, {0, 0, 0}), other = random_triangle(random, {0, 0, 0});
        for (glm::dvec3& p : one) p.z *= 0.1;
        for (glm::dvec3& p : other) p.z = 0.3 + 0.1 * p.z;
        expect_right(one, other);
        const NearestPoints nearest = nearest_points(one, other);
        faces += nearest.one == 7 || nearest.other == 7;
        expect_smallest_parts(one, other, nearest);
    }
    EXPECT_GT(faces, 200);
}

TEST(TriangleDistance, IsThatOfASearchForTrianglesWithoutArea) {
    meshes::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        TrianglePoints one = random_triangle(random, {0, 0, 0}), other = random_triangle(random, {2.2, 0, 0});
        one[2] = i % 2 == 0 ? one[1] : 0.5 * (one[0] + one[1]);
        if (i % 3 == 0) one[1] = one[2] = one[0];
        if (i % 5 == 0) other[1] = other[2];
        expect_right(one, other);
    }
}

TEST(TriangleDistance, IsZeroAtACommonCorner) {
    meshes::Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const TrianglePoints one = random_triangle(random, {0, 0, 0});
        TrianglePoints other = random_triangle(random, {3, 0, 0});
        other[1] = one[2];
        const NearestPoints nearest = nearest_points(one, other);
        ASSERT_EQ(nearest.squared_distance, 0);
        ASSERT_TRUE(nearest.one >> 2 & 1);
        ASSERT_TRUE(nearest.other >> 1 & 1);
    }
}

TEST(TriangleDistance, NamesWhatIsNearest) {
    const TrianglePoints flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
    const NearestPoints over_face = nearest_points(flat, {{{1, 1, 2}, {1, 1, 5}, {2, 1, 5}}});
    EXPECT_DOUBLE_EQ(over_face.squared_distance, 4);
    EXPECT_EQ(over_face.one, 7U);
    EXPECT_EQ(over_face.other, 1U);
    const NearestPoints beside_edge = nearest_points(flat, {{{2, -3, 0}, {1, -6, 1}, {3, -6, -1}}});
    EXPECT_DOUBLE_EQ(beside_edge.squared_distance, 9);
    EXPECT_EQ(beside_edge.one, 3U);
    EXPECT_EQ(beside_edge.other, 1U);
    const NearestPoints at_corners = nearest_points(flat, {{{-9, 0, 1}, {-9, -3, 1}, {-1, -1, 1}}});
    EXPECT_DOUBLE_EQ(at_corners.squared_distance, 3);
    EXPECT_EQ(at_corners.one, 1U);
    EXPECT_EQ(at_corners.other, 4U);
    const NearestPoints across = nearest_points(flat, {{{2, -1, -1}, {2, -1, 1}, {2, -5, 0}}});
    EXPECT_DOUBLE_EQ(across.squared_distance, 1);
    EXPECT_EQ(across.one, 3U);
    EXPECT_EQ(across.other, 3U);
}

} // namespace
