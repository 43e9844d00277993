// What holds a vertex back, and what does not.

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class HeldBack : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds, std::vector<std::uint32_t> locked = {}) const {
        Options options = GetParam().options();
        options.locked = std::move(locked);
        return guarantee::reduced(mesh, bounds, options);
    }
};
EVERY_MODE(HeldBack);

bool stays(const Reduction& reduction, std::uint32_t vertex) {
    return std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), vertex);
}

constexpr int cells = 8;
constexpr std::uint32_t middle = (cells + 1) * (cells + 1) / 2;

Mesh plane_with_peak(double height) {
    Mesh mesh = meshes::plane(cells, cells);
    std::get<std::vector<double>>(mesh.position.values)[3 * middle + 2] = height;
    return mesh;
}

Mesh plane_with_peak_of_variable(double height) {
    Mesh mesh = meshes::plane(cells, cells);
    meshes::add_scalar(mesh, "f", [](glm::dvec3) { return 0.0; });
    std::get<std::vector<double>>(mesh.variables[0].values)[middle] = height;
    return mesh;
}

/// So that what becomes of the peak does not depend on what went before it.
std::vector<std::uint32_t> all_but_the_middle() {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < (cells + 1) * (cells + 1); ++v)
        if (v != middle) vertices.push_back(v);
    return vertices;
}

TEST_P(HeldBack, APeakStaysExactlyWhereItIsHigherThanTheBound) {
    const Mesh mesh = plane_with_peak(0.02);
    EXPECT_TRUE(stays(reduce(mesh, {{"position", absolute(0.0199)}}), middle));
    EXPECT_TRUE(stays(reduce(mesh, {{"position", absolute(0.0199)}}, all_but_the_middle()), middle));
    EXPECT_FALSE(stays(reduce(mesh, {{"position", absolute(0.0201)}}, all_but_the_middle()), middle));
}

TEST_P(HeldBack, APlaneWithALowPeakCollapsesToItsOutline) {
    EXPECT_EQ(reduce(plane_with_peak(0.02), {{"position", absolute(0.08)}}).mesh.triangles.size(), 2U);
}

TEST_P(HeldBack, WhereEverythingIsFreeNoBoundHoldsAnythingBack) {
    Mesh mesh = meshes::sphere(8);
    meshes::add_scalar(mesh, "f", [](glm::dvec3 p) { return p.x; });
    const Reduction reduction = reduce(mesh, {{"position", unbounded()}, {"*", unbounded()}});
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 10); // not 4: folds hold back too
    for (const VariableReport& variable : reduction.report.variables) EXPECT_EQ(variable.refused, 0U) << variable.name;
}

TEST_P(HeldBack, APeakOfAVariableStaysExactlyWhereItIsHigherThanItsBound) {
    const Mesh mesh = plane_with_peak_of_variable(5);
    EXPECT_TRUE(stays(reduce(mesh, {{"position", relative(1e-4)}, {"f", absolute(4.9)}}), middle));
    const Reduction gone = reduce(mesh, {{"position", relative(1e-4)}, {"f", absolute(5.1)}});
    EXPECT_FALSE(stays(gone, middle));
    EXPECT_EQ(gone.mesh.triangles.size(), 2U);
}

TEST_P(HeldBack, APeakOfAVectorCountsByItsLength) {
    Mesh mesh = meshes::plane(cells, cells);
    meshes::add_vector(mesh, "v", [](glm::dvec3) { return glm::dvec3(1, 1, 1); });
    auto& values = std::get<std::vector<double>>(mesh.variables[0].values);
    values[3 * middle] += 3;
    values[3 * middle + 1] -= 4;
    EXPECT_TRUE(stays(reduce(mesh, {{"v", absolute(4.99)}}, all_but_the_middle()), middle)) << "length 5";
    EXPECT_FALSE(stays(reduce(mesh, {{"v", absolute(5.01)}}, all_but_the_middle()), middle));
}

TEST_P(HeldBack, LockedVerticesStay) {
    const Mesh mesh = meshes::plane(cells, cells);
    const std::vector<std::uint32_t> locked = {middle, 3, 17, 77, 17};
    const Reduction reduction = reduce(mesh, {{"position", relative(0.5)}}, locked);
    for (const std::uint32_t vertex : locked) EXPECT_TRUE(stays(reduction, vertex)) << vertex;
    EXPECT_LE(reduction.vertices.size(), 4U + 4U) << "only what is locked, and the corners";
    guarantee::expect_everything(mesh, reduction, 2'000);
}

TEST_P(HeldBack, NothingChangesWhereEverythingIsLocked) {
    Mesh mesh = meshes::plane(cells, cells);
    meshes::add_usual_fields(mesh);
    std::vector<std::uint32_t> all(vertex_count(mesh));
    for (std::uint32_t v = 0; v < all.size(); ++v) all[v] = v;
    const Reduction reduction = reduce(mesh, {{"*", relative(1)}}, all);
    EXPECT_TRUE(guarantee::same_bits(reduction.mesh, mesh));
    EXPECT_EQ(reduction.report.refused.locked, all.size());
}

/// The value of variable 0 on a flat mesh above (x, y); for a place inside its outline.
double value_above(const Mesh& mesh, double x, double y) {
    double value = std::numeric_limits<double>::quiet_NaN(), deepest = -std::numeric_limits<double>::infinity();
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = meshes::point(mesh, t.x), b = meshes::point(mesh, t.y), c = meshes::point(mesh, t.z);
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const double u = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;
        const double v = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;
        const double depth = std::min({u, v, 1 - u - v});
        if (!(depth > deepest)) continue;
        deepest = depth;
        value = (1 - u - v) * value_at(mesh.variables[0], t.x, 0) + u * value_at(mesh.variables[0], t.y, 0) +
                v * value_at(mesh.variables[0], t.z, 0);
    }
    return value;
}

TEST_P(HeldBack, AJumpStaysAJumpWithinItsBound) {
    // 0 up to x = 0.5, 1 from x = 0.55; the space between is a ramp of slope 20. A point may move in the plane by the bound of
    // position, which is 20 times as much in the variable.
    constexpr double position_bound = 1e-3, slope = 20;
    Mesh mesh = meshes::flipped(meshes::plane(20, 20), 300, 5);
    meshes::add_scalar(mesh, "jump", meshes::jump_field(0.525));
    for (const double bound : {0.01, 0.1, 0.3}) {
        SCOPED_TRACE(bound);
        const Reduction reduction = reduce(mesh, {{"position", absolute(position_bound)}, {"jump", absolute(bound)}});
        EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 4);
        for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
            const glm::dvec3 p = meshes::point(mesh, v);
            EXPECT_NEAR(value_above(reduction.mesh, p.x, p.y), value_at(mesh.variables[0], v, 0),
                        bound + slope * std::sqrt(2.0) * position_bound)
                << p.x << ", " << p.y;
        }
        guarantee::expect_everything(mesh, reduction);
    }
}

TEST_P(HeldBack, AFreeVariableHoldsNothingBackAndItsErrorIsReported) {
    Mesh mesh = meshes::torus(36, 18);
    meshes::add_scalar(mesh, "wave", meshes::wave_field);
    const Reduction without = reduce(mesh, {{"position", relative(0.02)}, {"wave", relative(0.1)}});
    meshes::Random random(3);
    meshes::add_scalar(mesh, "noise", [&random](glm::dvec3) { return random.uniform(-1, 1); });
    for (const Bounds& bounds :
         {Bounds{{"position", relative(0.02)}, {"wave", relative(0.1)}},
          Bounds{
              {"*", relative(1e-6)}, {"position", relative(0.02)}, {"wave", relative(0.1)}, {"noise", unbounded()}}}) {
        const Reduction with = reduce(mesh, bounds);
        EXPECT_EQ(with.vertices, without.vertices);
        EXPECT_EQ(with.mesh.triangles, without.mesh.triangles);
        guarantee::expect_vertex_subset(mesh, with);
        const VariableReport& noise = with.report.variables[2];
        EXPECT_EQ(noise.ratio, 0);
        EXPECT_EQ(noise.refused, 0U);
        // The error is a bound for a free variable, too: as if it had been the bound, the judge agrees.
        EXPECT_GT(noise.error, 0.5);
        std::vector<double> as_bounds = guarantee::absolute_bounds(with);
        as_bounds[2] = noise.error;
        EXPECT_LE(judge::judge(mesh, with.mesh, as_bounds, 20'000).ratio(), 1 + guarantee::hair);
    }
}

TEST_P(HeldBack, AConstantVariableWithRoundingNoiseHoldsNothingBack) {
    Mesh mesh = meshes::torus(36, 18);
    const Bounds bounds = {{"*", relative(0.03)}};
    const std::size_t without = reduce(mesh, bounds).mesh.triangles.size();
    meshes::add_scalar(mesh, "density", meshes::constant_field(1250, 1e-7, 4));
    const Reduction with = reduce(mesh, bounds);
    EXPECT_LE(with.mesh.triangles.size(), without + without / 50);
    const ResolvedBound& bound = with.report.variables[1].bound;
    EXPECT_TRUE(bound.constant);
    EXPECT_NEAR(bound.absolute, 0.03 * 1250, 0.01);
    EXPECT_FALSE(with.report.variables[0].bound.constant);
}

TEST_P(HeldBack, AVariableOfZerosHoldsNothingBack) {
    Mesh mesh = meshes::torus(36, 18);
    const Bounds bounds = {{"*", relative(0.03)}};
    const Reduction without = reduce(mesh, bounds);
    meshes::add_scalar(mesh, "nothing", [](glm::dvec3) { return 0.0; });
    const Reduction with = reduce(mesh, bounds);
    EXPECT_EQ(with.vertices, without.vertices);
    EXPECT_EQ(with.report.variables[1].error, 0);
}

TEST_P(HeldBack, ASmallVariationThatIsNoRoundingNoiseStillCounts) {
    // One part in a thousand is no noise: the relative bound is one of the extent, not of the magnitude.
    Mesh mesh = meshes::plane(16, 16);
    meshes::add_scalar(mesh, "f", [](glm::dvec3 p) { return 1000 + meshes::wave_field(p); });
    const Reduction reduction = reduce(mesh, guarantee::percent(1, 5));
    EXPECT_FALSE(reduction.report.variables[1].bound.constant);
    EXPECT_NEAR(reduction.report.variables[1].bound.absolute, 0.05 * 2, 0.01);
    EXPECT_GT(reduction.mesh.triangles.size(), 10U);
    guarantee::expect_everything(mesh, reduction);
}

TEST_P(HeldBack, BoundaryVerticesMayGoToo) {
    const Mesh mesh = meshes::cylinder(60, 10);
    const Reduction reduction = reduce(mesh, {{"position", relative(0.03)}});
    std::size_t kept = 0;
    for (const auto& loop : meshes::boundary_loops(reduction.mesh)) kept += loop.size();
    EXPECT_LT(kept, 60U) << "of 120";
    guarantee::expect_everything(mesh, reduction);
}

} // namespace
