// The report says what happened, and its figures agree with each other.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class ReportTest : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds = guarantee::percent(2, 6)) const {
        return guarantee::reduced(mesh, bounds, GetParam().options());
    }
};
EVERY_MODE(ReportTest);

/// Single precision, in which errors of triangles are given.
constexpr double single_rounding = 1e-6;

void expect_errors_within_bounds(const Reduction& reduction) {
    for (const VariableReport& variable : reduction.report.variables) {
        SCOPED_TRACE(variable.name);
        EXPECT_GE(variable.error, 0);
        if (std::isinf(variable.bound.absolute)) {
            EXPECT_EQ(variable.ratio, 0);
            EXPECT_EQ(variable.refused, 0U);
            continue;
        }
        EXPECT_LE(variable.ratio, 1);
        EXPECT_LE(variable.error, variable.bound.absolute);
        EXPECT_NEAR(variable.error / variable.bound.absolute, variable.ratio, 1e-12);
    }
}

void expect_every_vertex_has_its_reason(const Report& report) {
    std::size_t reasons = report.refused.non_manifold + report.refused.locked + report.refused.ring +
                          report.refused.topology + report.refused.fold;
    for (const VariableReport& variable : report.variables) reasons += variable.refused;
    EXPECT_EQ(reasons, report.vertices_after);
}

void expect_triangle_errors(const Mesh& mesh, const Reduction& reduction) {
    const std::size_t triangles = reduction.mesh.triangles.size();
    ASSERT_EQ(reduction.triangle_errors.size(), 1 + mesh.variables.size());
    for (std::size_t i = 0; i < reduction.triangle_errors.size(); ++i) {
        const VariableReport& variable = reduction.report.variables[i];
        SCOPED_TRACE(variable.name);
        const TriangleErrors& errors = reduction.triangle_errors[i];
        const bool is_signed = i == 0 || variable.components == 1;
        ASSERT_EQ(errors.largest.size(), triangles);
        ASSERT_EQ(errors.lowest.size(), is_signed ? triangles : 0);
        ASSERT_EQ(errors.highest.size(), is_signed ? triangles : 0);
        const double largest = *std::max_element(errors.largest.begin(), errors.largest.end());
        EXPECT_GE(largest, variable.error) << "rounded up";
        EXPECT_LE(largest, variable.error * (1 + single_rounding));
        ASSERT_EQ(errors.ratio.size(), triangles);
        const double ratio = *std::max_element(errors.ratio.begin(), errors.ratio.end());
        EXPECT_GE(ratio, variable.ratio) << "rounded up";
        EXPECT_LE(ratio, variable.ratio * (1 + single_rounding));
        for (std::size_t t = 0; is_signed && t < triangles; ++t) {
            EXPECT_LE(errors.lowest[t], errors.highest[t]);
            if (i == 0) continue;
            EXPECT_NEAR(std::max(-errors.lowest[t], errors.highest[t]), errors.largest[t],
                        single_rounding * variable.bound.extent);
        }
    }
}

TEST_P(ReportTest, AgreesWithItselfOverEveryKindOfSurface) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Reduction reduction = reduce(exhibit.mesh);
        const Report& report = reduction.report;
        EXPECT_EQ(report.triangles_before, exhibit.mesh.triangles.size());
        EXPECT_EQ(report.vertices_before, vertex_count(exhibit.mesh));
        EXPECT_EQ(report.triangles_after, reduction.mesh.triangles.size());
        EXPECT_EQ(report.vertices_after, reduction.vertices.size());
        EXPECT_EQ(report.termination, Termination::finished);
        EXPECT_EQ(report.non_manifold_vertices, 0U);
        ASSERT_EQ(report.variables.size(), 1 + exhibit.mesh.variables.size());
        EXPECT_EQ(report.variables[0].name, "position");
        for (std::size_t i = 0; i < exhibit.mesh.variables.size(); ++i) {
            EXPECT_EQ(report.variables[i + 1].name, exhibit.mesh.variables[i].name);
            EXPECT_EQ(report.variables[i + 1].components, exhibit.mesh.variables[i].components);
        }
        expect_errors_within_bounds(reduction);
        expect_every_vertex_has_its_reason(report);
        expect_triangle_errors(exhibit.mesh, reduction);
    }
}

TEST_P(ReportTest, UsesMostOfTheBoundsThatHoldItBack) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        EXPECT_GT(guarantee::largest_ratio(reduce(exhibit.mesh)), 0.8);
    }
}

TEST_P(ReportTest, NamesTheVariableThatHoldsBack) {
    // A plane with a spike of one variable at every sixth vertex of every sixth row: 16 vertices that only it holds.
    Mesh mesh = meshes::plane(24, 24);
    meshes::add_scalar(mesh, "calm", meshes::linear_field);
    meshes::add_scalar(mesh, "wild", [](glm::dvec3 p) {
        return std::lround(24 * p.x) % 6 == 3 && std::lround(24 * p.y) % 6 == 3 ? 1 : 0;
    });
    const Report report =
        reduce(mesh, {{"position", relative(0.01)}, {"calm", relative(0.1)}, {"wild", absolute(0.5)}}).report;
    EXPECT_GE(report.variables[2].refused, 16U);
    EXPECT_EQ(report.variables[1].refused, 0U);
}

TEST_P(ReportTest, TellsTheErrorsOfASurfaceThatStaysAsItIs) {
    const Mesh mesh = meshes::noisy_sphere(6, 0.1, 1);
    const Reduction reduction = reduce(mesh, {{"position", relative(1e-9)}});
    EXPECT_EQ(reduction.report.variables[0].error, 0);
    EXPECT_EQ(reduction.report.variables[0].refused, reduction.report.vertices_after);
    for (const float error : reduction.triangle_errors[0].largest) EXPECT_EQ(error, 0);
}

TEST_P(ReportTest, TheErrorsOfEachTriangleHoldOnThatTriangle) {
    // Judged triangle by triangle: from its points some point of the original is no farther, in any variable, than the
    // errors that the report gives this very triangle.
    Mesh mesh = meshes::torus(24, 12);
    meshes::add_scalar(mesh, "wave", meshes::wave_field);
    meshes::add_vector(mesh, "whirl", meshes::whirl_field);
    const Reduction reduction = reduce(mesh, guarantee::percent(4, 10));
    for (std::size_t t = 0; t < reduction.mesh.triangles.size(); ++t) {
        SCOPED_TRACE(t);
        std::vector<double> bounds;
        for (std::size_t i = 0; i < reduction.triangle_errors.size(); ++i)
            bounds.push_back(reduction.triangle_errors[i].largest[t] +
                             1e-5 * reduction.report.variables[i].bound.extent);
        Mesh alone = reduction.mesh;
        alone.triangles = {reduction.mesh.triangles[t]};
        EXPECT_LE(judge::judge(mesh, alone, bounds, 200).from_reduced.ratio, 1 + guarantee::hair);
    }
}

TEST_P(ReportTest, CountsFixedVertices) {
    const Mesh mesh = meshes::three_sheets(6);
    const Report report = reduce(mesh).report;
    EXPECT_EQ(report.non_manifold_vertices, 7U);
    EXPECT_EQ(report.refused.non_manifold, 2U) << "the ends of the line in which they meet";
    expect_every_vertex_has_its_reason(report);
}

TEST_P(ReportTest, SaysHowMuchOfEachRegionIsLeft) {
    // Two squares of labels 5 and -2 on a plane, and a crumb of label 9, which may go.
    const Mesh plane = meshes::plane(8, 8, 2, 1);
    const std::size_t on_plane = plane.triangles.size();
    for (const double unit : {1.0, 0x1p-400, 0x1p400}) {
        Mesh mesh =
            meshes::mapped(meshes::joined(plane, meshes::mapped(meshes::plane(1, 1, 1e-3, 1e-3),
                                                                [](glm::dvec3 p) { return p + glm::dvec3(0, 0, 1); })),
                           [unit](glm::dvec3 p) { return unit * p; });
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            double x = 0;
            for (int i = 0; i < 3; ++i) x += meshes::point(mesh, mesh.triangles[t][i]).x / unit / 3;
            mesh.regions.push_back(t >= on_plane ? 9 : x < 1 ? 5 : -2);
        }
        Options options = GetParam().options();
        options.drop_small_components = true;
        const Report report = guarantee::reduced(mesh, {{"position", relative(0.01)}}, options).report;
        ASSERT_EQ(report.regions.size(), 3U);
        const RegionReport &right = report.regions[0], &left = report.regions[1], &crumb = report.regions[2];
        EXPECT_EQ(std::vector({right.label, left.label, crumb.label}), std::vector({-2, 5, 9}));
        for (const RegionReport& half : {right, left}) {
            EXPECT_EQ(half.triangles_before, on_plane / 2);
            EXPECT_EQ(half.triangles_after, 2U);
            EXPECT_EQ(half.area_before / unit / unit, 1);
            EXPECT_EQ(half.area_after / unit / unit, 1);
        }
        EXPECT_EQ(crumb.triangles_before, 2U);
        EXPECT_EQ(crumb.triangles_after, 0U);
        EXPECT_NEAR(crumb.area_before / unit / unit, 1e-6, 1e-12);
        EXPECT_EQ(crumb.area_after, 0);
    }
    EXPECT_TRUE(reduce(plane).report.regions.empty());
}

} // namespace
