// Why vertices are left: each is counted once, for the reason that it has.

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class Refused : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds, const Options& more = {}) const {
        Options options = more;
        options.errors = GetParam().options().errors;
        options.cost = GetParam().options().cost;
        const Reduction reduction = guarantee::reduced(mesh, bounds, options);
        expect_counted_once(reduction);
        return reduction;
    }

private:
    static void expect_counted_once(const Reduction& reduction) {
        const Report& report = reduction.report;
        const Refusals& refused = report.refused;
        std::size_t all =
            refused.non_manifold + refused.locked + refused.ring + refused.topology + refused.fold + refused.piercing;
        for (const VariableReport& variable : report.variables) all += variable.refused;
        EXPECT_EQ(all, report.vertices_after);
    }
};
EVERY_MODE(Refused);

const Bounds everything_free = {{"position", unbounded()}, {"*", unbounded()}};

/// Two points above and below a ring, joined with all of it.
Mesh bipyramid(std::uint32_t around) {
    std::vector<glm::dvec3> points = {{0, 0, 1}, {0, 0, -1}};
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t i = 0; i < around; ++i) {
        const double angle = 6.283185307179586 * i / around;
        points.emplace_back(std::cos(angle), std::sin(angle), 0);
        const std::uint32_t here = 2 + i, next = 2 + (i + 1) % around;
        triangles.push_back({0, here, next});
        triangles.push_back({1, next, here});
    }
    return meshes::from_points(points, triangles);
}

TEST_P(Refused, ARingOfMoreThan48IsToldFromTopology) {
    Options options;
    for (std::uint32_t v = 2; v < 2 + 200; ++v) options.locked.push_back(v);
    const Reduction reduction = reduce(bipyramid(200), everything_free, options);
    EXPECT_EQ(reduction.report.candidates, 202U);
    EXPECT_EQ(reduction.report.refused.ring, 2U);
    EXPECT_EQ(reduction.report.refused.locked, 200U);
    EXPECT_EQ(reduction.report.refused.topology, 0U);
}

TEST_P(Refused, ATetrahedronIsHeldByItsTopology) {
    const Mesh mesh =
        meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    EXPECT_EQ(reduce(mesh, everything_free).report.refused.topology, 4U);
}

TEST_P(Refused, WhereCurvesMeetEverywhereNothingGoes) {
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles; // every three of seven points
    for (std::uint32_t a = 0; a < 7; ++a) {
        points.emplace_back(std::cos(a), std::sin(2 * a), 0.3 * a);
        for (std::uint32_t b = a + 1; b < 7; ++b)
            for (std::uint32_t c = b + 1; c < 7; ++c) triangles.push_back({a, b, c});
    }
    Options options;
    options.locked = {3}; // it could not go anyway
    const Report report = reduce(meshes::from_points(points, triangles), everything_free, options).report;
    EXPECT_EQ(report.refused.non_manifold, 7U);
    EXPECT_EQ(report.refused.locked, 0U);
}

TEST_P(Refused, AllLockedByABoxAreLocked) {
    Options options;
    options.locked_boxes = {{{-9, -9, -9}, {9, 9, 9}}};
    const Report report = reduce(meshes::torus(12, 8), everything_free, options).report;
    EXPECT_EQ(report.refused.locked, 96U);
    EXPECT_EQ(report.candidates, 96U);
}

TEST_P(Refused, WhatIsFreeIsHeldByFoldsAndNoBound) {
    const Report report = reduce(meshes::pleats(6, 6), everything_free).report;
    for (const VariableReport& variable : report.variables) EXPECT_EQ(variable.refused, 0U);
    const Report round = reduce(meshes::noisy_sphere(8, 0.4, 3), everything_free).report;
    EXPECT_GT(round.refused.fold, 0U);
}

TEST_P(Refused, WhatBoundsHoldIsCountedWithThem) {
    const Mesh mesh = meshes::sphere(8);
    const Report report = reduce(mesh, {{"position", relative(1e-9)}}).report;
    EXPECT_EQ(report.variables[0].refused, vertex_count(mesh));
    EXPECT_EQ(report.candidates, vertex_count(mesh));
}

TEST_P(Refused, WhatWouldFoldWhateverTheBoundIsCountedAsFold) {
    const Mesh mesh = meshes::noisy_sphere(8, 0.2, 3);
    const Report report = reduce(mesh, {{"position", relative(1e-9)}}).report;
    EXPECT_GT(report.refused.fold, 0U) << "around some of its spikes any filling folds";
    EXPECT_EQ(report.variables[0].refused + report.refused.fold, vertex_count(mesh));
    EXPECT_GT(report.variables[0].refused, 40 * report.refused.fold);
}

TEST_P(Refused, PointsOfNoTriangleAreNoCandidates) {
    Mesh mesh = meshes::from_points({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 2, 3}});
    EXPECT_EQ(reduce(mesh, everything_free).report.candidates, 3U);
}

TEST_P(Refused, PointsOfDroppedPartsAreNoCandidates) {
    Mesh mesh = meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {5.001, 0, 0}, {5, 0.001, 0}},
                                    {{0, 1, 2}, {3, 4, 5}});
    Options options;
    options.drop_small_components = true;
    EXPECT_EQ(reduce(mesh, {{"position", absolute(0.01)}}, options).report.candidates, 3U);
}

} // namespace
