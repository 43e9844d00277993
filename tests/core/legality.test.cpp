// Which retriangulations keep a surface a surface, rule by rule: a hole where something is refused, and the same hole with the
// least change that allows it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "holes.hpp"
#include "retriangulation/ring_triangle.hpp"

namespace {

using namespace meshbound;
using holes::Star;

using Points = std::vector<glm::dvec3>;
using Triangles = std::vector<glm::uvec3>;

template <class T>
std::vector<T> operator+(std::vector<T> all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// The ring positions of some vertices of the mesh, rising.
template <std::size_t N>
std::array<int, N> positions(const Star& star, const std::uint32_t (&vertices)[N]) {
    std::array<int, N> found{};
    for (std::size_t n = 0; n < N; ++n) found[n] = star.position(vertices[n]);
    std::sort(found.begin(), found.end());
    EXPECT_GE(found[0], 0);
    return found;
}

bool allows_edge(const Star& star, std::uint32_t v, std::uint32_t w) {
    const auto [i, j] = positions(star, {v, w});
    return star.legality.allows_edge(i, j);
}

bool is_ccw_in_layout(const Star& star, std::uint32_t u, std::uint32_t v, std::uint32_t w) {
    const auto [a, m, b] = positions(star, {u, v, w});
    return star.legality.is_ccw_in_layout(a, m, b);
}

RingTriangle triangle_of(const Star& star, std::uint32_t u, std::uint32_t v, std::uint32_t w) {
    const auto [a, m, b] = positions(star, {u, v, w});
    return {star.hole, a, m, b};
}

bool allows_triangle(const Star& star, std::uint32_t u, std::uint32_t v, std::uint32_t w) {
    return star.legality.allows_triangle(triangle_of(star, u, v, w));
}

/// The two triangles of a ring of four, by the diagonal between two of its vertices.
Retriangulation divided_by(const Star& star, std::uint32_t v, std::uint32_t w) {
    const auto [i, j] = positions(star, {v, w});
    Retriangulation two;
    two.triangles = i == 0 ? std::vector<NewTriangle>{{0, 2, 3, -1, 1}, {0, 1, 2, 0}}
                           : std::vector<NewTriangle>{{0, 1, 3, -1, -1, 1}, {1, 2, 3, 0}};
    EXPECT_EQ(j - i, 2);
    return two;
}

/// Vertices 0, the candidate, and 1 … 4, a square around it.
Points square(double height = 0) { return {{0, 0, height}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}; }

// Existing edges

/// A pyramid over a square that is divided along an edge.
class Pyramid : public Star {
public:
    explicit Pyramid(const Triangles& floor)
        : Star(meshes::from_points(square(1), holes::star_triangles(4, true) + floor), 0) {}
};

TEST(Legality, AllowsNoDiagonalThatExists) {
    Pyramid one({{1, 3, 2}, {1, 4, 3}}), other({{2, 4, 3}, {2, 1, 4}});
    ASSERT_TRUE(one.enter());
    ASSERT_TRUE(other.enter());
    EXPECT_FALSE(one.legality.allows_diagonals(divided_by(one, 1, 3)));
    EXPECT_TRUE(one.legality.allows_diagonals(divided_by(one, 2, 4)));
    EXPECT_TRUE(other.legality.allows_diagonals(divided_by(other, 1, 3)));
    EXPECT_FALSE(other.legality.allows_diagonals(divided_by(other, 2, 4)));
}

TEST(Legality, KnowsADiagonalThatExistsOnceItWasAskedFor) {
    Pyramid pyramid({{1, 3, 2}, {1, 4, 3}});
    ASSERT_TRUE(pyramid.enter());
    EXPECT_TRUE(allows_edge(pyramid, 1, 3)); // as far as is known
    EXPECT_FALSE(pyramid.legality.allows_diagonals(divided_by(pyramid, 1, 3)));
    EXPECT_FALSE(allows_edge(pyramid, 1, 3));
    EXPECT_TRUE(allows_edge(pyramid, 2, 4));
    ASSERT_TRUE(pyramid.enter()); // another hole is another question
    EXPECT_TRUE(allows_edge(pyramid, 1, 3));
}

TEST(Legality, AllowsNoEdgeThatExistsOnAnotherSheet) {
    const Points points = square() + Points{{0, 0, 5}, {1, 0, 5}};
    const auto star = [&](const glm::uvec3& beside) {
        return meshes::from_points(points, holes::star_triangles(4, true) + Triangles{beside});
    };
    Star refused(star({1, 3, 5}), 0), allowed(star({1, 6, 5}), 0);
    ASSERT_TRUE(refused.surface.has_coincident_vertices());
    ASSERT_TRUE(allowed.surface.has_coincident_vertices());
    ASSERT_TRUE(refused.enter());
    ASSERT_TRUE(allowed.enter());
    EXPECT_FALSE(allows_edge(refused, 1, 3));
    EXPECT_TRUE(allows_edge(refused, 2, 4));
    EXPECT_TRUE(allows_edge(allowed, 1, 3));
}

TEST(Legality, AllowsNoEdgeBetweenTwoVerticesOfOneSite) {
    const Mesh mesh = meshes::from_points(square() + Points{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}},
                                          holes::star_triangles(4, true) + Triangles{{5, 6, 7}});
    Star refused(mesh, 0, false, {{1, 3}}), allowed(mesh, 0, false, {{1, 5}});
    ASSERT_TRUE(refused.enter());
    ASSERT_TRUE(allowed.enter());
    EXPECT_FALSE(allows_edge(refused, 1, 3));
    EXPECT_TRUE(allows_edge(refused, 2, 4));
    EXPECT_TRUE(allows_edge(allowed, 1, 3));
}

// Holes that cannot be filled at all

TEST(Legality, KeepsATetrahedron) {
    const Points points = {{0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, -1}};
    Star refused(meshes::from_points(points, holes::star_triangles(3, true) + Triangles{{1, 3, 2}}), 0);
    Star allowed(
        meshes::from_points(points, holes::star_triangles(3, true) + Triangles{{1, 3, 4}, {3, 2, 4}, {2, 1, 4}}), 0);
    EXPECT_FALSE(refused.enter());
    EXPECT_TRUE(allowed.enter());
}

/// The triangle of the ring exists on a sheet that meets the star's along the rim.
TEST(Legality, MakesNoTriangleThatAnotherSheetHas) {
    const Points points = {{0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}};
    const Triangles skirt = {{2, 1, 4}, {3, 2, 5}, {1, 3, 6}};
    const Triangles star = holes::star_triangles(3, true) + skirt;
    Star refused(meshes::from_points(points, star + Triangles{{1, 2, 3}}), 0);
    Star allowed(meshes::from_points(points, star + Triangles{{1, 2, 4}}), 0);
    ASSERT_TRUE(refused.surface.has_coincident_vertices());
    ASSERT_TRUE(allowed.surface.has_coincident_vertices());
    EXPECT_FALSE(refused.enter());
    EXPECT_TRUE(allowed.enter());
}

/// A disc with a hole in it of so many edges; the candidate is one of its corners.
Mesh ring_around_a_hole(std::uint32_t edges) {
    Points points;
    Triangles triangles;
    for (std::uint32_t i = 0; i < 2 * edges; ++i) {
        const double angle = glm::radians(360.0 * (i % edges) / edges), radius = i < edges ? 1 : 2;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    for (std::uint32_t i = 0; i < edges; ++i) {
        const std::uint32_t j = (i + 1) % edges;
        triangles.push_back({i, edges + i, edges + j});
        triangles.push_back({i, edges + j, j});
    }
    return meshes::from_points(points, triangles);
}

TEST(Legality, KeepsTheLastThreeEdgesOfABoundary) {
    Star refused(ring_around_a_hole(3), 0), allowed(ring_around_a_hole(4), 0);
    ASSERT_TRUE(refused.hole.open);
    ASSERT_TRUE(allowed.hole.open);
    EXPECT_FALSE(refused.enter());
    EXPECT_TRUE(allowed.enter());
}

TEST(Legality, KeepsACandidateWithAVertexOfItsOwnSiteBesideIt) {
    const Mesh mesh = meshes::from_points(square() + Points{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}},
                                          holes::star_triangles(4, true) + Triangles{{5, 6, 7}});
    Star refused(mesh, 0, false, {{0, 1}}), allowed(mesh, 0, false, {{0, 5}});
    EXPECT_FALSE(refused.enter());
    EXPECT_TRUE(allowed.enter());
}

Mesh wheel(std::uint32_t corners, bool closed) {
    Points points = {{0, 0, 0}};
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = glm::radians((closed ? 360.0 : 180.0) * i / corners);
        points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return meshes::from_points(points, holes::star_triangles(corners, closed));
}

TEST(Legality, KeepsACandidateOfTheLastTriangle) {
    EXPECT_FALSE(Star(wheel(2, false), 0).enter());
    EXPECT_TRUE(Star(wheel(3, false), 0).enter());
}

// Triangles in the layout

TEST(Legality, AllowsNoTriangleThatLiesTheOtherWayRound) {
    const auto star = [](double x) { // of the corner between vertices 1 and 3
        const Points points = {{0, 0, 0}, {1, -0.5, 0}, {x, 0, 0}, {1, 0.5, 0}, {-1, 0.5, 0}, {-1, -0.5, 0}};
        return meshes::from_points(points, holes::star_triangles(5, true));
    };
    Star hollow(star(0.9), 0), straight(star(1), 0), bulging(star(1.1), 0);
    for (Star* one : {&hollow, &straight, &bulging}) ASSERT_TRUE(one->enter());
    EXPECT_FALSE(is_ccw_in_layout(hollow, 1, 2, 3));
    EXPECT_FALSE(is_ccw_in_layout(straight, 1, 2, 3));
    EXPECT_TRUE(is_ccw_in_layout(bulging, 1, 2, 3));
}

/// Angles at which the corners of a boundary candidate lie; a diagonal must leave the candidate on the side of the closing edge.
Mesh open_star(const std::vector<double>& degrees, bool closed = false) {
    Points points = {{0, 0, 0}};
    for (const double angle : degrees)
        points.push_back({std::cos(glm::radians(angle)), std::sin(glm::radians(angle)), 0});
    return meshes::from_points(points, holes::star_triangles(static_cast<std::uint32_t>(degrees.size()), closed));
}

TEST(Legality, AllowsNoDiagonalOfAnOpenHoleThatLeavesTheCandidateInside) {
    Star refused(open_star({-40, 60, 150, 200}), 0), allowed(open_star({-40, 60, 130, 200}), 0);
    Star closed(open_star({-40, 60, 150, 200}, true), 0); // there the candidate may go anywhere
    for (Star* one : {&refused, &allowed, &closed}) ASSERT_TRUE(one->enter());
    EXPECT_FALSE(allows_edge(refused, 1, 3));
    EXPECT_TRUE(allows_edge(refused, 2, 4));
    EXPECT_TRUE(allows_edge(allowed, 1, 3));
    EXPECT_TRUE(allows_edge(closed, 1, 3));
}

// Folds

/// A square pyramid whose sides face 60 degrees from up, and small flaps outside two opposite rims, which face so many degrees from up.
Mesh pyramid_with_flaps(double one, double other, std::uint32_t turn = 0) {
    Points points = {{0, 0, std::sqrt(3.0)}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}};
    const auto tip = [](double side, double degrees) { // 0: the flap goes on outwards, 90: straight down
        return glm::dvec3(side * (1 + 0.1 * std::cos(glm::radians(degrees))), 0,
                          -0.1 * std::sin(glm::radians(degrees)));
    };
    points.push_back(tip(1, one));
    points.push_back(tip(-1, other));
    return meshes::from_points(points, holes::star_triangles(4, true, turn) + Triangles{{2, 1, 5}, {4, 3, 6}});
}

/// Whichever edge of a new triangle the rim is.
TEST(Legality, AllowsNoFoldAcrossARim) {
    for (std::uint32_t turn = 0; turn < 4; ++turn) {
        SCOPED_TRACE(turn);
        Star refused(pyramid_with_flaps(125, 90, turn), 0), allowed(pyramid_with_flaps(115, 90, turn), 0);
        ASSERT_TRUE(refused.enter());
        ASSERT_TRUE(allowed.enter());
        for (const std::uint32_t last : {3U, 4U}) {
            EXPECT_FALSE(allows_triangle(refused, 1, 2, last));
            EXPECT_TRUE(allows_triangle(allowed, 1, 2, last));
        }
        EXPECT_TRUE(allows_triangle(refused, 2, 3, 4)); // at the other rims it bends less
        EXPECT_TRUE(allows_triangle(refused, 1, 3, 4));
    }
}

TEST(Legality, LetsARimBendAsFarAsTheStarDidBefore) {
    Star bent_less(pyramid_with_flaps(125, 180), 0); // 120 degrees from the side
    Star bent_more(pyramid_with_flaps(125, 190), 0); // 130
    ASSERT_TRUE(bent_less.enter());
    ASSERT_TRUE(bent_more.enter());
    EXPECT_FALSE(allows_triangle(bent_less, 1, 2, 3));
    EXPECT_TRUE(allows_triangle(bent_more, 1, 2, 3));
}

/// A saddle: from the candidate two corners rise and two lie level. The diagonal between the former is a ridge.
Mesh saddle(double rise, double width, std::uint32_t turn = 0) {
    const Points points = {{0, 0, 0.1}, {1, 0, rise}, {0, width, 0}, {-1, 0, rise}, {0, -width, 0}};
    return meshes::from_points(points, holes::star_triangles(4, true, turn));
}

bool allows_ridge(const Star& star) {
    const Retriangulation two = divided_by(star, 1, 3);
    const auto in_space = [&](std::size_t n) {
        const NewTriangle& t = two.triangles[n];
        return RingTriangle(star.hole, t.a, t.m, t.b);
    };
    const RingTriangle root = in_space(0), below = in_space(1);
    EXPECT_TRUE(star.legality.allows_triangle(root));
    EXPECT_TRUE(star.legality.allows_triangle(below));
    const bool is_left = two.triangles[0].left == 1;
    return star.legality.allows_neighbours(root, is_left ? &below.normal : nullptr, is_left ? nullptr : &below.normal);
}

/// Whichever side of the diagonal the ring begins on.
TEST(Legality, AllowsNoFoldAcrossADiagonal) {
    // Two slopes of rise : width bend by twice the arc tangent of that: 120 degrees where it is the root of 3.
    for (std::uint32_t turn = 0; turn < 4; ++turn) {
        SCOPED_TRACE(turn);
        Star refused(saddle(0.9, 0.5, turn), 0), allowed(saddle(0.85, 0.5, turn), 0);
        ASSERT_TRUE(refused.enter());
        ASSERT_TRUE(allowed.enter());
        EXPECT_FALSE(allows_ridge(refused));
        EXPECT_TRUE(allows_ridge(allowed));
    }
}

// Turns

/// A flat square, and outside each rim a flap of such a length that faces so many degrees from up.
Mesh square_with_flaps(double degrees, double length) {
    Points points = square();
    for (std::size_t i = 1; i <= 4; ++i) {
        const glm::dvec3 middle = 0.5 * (points[i] + points[i % 4 + 1]);
        const double angle = glm::radians(degrees);
        points.push_back(middle +
                         length * (std::cos(angle) * glm::normalize(middle) - glm::dvec3(0, 0, std::sin(angle))));
    }
    return meshes::from_points(points,
                               holes::star_triangles(4, true) + Triangles{{2, 1, 5}, {3, 2, 6}, {4, 3, 7}, {1, 4, 8}});
}

/// At the corners the original faces sideways and down by its long flaps, though up at the candidate.
TEST(Legality, AllowsNoTriangleThatTurnsMoreThanARightAngleFromTheOriginal) {
    Star refused(square_with_flaps(110, 3), 0), less_steep(square_with_flaps(85, 3), 0);
    Star shorter(square_with_flaps(110, 1), 0);
    for (Star* one : {&refused, &less_steep, &shorter}) {
        const auto once = [](std::uint32_t) { return std::size_t(1); };
        ASSERT_EQ(one->normals.count_flipped_normals(one->surface, one->rows, once), 0U);
        ASSERT_TRUE(one->enter());
    }
    EXPECT_FALSE(allows_triangle(refused, 1, 2, 3));
    EXPECT_TRUE(allows_triangle(less_steep, 1, 2, 3));
    EXPECT_TRUE(allows_triangle(shorter, 1, 2, 3));
}

/// With slopes of so much to one the two triangles of the ridge face so far from the hole's normal.
TEST(Legality, AllowsNoTriangleThatTurnsAwayFromTheHoleWhereItMindsTurns) {
    Star refused(saddle(1, 0.09), 0, true), allowed(saddle(1, 0.11), 0, true), careless(saddle(1, 0.09), 0, false);
    for (Star* one : {&refused, &allowed, &careless}) ASSERT_TRUE(one->enter());
    for (const std::uint32_t tip : {2U, 4U}) {
        EXPECT_FALSE(allows_triangle(refused, 1, tip, 3));
        EXPECT_TRUE(allows_triangle(allowed, 1, tip, 3));
        EXPECT_TRUE(allows_triangle(careless, 1, tip, 3));
    }
}

} // namespace
