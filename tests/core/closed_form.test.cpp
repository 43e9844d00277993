// Surfaces whose best reduction is known.

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/topology.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class ClosedForm : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds) const {
        return guarantee::reduced(mesh, bounds, GetParam().options());
    }
};
EVERY_MODE(ClosedForm);

std::set<std::tuple<double, double, double>> points(const Mesh& mesh) {
    std::set<std::tuple<double, double, double>> set;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
        const glm::dvec3 p = meshes::point(mesh, v);
        set.insert({p.x, p.y, p.z});
    }
    return set;
}

void expect_rectangle(const Reduction& reduction, double width, double height) {
    EXPECT_EQ(reduction.mesh.triangles.size(), 2U);
    EXPECT_EQ(points(reduction.mesh), points(meshes::plane(1, 1, width, height)));
}

TEST_P(ClosedForm, APlaneCollapsesToItsOutline) {
    for (const double bound : {1e-6, 0.01}) {
        SCOPED_TRACE(bound);
        const Mesh mesh = meshes::plane(16, 12, 2, 1);
        expect_rectangle(reduce(mesh, {{"position", relative(bound)}}), 2, 1);
        expect_rectangle(reduce(meshes::in_single(mesh), {{"position", relative(bound)}}), 2, 1);
    }
}

TEST_P(ClosedForm, APlaneWithLinearVariablesCollapsesToItsOutline) {
    Mesh mesh = meshes::plane(16, 8, 2, 1);
    meshes::add_scalar(mesh, "linear", meshes::linear_field);
    meshes::add_vector(mesh, "flow", [](glm::dvec3 p) { return glm::dvec3(p.x - p.y, 2 * p.y, 4 - p.x); });
    const Reduction reduction = reduce(mesh, guarantee::percent(1e-4, 1e-4));
    expect_rectangle(reduction, 2, 1);
    guarantee::expect_everything(mesh, reduction);
}

TEST_P(ClosedForm, AnIrregularPlaneInAnyDirectionCollapsesToItsOutline) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        SCOPED_TRACE(seed);
        Mesh mesh = meshes::shuffled(meshes::flipped(meshes::plane(16, 16), 1000, seed), seed);
        mesh = meshes::mapped(mesh, [](glm::dvec3 p) { return glm::dvec3(p.x + p.y, p.y - 2 * p.x, 3 * p.x + p.y); });
        meshes::add_scalar(mesh, "linear", meshes::linear_field);
        const Reduction reduction = reduce(mesh, guarantee::percent(1e-4, 1e-4));
        EXPECT_EQ(reduction.mesh.triangles.size(), 2U);
        guarantee::expect_everything(mesh, reduction, 2'000);
    }
}

TEST_P(ClosedForm, AFoldedSheetKeepsItsFold) {
    // Two rectangles that meet at a right angle: six corners, four triangles.
    const Mesh mesh = meshes::mapped(meshes::plane(16, 8, 2, 1),
                                     [](glm::dvec3 p) { return p.x <= 1 ? p : glm::dvec3(1, p.y, p.x - 1); });
    const Reduction reduction = reduce(mesh, {{"position", relative(1e-4)}});
    EXPECT_EQ(reduction.mesh.triangles.size(), 4U);
    const std::set<std::tuple<double, double, double>> corners = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1},
                                                                  {0, 1, 0}, {1, 1, 0}, {1, 1, 1}};
    EXPECT_EQ(points(reduction.mesh), corners);
}

TEST_P(ClosedForm, ACubeKeepsItsEdgesAndCorners) {
    for (const int cells : {4, 8, 16}) {
        SCOPED_TRACE(cells);
        const Reduction reduction = reduce(meshes::cube(cells), {{"position", relative(1e-4)}});
        EXPECT_EQ(reduction.mesh.triangles.size(), 12U);
        EXPECT_EQ(points(reduction.mesh), points(meshes::cube(1)));
        EXPECT_NEAR(meshes::enclosed_volume(reduction.mesh), 1, 1e-12);
    }
}

TEST_P(ClosedForm, APiercedPlateKeepsItsHoles) {
    // 4 corners of the plate and 4 a hole, above and below; a closed surface of genus h with v vertices has 2v - 4 + 4h
    // triangles.
    for (int holes = 1; holes <= 3; ++holes) {
        SCOPED_TRACE(holes);
        const Mesh mesh = meshes::pierced_plate(holes, 4);
        const Reduction reduction = reduce(mesh, {{"position", relative(1e-4)}});
        guarantee::expect_same_topology(mesh, reduction);
        const std::size_t corners = 8U + 8U * static_cast<unsigned>(holes);
        EXPECT_EQ(reduction.vertices.size(), corners);
        EXPECT_EQ(reduction.mesh.triangles.size(), 2 * corners - 4 + 4 * static_cast<unsigned>(holes));
        EXPECT_NEAR(meshes::enclosed_volume(reduction.mesh), meshes::enclosed_volume(mesh), 1e-9);
    }
}

TEST_P(ClosedForm, ASurfaceWithoutBoundsKeepsOnlyItsTopology) {
    // Everything free: a sphere ends as a tetrahedron or near it, and stays closed.
    Mesh mesh = meshes::sphere(6);
    const Reduction reduction = reduce(mesh, {});
    guarantee::expect_same_topology(mesh, reduction);
    guarantee::expect_vertex_subset(mesh, reduction);
    EXPECT_GE(reduction.mesh.triangles.size(), 4U);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 10);
}

TEST_P(ClosedForm, TheSmallestSurfacesStayAsTheyAre) {
    const Mesh triangle = meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(reduce(triangle, {{"position", relative(1)}}).mesh.triangles, triangle.triangles);
    const Mesh tetrahedron =
        meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
    EXPECT_EQ(reduce(tetrahedron, {{"position", relative(1)}}).mesh.triangles.size(), 4U);
}

} // namespace
