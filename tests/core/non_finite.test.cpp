// A variable without a bound may hold NaN and infinity: it holds nothing back, it goes out bit for bit, and nothing false is
// said of its error. With a bound it is refused.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Mesh bumpy() {
    Mesh mesh = meshes::terrain(4, 3);
    meshes::add_scalar(mesh, "heat", meshes::wave_field);
    return mesh;
}

/// With a variable more in front of the others that has holes, of some bits of NaN, and infinities.
Mesh with_holes(int components = 1) {
    Mesh mesh = bumpy();
    std::vector<double> values(vertex_count(mesh) * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<double>(i));
    values[7] = nan;
    values[40] = std::bit_cast<double>(std::uint64_t{0x7ff80000deadbeef});
    values[41] = infinity;
    values[90] = -infinity;
    mesh.variables.insert(mesh.variables.begin(), {"holes", components, values});
    return mesh;
}

const Bounds holes_free = {{"position", relative(0.02)}, {"holes", unbounded()}, {"*", relative(0.05)}};

class NonFiniteTest : public ModeTest {};
EVERY_MODE(NonFiniteTest);

TEST_P(NonFiniteTest, WithoutABoundChangesNothingOfTheRest) {
    const Reduction expected =
        guarantee::reduced(bumpy(), {{"position", relative(0.02)}, {"*", relative(0.05)}}, GetParam().options());
    for (const int components : {1, 2, 3}) {
        SCOPED_TRACE(components);
        const Mesh mesh = with_holes(components);
        const Reduction reduction = guarantee::reduced(mesh, holes_free, GetParam().options());
        EXPECT_EQ(reduction.vertices, expected.vertices);
        EXPECT_EQ(reduction.mesh.triangles, expected.mesh.triangles);
        EXPECT_TRUE(guarantee::same_bits(reduction.mesh.variables[0], gather(mesh.variables[0], reduction.vertices)));
        for (const std::size_t i : {0U, 2U}) {
            const std::size_t other = i == 0 ? 0 : 1;
            EXPECT_EQ(reduction.report.variables[i].error, expected.report.variables[other].error);
            EXPECT_EQ(reduction.triangle_errors[i].largest, expected.triangle_errors[other].largest);
        }
    }
}

TEST_P(NonFiniteTest, ItsErrorIsNotKnown) {
    const Mesh mesh = with_holes();
    const Reduction reduction = guarantee::reduced(mesh, holes_free, GetParam().options());
    const VariableReport& report = reduction.report.variables[1];
    EXPECT_TRUE(std::isnan(report.error));
    EXPECT_EQ(report.ratio, 0);
    EXPECT_EQ(report.bound.non_finite, 4U);
    EXPECT_EQ(report.bound.first_non_finite, 7U);
    EXPECT_TRUE(std::isfinite(report.bound.extent));
    const Variable& left = reduction.mesh.variables[0];
    for (std::size_t t = 0; t < reduction.mesh.triangles.size(); ++t) {
        const glm::uvec3& triangle = reduction.mesh.triangles[t];
        bool numbers = true;
        for (int i = 0; i < 3; ++i) numbers = numbers && std::isfinite(value_at(left, triangle[i], 0));
        EXPECT_TRUE(numbers || std::isnan(reduction.triangle_errors[1].largest[t])) << t;
        EXPECT_FALSE(std::isinf(reduction.triangle_errors[1].largest[t]));
    }
}

TEST(NonFinite, OfATriangleFarFromHolesTheTrackedErrorIsKnown) {
    const Reduction reduction = guarantee::reduced(with_holes(), holes_free);
    std::size_t known = 0;
    for (const float error : reduction.triangle_errors[1].largest) known += std::isfinite(error);
    EXPECT_GT(known, 0U);
    EXPECT_LT(known, reduction.triangle_errors[1].largest.size());
    const VertexErrors& errors = reduction.vertex_errors[1];
    for (const std::size_t hole : {7U, 40U, 41U, 90U}) EXPECT_TRUE(std::isnan(errors.error[hole])) << hole;
}

TEST(NonFinite, WithABoundItIsRefusedByVariableAndVertex) {
    for (const Bounds& given : {Bounds{{"*", relative(0.05)}}, Bounds{{"holes", absolute(1)}}}) {
        std::vector<ResolvedBound> resolved;
        Reduction reduction;
        for (const Status& status :
             {resolve_bounds(with_holes(2), given, resolved), reduce(with_holes(2), given, {}, reduction)}) {
            EXPECT_EQ(status.fault, Fault::non_finite_value);
            EXPECT_EQ(status.variable, "holes");
            EXPECT_EQ(status.index, 3U);
        }
        Levels levels;
        EXPECT_EQ(reduce_levels(with_holes(), {holes_free, given}, {}, levels).fault, Fault::non_finite_value);
    }
}

TEST(NonFinite, ItIsNoMultiplierOfTheBounds) {
    Mesh mesh = bumpy();
    meshes::add_scalar(mesh, "focus", [](const glm::dvec3&) { return 1.0; });
    std::get<std::vector<double>>(mesh.variables[1].values)[5] = infinity;
    Options options;
    options.bound_multiplier = "focus";
    Reduction reduction;
    const Status status = reduce(mesh, {{"position", relative(0.02)}}, options, reduction);
    EXPECT_EQ(status.fault, Fault::non_finite_value);
    EXPECT_EQ(status.variable, "focus");
    EXPECT_EQ(status.index, 5U);
}

TEST(NonFinite, NumbersFartherApartThanADoubleHoldsAreCarriedAlongToo) {
    Mesh mesh = bumpy();
    constexpr double largest = std::numeric_limits<double>::max();
    std::get<std::vector<double>>(mesh.variables[0].values)[4] = largest;
    std::get<std::vector<double>>(mesh.variables[0].values)[5] = -largest;
    const Reduction reduction = guarantee::reduced(mesh, {{"position", relative(0.02)}});
    EXPECT_TRUE(std::isnan(reduction.report.variables[1].error));
}

TEST(NonFinite, OnwardItStaysFreeAndUnknown) {
    Reduction reduction, onward;
    Checkpoint checkpoint;
    ASSERT_TRUE(reduce(with_holes(), holes_free, {}, reduction, {}, &checkpoint).ok());
    const Bounds looser = {{"position", relative(0.04)}, {"holes", unbounded()}, {"*", relative(0.1)}};
    ASSERT_TRUE(resume_reduction(checkpoint, looser, {}, onward).ok());
    EXPECT_TRUE(std::isnan(onward.report.variables[1].error));
    EXPECT_TRUE(std::isfinite(onward.report.variables[2].error));
    const Status status = resume_reduction(checkpoint, {{"*", relative(0.1)}}, {}, onward);
    EXPECT_EQ(status.fault, Fault::non_finite_value);
    EXPECT_EQ(status.variable, "holes");
    EXPECT_EQ(status.index, 7U) << "of the original";
}

TEST(NonFinite, AMorphHasItAtItsEnds) {
    LevelOptions options;
    options.morphs = true;
    Levels levels;
    const Mesh mesh = with_holes();
    ASSERT_TRUE(reduce_levels(mesh, {holes_free}, options, levels).ok());
    const Mesh start = morphed(levels.morphs[0], 0);
    std::vector<std::uint32_t> first(vertex_count(mesh));
    for (std::uint32_t v = 0; v < first.size(); ++v) first[v] = v;
    EXPECT_TRUE(guarantee::same_bits(gather(start.variables[0], first), mesh.variables[0]));
}

} // namespace
