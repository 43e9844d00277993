// What stands at vertices that no triangle uses counts for nothing.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "judge/judge.hpp"
#include "meshbound/feature_size.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Behind the others a vertex that no triangle uses, with `value` for all that stands there, and another one that only a
/// triangle with a vertex twice uses.
Mesh with_strays(Mesh mesh, double value) {
    const auto stray = static_cast<std::uint32_t>(vertex_count(mesh));
    const auto append = [value](Values& values, int components) {
        auto& numbers = std::get<std::vector<double>>(values);
        numbers.insert(numbers.end(), 2 * static_cast<std::size_t>(components), value);
    };
    append(mesh.position.values, 3);
    for (Variable& variable : mesh.variables) append(variable.values, variable.components);
    mesh.triangles.push_back({0, stray + 1, stray + 1});
    if (!mesh.regions.empty()) mesh.regions.push_back(mesh.regions.front());
    return mesh;
}

Mesh bumpy(bool with_focus = false) {
    Mesh mesh = meshes::terrain(4, 3);
    meshes::add_scalar(mesh, "heat", meshes::wave_field);
    meshes::add_vector(mesh, "wind", meshes::whirl_field);
    if (with_focus) meshes::add_scalar(mesh, "focus", [](const glm::dvec3& p) { return 1 + p.x; });
    return mesh;
}

const Bounds bounds = {{"position", relative(0.02)}, {"*", relative(0.05)}};

/// Far off, at the middle, and no number at all.
const std::vector<double> strays = {-5e6, 0, 1e300, nan, infinity, -infinity};

TEST(UnusedVertices, ChangeNoExtentAndNoMagnitude) {
    const Mesh mesh = bumpy();
    std::vector<ResolvedBound> expected, resolved;
    ASSERT_TRUE(resolve_bounds(mesh, bounds, expected).ok());
    for (const double stray : strays) {
        SCOPED_TRACE(stray);
        ASSERT_TRUE(resolve_bounds(with_strays(mesh, stray), bounds, resolved).ok());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_EQ(resolved[i].extent, expected[i].extent);
            EXPECT_EQ(resolved[i].magnitude, expected[i].magnitude);
            EXPECT_EQ(resolved[i].absolute, expected[i].absolute);
            EXPECT_EQ(resolved[i].non_finite, 0U);
        }
    }
}

TEST(UnusedVertices, AVariableThatIsConstantWhereTrianglesAreIsConstant) {
    Mesh mesh = bumpy();
    meshes::add_scalar(mesh, "density", [](const glm::dvec3&) { return 7.0; });
    std::vector<ResolvedBound> resolved;
    ASSERT_TRUE(resolve_bounds(with_strays(mesh, -3), bounds, resolved).ok());
    EXPECT_TRUE(resolved.back().constant);
    EXPECT_EQ(resolved.back().absolute, 0.05 * 7);
}

TEST(UnusedVertices, AreCountedAndNeverRefused) {
    for (const double stray : strays) {
        MeshDefects defects;
        ASSERT_TRUE(validate(with_strays(bumpy(), stray), &defects).ok());
        EXPECT_EQ(defects.unused_vertices, 2U);
        EXPECT_EQ(defects.repeated_vertex_triangles, 1U);
    }
}

class UnusedVerticesTest : public ModeTest {};
EVERY_MODE(UnusedVerticesTest);

void expect_same_result(const Mesh& mesh, const Options& options) {
    const Reduction expected = guarantee::reduced(mesh, bounds, options);
    for (const double stray : strays) {
        SCOPED_TRACE(stray);
        const Mesh strayed = with_strays(mesh, stray);
        const Reduction reduction = guarantee::reduced(strayed, bounds, options);
        EXPECT_TRUE(guarantee::same_bits(reduction.mesh, expected.mesh));
        EXPECT_EQ(reduction.vertices, expected.vertices);
        for (std::size_t i = 0; i < expected.report.variables.size(); ++i)
            EXPECT_EQ(reduction.report.variables[i].error, expected.report.variables[i].error);
        for (std::size_t i = 0; i < reduction.vertex_errors.size(); ++i)
            EXPECT_EQ(reduction.vertex_errors[i].error.back(), 0);
        const std::vector<double> limits = guarantee::absolute_bounds(reduction);
        EXPECT_LE(judge::judge(strayed, reduction.mesh, limits, 5'000).ratio(), 1 + guarantee::hair);
        EXPECT_LE(judge::judge_boundary(strayed, reduction.mesh, limits, 5'000).ratio(), 1 + guarantee::hair);
    }
}

TEST_P(UnusedVerticesTest, ChangeNothingOfTheResult) { expect_same_result(bumpy(), GetParam().options()); }

TEST_P(UnusedVerticesTest, ChangeNothingWhereTheBoundsAreMultiplied) {
    Options options = GetParam().options();
    options.bound_multiplier = "focus";
    const Mesh mesh = bumpy(true);
    const Reduction expected = guarantee::reduced(mesh, bounds, options);
    for (const double stray : strays)
        EXPECT_TRUE(
            guarantee::same_bits(guarantee::reduced(with_strays(mesh, stray), bounds, options).mesh, expected.mesh));
}

TEST_P(UnusedVerticesTest, ChangeNothingOfWhatIsKeptOrLeftOut) {
    Options options = GetParam().options();
    options.drop_small_components = options.refuse_piercing = options.limit_to_feature_size = true;
    options.locked_boxes = {{{0, 0, -9}, {0.1, 0.1, 9}}};
    Mesh mesh = bumpy();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.regions.push_back(t % 2 ? 1 : 2);
    expect_same_result(mesh, options);
}

TEST(UnusedVertices, AreMetByNoBox) {
    Options options;
    options.locked_boxes = {{{-6e6, -6e6, -6e6}, {-4e6, -4e6, -4e6}}};
    const Reduction reduction = guarantee::reduced(with_strays(bumpy(), -5e6), bounds, options);
    EXPECT_EQ(reduction.report.unused_locked_boxes, (std::vector<std::size_t>{0}));
}

TEST(UnusedVertices, ChangeNoLevelAndNoMorph) {
    LevelOptions options;
    options.morphs = true;
    const std::vector<Bounds> steps = {{{"*", relative(0.01)}}, {{"*", relative(0.04)}}};
    Levels expected, levels;
    ASSERT_TRUE(reduce_levels(bumpy(), steps, options, expected).ok());
    for (const double stray : strays) {
        ASSERT_TRUE(reduce_levels(with_strays(bumpy(), stray), steps, options, levels).ok());
        for (std::size_t i = 0; i < steps.size(); ++i)
            EXPECT_TRUE(guarantee::same_bits(levels.levels[i].mesh, expected.levels[i].mesh));
    }
}

} // namespace
