// The cheapest retriangulation of a hole against all there are.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "holes.hpp"
#include "meshes/random.hpp"
#include "retriangulation/retriangulation.hpp"
#include "retriangulation/ring_triangle.hpp"
#include "util/indexing.hpp"

namespace {

using namespace meshbound;
using holes::Star;

/// Ring positions a < m < b.
using Corners = std::array<int, 3>;
using Filling = std::vector<Corners>;

constexpr double none = std::numeric_limits<double>::infinity();

/// All triangulations of the sub-polygon a … b.
std::vector<Filling> all_fillings(int a, int b) {
    if (b == a + 1) return {{}};
    std::vector<Filling> all;
    for (int m = a + 1; m < b; ++m)
        for (const Filling& left : all_fillings(a, m))
            for (const Filling& right : all_fillings(m, b)) {
                Filling filling = {{a, m, b}};
                filling.insert(filling.end(), left.begin(), left.end());
                filling.insert(filling.end(), right.begin(), right.end());
                all.push_back(std::move(filling));
            }
    return all;
}

/// The share of shape in the cost, as it is documented in the retriangulator: edges' squares over the area, 1 for the
/// equilateral triangle, no more than 1000, a millionth of it.
double shape_cost(const RingTriangle& t) {
    const double squares = glm::dot(t.u, t.u) + glm::dot(t.v, t.v) + glm::dot(t.w, t.w);
    return 1e-6 * std::min(1e3, squares / (2 * std::sqrt(3.0) * t.length));
}

/// Costs at random, some of them zero. What is dearer than the limit is told as the limit itself, which is allowed.
class RandomCost : public HoleCost {
public:
    RandomCost(int size, meshes::Random& random) : size_(size) {
        for (int i = 0; i < size * size; ++i) diagonals_.push_back(cost(random));
        for (int i = 0; i < size * size * size; ++i) triangles_.push_back(cost(random));
    }
    double diagonal(int i, int j) override { return diagonals_[to_index(i * size_ + j)]; }
    double triangle(int a, int m, int b, double limit) override { return std::min(limit, true_cost({a, m, b})); }
    double true_cost(const Corners& t) const { return triangles_[to_index((t[0] * size_ + t[1]) * size_ + t[2])]; }

private:
    static double cost(meshes::Random& random) { return random.below(4) == 0 ? 0 : random.uniform(0, 1); }

    int size_;
    std::vector<double> diagonals_, triangles_;
};

double cost_of(const Filling& filling, const Hole& hole, RandomCost& cost) {
    double sum = 0;
    for (const Corners& t : filling) {
        sum += cost.true_cost(t) + shape_cost(RingTriangle(hole, t[0], t[1], t[2]));
        if (t[2] - t[0] < hole.size() - 1) sum += cost.diagonal(t[0], t[2]);
    }
    return sum;
}

/// The normal of the triangle of a filling across (a, b), which cuts off positions between them.
std::optional<glm::dvec3> normal_below(const Filling& filling, const Hole& hole, int a, int b) {
    for (const Corners& t : filling)
        if (t[0] == a && t[2] == b) return RingTriangle(hole, t[0], t[1], t[2]).normal;
    return {};
}

/// Rule by rule, but for the diagonals that exist elsewhere, which are given.
bool is_legal(const Filling& filling, const Star& star, const std::vector<Corners>& taken = {}) {
    const Hole& hole = star.hole;
    return std::all_of(filling.begin(), filling.end(), [&](const Corners& t) {
        const auto [a, m, b] = t;
        const auto is_this = [a = a, b = b](const Corners& edge) { return edge[0] == a && edge[2] == b; };
        if (b - a < hole.size() - 1 && std::any_of(taken.begin(), taken.end(), is_this)) return false;
        const RingTriangle triangle(hole, a, m, b);
        const auto left = normal_below(filling, hole, a, m), right = normal_below(filling, hole, m, b);
        return star.legality.allows_edge(a, b) && star.legality.is_ccw_in_layout(a, m, b) &&
               star.legality.allows_triangle(triangle) &&
               star.legality.allows_neighbours(triangle, left ? &*left : nullptr, right ? &*right : nullptr);
    });
}

double least_cost(const Star& star, RandomCost& cost, const std::vector<Corners>& taken = {}) {
    double least = none;
    for (const Filling& filling : all_fillings(0, star.hole.size() - 1))
        if (is_legal(filling, star, taken)) least = std::min(least, cost_of(filling, star.hole, cost));
    return least;
}

/// As many as fill the hole, parents first, joined as they say.
Filling checked(const Retriangulation& retriangulation, int size) {
    const std::vector<NewTriangle>& triangles = retriangulation.triangles;
    EXPECT_EQ(triangles.size(), static_cast<std::size_t>(size - 2));
    Filling filling;
    for (std::size_t n = 0; n < triangles.size(); ++n) {
        const NewTriangle& t = triangles[n];
        EXPECT_LT(t.a, t.m);
        EXPECT_LT(t.m, t.b);
        if (n == 0) {
            EXPECT_EQ(t.parent, -1);
            EXPECT_EQ(t.a, 0);
            EXPECT_EQ(t.b, size - 1);
        } else {
            EXPECT_GE(t.parent, 0);
            EXPECT_LT(t.parent, static_cast<int>(n));
        }
        const auto expect_child = [&](int child, int a, int b) {
            if (b == a + 1) {
                EXPECT_EQ(child, -1);
                return;
            }
            ASSERT_GT(child, static_cast<int>(n));
            ASSERT_LT(child, static_cast<int>(triangles.size()));
            EXPECT_EQ(triangles[to_index(child)].parent, static_cast<int>(n));
            EXPECT_EQ(triangles[to_index(child)].a, a);
            EXPECT_EQ(triangles[to_index(child)].b, b);
        };
        expect_child(t.left, t.a, t.m);
        expect_child(t.right, t.m, t.b);
        filling.push_back({t.a, t.m, t.b});
    }
    return filling;
}

/// A star with corners at random distances, so that some triangles lie the wrong way round; `relief`: how far out of the plane.
std::vector<glm::dvec3> star_points(meshes::Random& random, std::uint32_t corners, bool closed, double relief) {
    std::vector<glm::dvec3> points = {{0, 0, relief * random.uniform(-1, 1)}};
    const double step = (closed ? 2.0 : 1.2) * 3.14159265358979 / (closed ? corners : corners - 1);
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = step * (i + random.uniform(-0.3, 0.3)), radius = random.uniform(0.5, 1.5);
        points.push_back({radius * std::cos(angle), radius * std::sin(angle), relief * random.uniform(-1, 1)});
    }
    return points;
}

Mesh star_mesh(meshes::Random& random, std::uint32_t corners, bool closed, double relief) {
    return meshes::from_points(star_points(random, corners, closed, relief), holes::star_triangles(corners, closed));
}

/// The number of triangulations of a polygon: Catalan's.
TEST(AllFillings, AreAllOfThem) {
    const std::array<std::size_t, 6> expected = {1, 2, 5, 14, 42, 132};
    for (int size = 3; size <= 8; ++size) {
        std::vector<Filling> all = all_fillings(0, size - 1);
        for (Filling& filling : all) std::sort(filling.begin(), filling.end());
        std::sort(all.begin(), all.end());
        EXPECT_TRUE(std::adjacent_find(all.begin(), all.end()) == all.end());
        EXPECT_EQ(all.size(), expected[static_cast<std::size_t>(size - 3)]);
    }
}

/// Closed and open holes.
class RetriangulationTest : public testing::TestWithParam<bool> {
protected:
    static constexpr int rounds = 100;
    /// Calls `look(star, cost, random)` with stars of three to eight corners.
    template <class Look>
    void for_each_star(double relief, const Look& look) const {
        for (std::uint32_t corners = 3; corners <= 8; ++corners)
            for (std::uint64_t seed = 0; seed < rounds; ++seed) {
                SCOPED_TRACE(testing::Message() << corners << " corners, seed " << seed);
                meshes::Random random(1000 * corners + seed);
                const Mesh mesh = star_mesh(random, corners, GetParam(), relief);
                Star star(mesh, 0);
                ASSERT_EQ(star.hole.open, !GetParam());
                ASSERT_EQ(star.hole.size(), static_cast<int>(corners));
                if (!star.enter()) continue;
                RandomCost cost(star.hole.size(), random);
                look(star, cost);
            }
    }
};
INSTANTIATE_TEST_SUITE_P(Holes, RetriangulationTest, testing::Bool(),
                         [](const auto& hole) { return hole.param ? "Closed" : "Open"; });

/// In what is nearly flat nothing folds, so that the optimum is that of all legal triangulations.
TEST_P(RetriangulationTest, IsTheCheapestOfAllWhereNothingFolds) {
    Retriangulator retriangulator;
    int filled = 0, forbidden = 0, unfillable = 0;
    for_each_star(0.05, [&](Star& star, RandomCost& cost) {
        const double least = least_cost(star, cost);
        Retriangulation best;
        ASSERT_EQ(retriangulator.triangulate(star.hole, star.legality, cost, best), least < none);
        if (least == none) {
            ++unfillable;
            return;
        }
        const Filling filling = checked(best, star.hole.size());
        ASSERT_TRUE(is_legal(filling, star));
        ASSERT_NEAR(cost_of(filling, star.hole, cost), least, 1e-12);
        ++filled;
        for (const Filling& other : all_fillings(0, star.hole.size() - 1)) forbidden += !is_legal(other, star);
    });
    EXPECT_GT(filled, GetParam() ? 4 * rounds : rounds);
    EXPECT_GT(forbidden, 10 * rounds);
    EXPECT_EQ(unfillable > 0, !GetParam()); // a candidate in the hollow of its boundary
}

/// How far neighbours bend is asked of the cheapest parts alone: what comes may be dearer than the optimum, never illegal.
TEST_P(RetriangulationTest, IsLegalWhereMuchFolds) {
    Retriangulator retriangulator;
    int filled = 0, cheapest = 0, missed = 0, folding = 0;
    for_each_star(1.5, [&](Star& star, RandomCost& cost) {
        const double least = least_cost(star, cost);
        Retriangulation best;
        const bool found = retriangulator.triangulate(star.hole, star.legality, cost, best);
        if (!found) {
            missed += least < none;
            return;
        }
        const Filling filling = checked(best, star.hole.size());
        ASSERT_TRUE(is_legal(filling, star));
        const double here = cost_of(filling, star.hole, cost);
        ASSERT_GE(here, least - 1e-12);
        ++filled;
        cheapest += here <= least + 1e-12;
        for (const Filling& other : all_fillings(0, star.hole.size() - 1)) {
            const bool open = std::all_of(other.begin(), other.end(), [&](const Corners& t) {
                return star.legality.is_ccw_in_layout(t[0], t[1], t[2]) && star.legality.allows_edge(t[0], t[2]);
            });
            folding += open && !is_legal(other, star);
        }
    });
    EXPECT_GT(filled, rounds);
    EXPECT_GT(folding, rounds);
    EXPECT_GT(cheapest, filled * 9 / 10);
    EXPECT_LT(missed, filled / 20);
}

TEST_P(RetriangulationTest, FansAreThoseOfEveryLegalHub) {
    Retriangulator retriangulator;
    int legal = 0, illegal = 0;
    for (const double relief : {0.05, 1.5})
        for_each_star(relief, [&](Star& star, RandomCost&) {
            const int size = star.hole.size();
            for (int hub = 0; hub < size; ++hub) {
                Filling expected;
                for (const Filling& filling : all_fillings(0, size - 1)) {
                    const auto has_hub = [hub](const Corners& t) {
                        return std::find(t.begin(), t.end(), hub) != t.end();
                    };
                    if (std::all_of(filling.begin(), filling.end(), has_hub)) expected = filling;
                }
                Retriangulation fan;
                const bool found = retriangulator.fan(star.hole, star.legality, hub, fan);
                ASSERT_EQ(found, is_legal(expected, star)) << hub;
                (found ? legal : illegal) += 1;
                if (!found) continue;
                Filling filling = checked(fan, size);
                std::sort(filling.begin(), filling.end());
                std::sort(expected.begin(), expected.end());
                ASSERT_EQ(filling, expected);
            }
        });
    EXPECT_GT(legal, rounds);
    EXPECT_GT(illegal, rounds);
}

/// A closed star on a floor whose edges join the corners of its ring, and lie in the plane of the ring as the star does. They
/// are found only when a retriangulation has one of them; then the cheapest of those without it is looked for.
class Pillow {
public:
    Pillow(meshes::Random& random, std::uint32_t corners) {
        const std::vector<Filling> floors = all_fillings(0, static_cast<int>(corners) - 1);
        floor_ = floors[random.below(floors.size())];
        std::vector<glm::uvec3> triangles = holes::star_triangles(corners, true);
        for (const Corners& t : floor_) triangles.push_back({t[0] + 1, t[2] + 1, t[1] + 1});
        mesh = meshes::from_points(star_points(random, corners, true, 0), triangles);
    }
    /// The edges of the floor by the ring positions of a star.
    std::vector<Corners> taken(const Star& star) const {
        std::vector<Corners> edges;
        for (const Corners& t : floor_) {
            const int i = star.position(static_cast<std::uint32_t>(t[0] + 1));
            const int j = star.position(static_cast<std::uint32_t>(t[2] + 1));
            edges.push_back({std::min(i, j), 0, std::max(i, j)});
        }
        return edges;
    }
    Mesh mesh;

private:
    Filling floor_;
};

TEST(Retriangulation, LeavesOutDiagonalsThatExist) {
    Retriangulator retriangulator;
    int filled = 0, avoided = 0;
    for (std::uint32_t corners = 4; corners <= 8; ++corners)
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            SCOPED_TRACE(testing::Message() << corners << " corners, seed " << seed);
            meshes::Random random(1000 * corners + seed);
            const Pillow pillow(random, corners);
            Star star(pillow.mesh, 0);
            ASSERT_TRUE(star.enter());
            const std::vector<Corners> taken = pillow.taken(star);
            RandomCost cost(star.hole.size(), random);
            const double heedless = least_cost(star, cost), least = least_cost(star, cost, taken);
            Retriangulation best;
            ASSERT_EQ(retriangulator.triangulate(star.hole, star.legality, cost, best), least < none);
            if (least == none) continue;
            const Filling filling = checked(best, star.hole.size());
            ASSERT_TRUE(is_legal(filling, star, taken));
            ASSERT_NEAR(cost_of(filling, star.hole, cost), least, 1e-12);
            ++filled;
            avoided += heedless < least;
        }
    EXPECT_GT(filled, 100);
    EXPECT_GT(avoided, 50);
}

TEST(Retriangulation, FansWithADiagonalThatExistsAreNotLegal) {
    Retriangulator retriangulator;
    int legal = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        meshes::Random random(seed);
        const Pillow pillow(random, 5);
        Star star(pillow.mesh, 0);
        ASSERT_TRUE(star.enter());
        const std::vector<Corners> taken = pillow.taken(star);
        for (int hub = 0; hub < 5; ++hub) {
            Retriangulation fan;
            if (!retriangulator.fan(star.hole, star.legality, hub, fan)) continue;
            ASSERT_TRUE(is_legal(checked(fan, 5), star, taken));
            ++legal;
        }
    }
    EXPECT_GT(legal, 20);
}

} // namespace
