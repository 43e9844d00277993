// Which spokes a diagonal crosses and which sectors a new triangle overlaps, against clipping in the plane.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "meshes/random.hpp"
#include "retriangulation/overlap.hpp"

namespace {

using namespace meshbound;

using Polygon = std::vector<glm::dvec2>;

/// Areas below this share of the unit circle's square are contact, not overlap.
constexpr double contact = 1e-9;

double cross(const glm::dvec2& u, const glm::dvec2& v) { return u.x * v.y - u.y * v.x; }

double area(const Polygon& polygon) {
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return doubled / 2;
}

/// What of a polygon lies left of the line from `start` to `end`.
Polygon left_of(const Polygon& polygon, const glm::dvec2& start, const glm::dvec2& end) {
    Polygon kept;
    const auto side = [&](const glm::dvec2& p) { return cross(end - start, p - start); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        if (side(here) >= 0) kept.push_back(here);
        if (side(here) * side(next) < 0) kept.push_back(here + side(here) / (side(here) - side(next)) * (next - here));
    }
    return kept;
}

bool overlap(const Polygon& one, const Polygon& other) {
    Polygon rest = one;
    for (std::size_t i = 0; i < other.size(); ++i) rest = left_of(rest, other[i], other[(i + 1) % other.size()]);
    return area(rest) > contact;
}

/// A star whose ring is convex, so that every diagonal runs inside of it. Of an open one the candidate lies between the ends of
/// the ring.
Hole convex_hole(meshes::Random& random, int size, bool open) {
    Hole hole;
    hole.open = open;
    std::vector<double> angles;
    const double last = open ? 3.1 : 6.2;
    for (int i = 0; i < size; ++i) angles.push_back(random.uniform(0, last));
    std::sort(angles.begin(), angles.end());
    if (open) angles.front() = 0, angles.back() = 3.141592653589793;
    // Somewhere near the middle, so that it lies on different sides of different diagonals.
    const glm::dvec2 candidate = open ? glm::dvec2(random.uniform(-0.5, 0.5), 0) : glm::dvec2(0);
    for (int i = 0; i < size; ++i) {
        const double angle = angles[static_cast<std::size_t>(i)];
        hole.layout.push_back(glm::dvec2(std::cos(angle), std::sin(angle)) - candidate);
        hole.ring.push_back(static_cast<std::uint32_t>(i));
    }
    hole.slots.resize(static_cast<std::size_t>(open ? size - 1 : size));
    return hole;
}

/// Whether the origin lies well inside of the ring, or on the closing edge of an open one.
bool is_star(const Hole& hole) {
    for (int i = 0; i < hole.sectors(); ++i)
        if (cross(hole.layout[static_cast<std::size_t>(i)], hole.layout[static_cast<std::size_t>(hole.after(i))]) <
            1e-3)
            return false;
    return true;
}

bool contains(const RingRange& range, int index, int size) { return (index - range.first + size) % size < range.count; }

class OverlapTest : public testing::TestWithParam<bool> {
protected:
    template <class Check>
    void for_each_hole(const Check& check) {
        meshes::Random random(GetParam() ? 7 : 3);
        int tried = 0;
        while (tried < 300) {
            const Hole hole = convex_hole(random, 3 + static_cast<int>(random.below(7)), GetParam());
            if (!is_star(hole)) continue;
            ++tried;
            check(hole);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(ClosedAndOpen, OverlapTest, testing::Bool());

TEST_P(OverlapTest, ADiagonalCrossesTheSpokesThatItCrossesInThePlane) {
    int crossed = 0;
    for_each_hole([&](const Hole& hole) {
        const auto at = [&](int i) { return hole.layout[static_cast<std::size_t>(i)]; };
        for (int a = 0; a < hole.size(); ++a) {
            for (int b = a + 1; b < hole.size(); ++b) {
                const RingRange spokes = crossed_spokes(hole, a, b);
                const bool is_rim = b == a + 1 || (a == 0 && b == hole.size() - 1);
                for (int spoke = 0; spoke < hole.size(); ++spoke) {
                    if (spoke == a || spoke == b) continue;
                    const glm::dvec2 way = at(b) - at(a);
                    const bool apart = cross(way, -at(a)) * cross(way, at(spoke) - at(a)) < 0;
                    const bool between = cross(at(spoke), at(a)) * cross(at(spoke), at(b)) < 0;
                    const bool is_crossed = !is_rim && apart && between;
                    EXPECT_EQ(contains(spokes, spoke, hole.size()), is_crossed)
                        << a << '-' << b << " and spoke " << spoke;
                    crossed += is_crossed;
                }
            }
        }
    });
    EXPECT_GT(crossed, 1'000);
}

TEST_P(OverlapTest, ATriangleOverlapsTheSectorsThatItCoversInThePlane) {
    int covered = 0, whole = 0;
    for_each_hole([&](const Hole& hole) {
        const auto at = [&](int i) { return hole.layout[static_cast<std::size_t>(i)]; };
        for (int a = 0; a < hole.size(); ++a)
            for (int m = a + 1; m < hole.size(); ++m)
                for (int b = m + 1; b < hole.size(); ++b) {
                    const RingRange sectors = overlapped_sectors(hole, a, m, b);
                    const Polygon triangle = {at(a), at(m), at(b)};
                    whole += sectors.count == hole.sectors() && hole.sectors() > 3;
                    for (int sector = 0; sector < hole.sectors(); ++sector) {
                        const Polygon of_sector = {glm::dvec2(0), at(sector), at(hole.after(sector))};
                        if (overlap(triangle, of_sector)) {
                            EXPECT_TRUE(contains(sectors, sector, hole.size()))
                                << a << '-' << m << '-' << b << " and sector " << sector;
                            ++covered;
                        } else {
                            EXPECT_FALSE(contains(sectors, sector, hole.size()))
                                << a << '-' << m << '-' << b << " and sector " << sector;
                        }
                    }
                }
    });
    EXPECT_GT(covered, 1'000);
    EXPECT_GT(whole, 10);
}

TEST_P(OverlapTest, OneTriangleOfATriangulationHasTheCandidate) {
    for_each_hole([](const Hole& hole) {
        // All triangles of a fan from ring index 0.
        int holders = 0;
        for (int m = 1; m + 1 < hole.size(); ++m) holders += contains_candidate(hole, 0, m, m + 1);
        EXPECT_EQ(holders, 1);
    });
}

} // namespace
