// The feature size (§3.2.3): the smallest distance between two lobes that face each other.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/near_lobes.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "self_intersection/self_intersections.hpp"

namespace {

using namespace meshbound;

Mesh lifted(const Mesh& mesh, double by) {
    return meshes::mapped(mesh, [by](glm::dvec3 p) { return p + glm::dvec3(0, 0, by); });
}

TEST(FeatureSizeTest, OfTwoEvenSheetsIsTheirDistance) {
    const Mesh sheet = meshes::plane(12, 10);
    const Mesh mesh = meshes::joined(sheet, meshes::flipped(lifted(sheet, 0.07), 100, 1));
    ASSERT_TRUE(feature_size(mesh, 1).has_value());
    EXPECT_NEAR(*feature_size(mesh, 1), 0.07, 1e-12);
    EXPECT_FALSE(feature_size(mesh, 0.07).has_value()) << "looked for below only";
}

TEST(FeatureSizeTest, OfASlabIsItsThickness) {
    const Mesh slab = meshes::mapped(meshes::cube(8), [](glm::dvec3 p) { return glm::dvec3(p.x, p.y, 0.05 * p.z); });
    ASSERT_TRUE(feature_size(slab, 1).has_value());
    EXPECT_NEAR(*feature_size(slab, 1), 0.05, 1e-12);
}

/// Chords and the sagging of edges between curved walls make it a little less or more than the gap.
TEST(FeatureSizeTest, OfNearLobesIsAboutTheirGap) {
    EXPECT_NEAR(feature_size(meshes::nested_spheres(16, 0.1), 1).value_or(0), 0.1, 0.02);
    const Mesh spiral = meshes::grid(240, 6, [](double u, double v) {
        const double angle = 6 * std::numbers::pi * u, radius = 0.3 + 0.3 * u;
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), 0.5 * v);
    });
    EXPECT_NEAR(feature_size(spiral, 1).value_or(0), 0.1, 0.01);
    EXPECT_NEAR(feature_size(meshes::self_passing_tube(120, 24, 0.05), 0.2).value_or(0), 0.05, 0.01);
}

TEST(FeatureSizeTest, OfOneLobeIsNothing) {
    EXPECT_FALSE(feature_size(meshes::plane(20, 20), 1).has_value());
    EXPECT_FALSE(feature_size(meshes::pleats(4, 6), 0.3).has_value()) << "the sides of a groove meet at its bottom";
    EXPECT_FALSE(feature_size(meshes::terrain(5, 3), 0.3).has_value()) << "a height field";
}

TEST(FeatureSizeTest, IsNotTheMeetingOfASeam) {
    const Mesh left = meshes::plane(8, 8);
    const Mesh right = meshes::mapped(left, [](glm::dvec3 p) { return p + glm::dvec3(1, 0, 0); });
    EXPECT_FALSE(feature_size(meshes::joined(left, right), 0.5).has_value());
}

TEST(FeatureSizeTest, GrowsWithTheMesh) {
    const Mesh small = meshes::nested_spheres(8, 0.2);
    const Mesh large = meshes::mapped(small, [](glm::dvec3 p) { return 1024.0 * p; });
    EXPECT_EQ(1024 * feature_size(small, 1).value(), feature_size(large, 1024).value());
}

/// Found by the fuzzer: products of such coordinates are beyond any double.
TEST(FeatureSizeTest, IsFoundInAnyUnit) {
    const Mesh mesh = meshes::nested_spheres(8, 0.2);
    const double size = feature_size(mesh, 1).value();
    for (const double unit : {0x1p-1000, 0x1p-600, 0x1p600, 0x1p1000}) {
        const Mesh scaled = meshes::mapped(mesh, [unit](glm::dvec3 p) { return unit * p; });
        EXPECT_EQ(feature_size(scaled, unit).value_or(0), unit * size) << unit;
    }
}

/// Found by the fuzzer: a box without end met empty ones.
TEST(FeatureSizeTest, IsLookedForHoweverFar) {
    const Mesh mesh = meshes::nested_spheres(7, 0.2);
    for (const double within : {1e300, std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(feature_size(mesh, within), feature_size(mesh, 1)) << within;
    EXPECT_FALSE(feature_size(meshes::plane(5, 5), std::numeric_limits<double>::infinity()).has_value());
}

TEST(FeatureSizeTest, IsCalledOffAtAnyTime) {
    const Mesh mesh = meshes::nested_spheres(12, 0.1);
    std::vector<double> progress;
    const auto record = [&](double reached) {
        progress.push_back(reached);
        return true;
    };
    ASSERT_TRUE(feature_size(mesh, 1, record).has_value());
    ASSERT_GT(progress.size(), 10U);
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
    EXPECT_LE(progress.back(), 1);
    for (const std::size_t last_call : {std::size_t{0}, progress.size() / 2, progress.size() - 1}) {
        std::size_t call = 0;
        EXPECT_FALSE(feature_size(mesh, 1, [&](double) { return call++ < last_call; }).has_value());
        EXPECT_EQ(call, last_call + 1) << "asked again after it was told to stop";
    }
}

/// Half of it, because both lobes may move.
TEST(FeatureLimitTest, LimitsTheBoundOfPosition) {
    Options options;
    options.limit_to_feature_size = true;
    for (const meshes::Exhibit& exhibit : meshes::near_lobes()) {
        SCOPED_TRACE(exhibit.name);
        const Reduction reduction = guarantee::reduced(exhibit.mesh, {{"position", relative(0.02)}}, options);
        ASSERT_TRUE(reduction.report.feature_size.has_value());
        EXPECT_EQ(reduction.report.variables[0].bound.absolute, *reduction.report.feature_size / 2);
        EXPECT_TRUE(judge::self_intersections(reduction.mesh).empty());
        EXPECT_LT(reduction.mesh.triangles.size(), exhibit.mesh.triangles.size());
        guarantee::expect_everything(exhibit.mesh, reduction);
    }
}

TEST(FeatureLimitTest, TheSearchForItIsPartOfTheProgress) {
    Options options;
    options.limit_to_feature_size = true;
    const Mesh mesh = meshes::nested_spheres(12, 0.1);
    const Bounds bounds = {{"position", relative(0.2)}};
    std::vector<double> progress;
    Reduction reduction;
    ASSERT_TRUE(reduce(mesh, bounds, options, reduction, [&](double reached) {
                    progress.push_back(reached);
                    return true;
                }).ok());
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
    EXPECT_EQ(progress.back(), 1);
    const auto in_search = [](double reached) { return 0 < reached && reached < 0.1; };
    ASSERT_GT(std::count_if(progress.begin(), progress.end(), in_search), 3);
    std::size_t calls = 0;
    ASSERT_TRUE(reduce(mesh, bounds, options, reduction, [&](double reached) {
                    ++calls;
                    return !in_search(reached);
                }).ok());
    EXPECT_EQ(reduction.report.termination, Termination::cancelled);
    EXPECT_EQ(reduction.mesh.triangles.size(), mesh.triangles.size());
    EXPECT_LT(calls, progress.size());
}

TEST(FeatureLimitTest, LeavesAFinerBound) {
    Options options;
    options.limit_to_feature_size = true;
    const Mesh mesh = meshes::two_sheets(20, 0.05);
    const Reduction fine = guarantee::reduced(mesh, {{"position", absolute(0.001)}}, options);
    EXPECT_FALSE(fine.report.feature_size.has_value());
    EXPECT_EQ(fine.report.variables[0].bound.absolute, 0.001);
}

/// There is nothing to limit: the lobes may pierce each other, against what was asked for.
TEST(FeatureLimitTest, OfAFreePositionIsRefused) {
    LevelOptions options;
    options.reduction.limit_to_feature_size = true;
    const Mesh mesh = meshes::two_sheets(6, 0.05);
    Reduction reduction;
    for (const Bounds& bounds : {Bounds{}, Bounds{{"*", relative(0.1)}, {"position", unbounded()}}}) {
        const Status status = reduce(mesh, bounds, options.reduction, reduction);
        EXPECT_EQ(status.fault, Fault::bad_option);
        EXPECT_EQ(status.variable, "position");
    }
    Levels levels;
    const Bounds bounded = {{"position", relative(0.01)}};
    const Status status = reduce_levels(mesh, {bounded, Bounds{}}, options, levels);
    EXPECT_EQ(status.fault, Fault::bad_option);
    EXPECT_EQ(status.variable, "position");
    EXPECT_EQ(status.message.rfind("Of level 2: ", 0), 0U) << status.message;
}

TEST(FeatureLimitTest, HoldsInEveryLevel) {
    LevelOptions options;
    options.reduction.limit_to_feature_size = true;
    const Mesh mesh = meshes::two_sheets(20, 0.02);
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, {guarantee::percent(0.1, 1), guarantee::percent(2, 1), guarantee::percent(5, 1)},
                              options, levels)
                    .ok());
    const double size = levels.levels[0].report.feature_size.value();
    EXPECT_LT(levels.levels[0].report.variables[0].bound.absolute, size / 2);
    EXPECT_EQ(levels.levels[1].report.variables[0].bound.absolute, size / 2);
    EXPECT_EQ(levels.levels[2].report.variables[0].bound.absolute, size / 2);
}

} // namespace
