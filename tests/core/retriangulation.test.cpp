// The dynamic programme finds the cheapest legal triangulation of a hole: against all of them.

#include "retriangulation/retriangulation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meshbound/bounds.hpp"
#include "meshes/random.hpp"
#include "retriangulation/layout.hpp"

namespace {

using namespace meshbound;

constexpr double pi_here = 3.141592653589793;

/// A fan around vertex 0 on a plane, whose ring is 1 … count; a quarter of it is missing where it is open.
Mesh star(meshes::Random& random, int count, bool open) {
    std::vector<double> position = {0, 0, 0};
    Mesh mesh;
    const double whole = open ? 1.5 * pi_here : 2 * pi_here;
    for (int i = 0; i < count; ++i) {
        const double angle = whole * (i + 0.3 * random.uniform(0, 1)) / count, radius = random.uniform(0.4, 1);
        position.insert(position.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    mesh.position.values = position;
    for (unsigned i = 0; i + 1 < unsigned(count); ++i) mesh.triangles.push_back({0, 1 + i, 2 + i});
    if (!open) mesh.triangles.push_back({0, unsigned(count), 1});
    return mesh;
}

/// Whole numbers, beside which the weight of shapes counts for nothing.
class SomeCosts : public HoleCost {
public:
    SomeCosts(meshes::Random& random, int size) : size_(size) {
        for (int i = 0; i < size * size * size; ++i) costs_.push_back(static_cast<double>(random.below(20)));
    }
    double diagonal(int i, int j) override { return costs_[static_cast<std::size_t>(i * size_ + j)]; }
    double triangle(int a, int m, int b, double) override {
        return costs_[static_cast<std::size_t>((a * size_ + m) * size_ + b)];
    }

private:
    int size_;
    std::vector<double> costs_;
};

struct Triple {
    int a, m, b;
};

class Holes {
public:
    Holes(Mesh mesh) : mesh_(std::move(mesh)), surface_(mesh_.triangles, vertex_count(mesh_), mesh_.regions) {
        std::vector<ResolvedBound> bounds;
        EXPECT_TRUE(resolve_bounds(mesh_, {{"position", relative(0.1)}}, bounds).ok());
        rows_ = Rows(mesh_, bounds, nullptr, surface_.inputs());
        normals_ = std::make_unique<OriginalNormals>(surface_, rows_);
        legality_ = std::make_unique<Legality>(*normals_, false);
        gather_star(surface_, 0, hole_);
        lay_out(rows_, hole_);
        enters_ = legality_->enter(surface_, rows_, hole_);
    }

    bool enters() const { return enters_; }
    const Hole& hole() const { return hole_; }
    Legality& legality() { return *legality_; }

    /// Where on the ring a vertex of the mesh is.
    int ring_position(std::uint32_t vertex) const {
        const auto found = std::find_if(hole_.ring.begin(), hole_.ring.end(),
                                        [&](std::uint32_t copy) { return surface_.input(copy) == vertex; });
        return static_cast<int>(found - hole_.ring.begin());
    }

    /// A triangle that may be made, its edges, too, `taken` being those that the surface has elsewhere.
    bool allows(const Triple& t, const std::set<std::pair<int, int>>& taken) const {
        const auto free = [&](int i, int j) { return legality_->allows_edge(i, j) && taken.count({i, j}) == 0; };
        return free(t.a, t.m) && free(t.m, t.b) && free(t.a, t.b) && legality_->is_ccw_in_layout(t.a, t.m, t.b) &&
               legality_->allows_triangle(RingTriangle(hole_, t.a, t.m, t.b));
    }

private:
    Mesh mesh_;
    Surface surface_;
    Rows rows_;
    std::unique_ptr<OriginalNormals> normals_;
    std::unique_ptr<Legality> legality_;
    Hole hole_;
    bool enters_ = false;
};

/// The least cost of all triangulations of the sub-polygon a … b, each looked at by itself.
double least_of_all(const Holes& holes, HoleCost& cost, const std::set<std::pair<int, int>>& taken, int a, int b) {
    if (b == a + 1) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (int m = a + 1; m < b; ++m) {
        if (!holes.allows({a, m, b}, taken)) continue;
        const double parts = least_of_all(holes, cost, taken, a, m) + least_of_all(holes, cost, taken, m, b);
        least = std::min(least, parts + cost.triangle(a, m, b, 1e9));
    }
    const bool is_root = a == 0 && b == holes.hole().size() - 1;
    return is_root ? least : least + cost.diagonal(a, b);
}

double cost_of(const Retriangulation& retriangulation, HoleCost& cost) {
    double sum = 0;
    for (const NewTriangle& t : retriangulation.triangles)
        sum += cost.triangle(t.a, t.m, t.b, 1e9) + (t.parent < 0 ? 0 : cost.diagonal(t.a, t.b));
    return sum;
}

void expect_fills(const Retriangulation& retriangulation, int size) {
    ASSERT_EQ(retriangulation.triangles.size(), static_cast<std::size_t>(size - 2));
    std::multiset<std::pair<int, int>> edges;
    for (const NewTriangle& t : retriangulation.triangles) {
        EXPECT_LT(t.a, t.m);
        EXPECT_LT(t.m, t.b);
        for (const auto& edge : {std::pair{t.a, t.m}, std::pair{t.m, t.b}, std::pair{t.a, t.b}}) edges.insert(edge);
    }
    for (int i = 0; i < size; ++i) EXPECT_EQ(edges.count(std::minmax(i, (i + 1) % size)), 1U) << "ring edge " << i;
    for (const auto& edge : edges) EXPECT_LE(edges.count(edge), 2U);
}

class Retriangulated : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(OpenAndClosed, Retriangulated, testing::Bool(),
                         [](const auto& one) { return one.param ? "Open" : "Closed"; });

TEST_P(Retriangulated, AtTheLeastCostOfAllThatAreLegal) {
    int filled = 0, refused = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        Holes holes(star(random, 3 + static_cast<int>(random.below(6)), GetParam()));
        if (!holes.enters()) continue;
        const int size = holes.hole().size();
        SomeCosts cost(random, size);
        Retriangulator retriangulator;
        Retriangulation found;
        const double least = least_of_all(holes, cost, {}, 0, size - 1);
        const bool is_filled = retriangulator.triangulate(holes.hole(), holes.legality(), cost, found);
        EXPECT_EQ(is_filled, std::isfinite(least));
        (is_filled ? filled : refused)++;
        if (!is_filled) continue;
        expect_fills(found, size);
        EXPECT_EQ(cost_of(found, cost), least);
    }
    EXPECT_GT(filled, 100);
    if (GetParam()) {
        EXPECT_GT(refused, 0) << "no ring that no triangulation fills";
    }
}

/// Ring vertices that are joined elsewhere are not joined again.
TEST_P(Retriangulated, WithoutAnEdgeThatThereIsAlready) {
    int made_else = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        Mesh mesh = star(random, 6, GetParam());
        const Mesh plain = mesh;
        const auto first = static_cast<unsigned>(1 + random.below(3)), second = first + 2;
        auto& position = std::get<std::vector<double>>(mesh.position.values);
        position.insert(position.end(), {0, 0, 5});
        mesh.triangles.push_back({first, second, 7});
        Holes holes(mesh);
        if (!holes.enters()) continue;
        const std::pair<int, int> taken = std::minmax({holes.ring_position(first), holes.ring_position(second)});
        ASSERT_LT(taken.second, holes.hole().size());
        SomeCosts cost(random, holes.hole().size());
        Retriangulator retriangulator;
        Retriangulation found;
        const double least = least_of_all(holes, cost, {taken}, 0, holes.hole().size() - 1);
        ASSERT_EQ(retriangulator.triangulate(holes.hole(), holes.legality(), cost, found), std::isfinite(least));
        if (!std::isfinite(least)) continue;
        EXPECT_EQ(cost_of(found, cost), least);
        for (const NewTriangle& t : found.triangles) {
            if (t.parent >= 0) {
                EXPECT_NE(std::pair(t.a, t.b), taken);
            }
        }
        // Without the other triangle the edge is made now and then.
        Holes alone(plain);
        const std::pair<int, int> here = std::minmax({alone.ring_position(first), alone.ring_position(second)});
        if (!retriangulator.triangulate(alone.hole(), alone.legality(), cost, found)) continue;
        for (const NewTriangle& t : found.triangles) made_else += t.parent >= 0 && std::pair(t.a, t.b) == here;
    }
    EXPECT_GT(made_else, 5);
}

TEST_P(Retriangulated, AsAFanThatMeetsInItsHub) {
    int legal = 0, illegal = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        Holes holes(star(random, 5 + static_cast<int>(random.below(4)), GetParam()));
        if (!holes.enters()) continue;
        const int size = holes.hole().size();
        for (int hub = 0; hub < size; ++hub) {
            bool expected = true;
            for (int i = 0; i + 1 < size; ++i) {
                if (i == hub || i + 1 == hub) continue;
                const Triple t = hub < i       ? Triple{hub, i, i + 1}
                                 : hub > i + 1 ? Triple{i, i + 1, hub}
                                               : Triple{i, hub, i + 1};
                expected = expected && holes.allows(t, {});
            }
            if (hub > 0 && hub < size - 1) expected = expected && holes.allows({0, hub, size - 1}, {});
            Retriangulator retriangulator;
            Retriangulation found;
            EXPECT_EQ(retriangulator.fan(holes.hole(), holes.legality(), hub, found), expected) << "hub " << hub;
            (expected ? legal : illegal)++;
            if (!expected) continue;
            expect_fills(found, size);
            for (const NewTriangle& t : found.triangles) EXPECT_TRUE(t.a == hub || t.m == hub || t.b == hub);
        }
    }
    EXPECT_GT(legal, 30);
    EXPECT_GT(illegal, 10);
}

} // namespace
