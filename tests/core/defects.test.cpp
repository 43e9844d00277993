// Unusual meshes that are no error: reduced as far as they go, counted, kept as they are where they are odd.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class OddMeshes : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds = guarantee::percent(3, 10)) const {
        return guarantee::reduced(mesh, bounds, GetParam().options());
    }
};
EVERY_MODE(OddMeshes);

Mesh with_fields(Mesh mesh) {
    meshes::add_usual_fields(mesh);
    return mesh;
}

TEST_P(OddMeshes, ThreeSheetsStayJoinedInTheirLineWhileItShrinks) {
    const Mesh mesh = with_fields(meshes::three_sheets(8));
    const Reduction reduction = reduce(mesh);
    guarantee::expect_everything(mesh, reduction);
    EXPECT_EQ(reduction.report.non_manifold_vertices, 9U);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size());
    const Reduction flat = reduce(meshes::three_sheets(8), {{"position", relative(1e-4)}});
    EXPECT_EQ(flat.mesh.triangles.size(), 6U) << "two for each sheet";
    EXPECT_EQ(meshes::topology(flat.mesh).non_manifold_edges, 1U);
}

TEST_P(OddMeshes, TwoCubesOnOneEdgeKeepIt) {
    const Mesh mesh = meshes::cubes_on_one_edge(4);
    const Reduction reduction = reduce(mesh, {{"position", relative(1e-4)}});
    guarantee::expect_everything(mesh, reduction);
    EXPECT_EQ(meshes::topology(reduction.mesh).non_manifold_edges, 1U);
    EXPECT_NEAR(meshes::enclosed_volume(reduction.mesh), meshes::enclosed_volume(mesh), 1e-9);
    EXPECT_EQ(reduction.mesh.triangles.size(), 24U) << "two cubes";
}

TEST_P(OddMeshes, ATetrahedronBetweenFinsIsNotFlattened) {
    // Three triangles on each edge of its base, so that base and tip are on different sheets; without its tip the base would
    // be there twice.
    const Mesh mesh =
        meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.1}, {0.5, -1, 0}, {1, 1, 0}, {-1, 0.5, 0}},
                            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 5}, {0, 2, 6}});
    const Reduction reduction = reduce(mesh, {{"position", unbounded()}});
    guarantee::expect_vertex_subset(mesh, reduction);
    std::set<std::set<std::uint32_t>> different;
    for (const glm::uvec3& t : reduction.mesh.triangles) different.insert({t.x, t.y, t.z});
    EXPECT_EQ(different.size(), reduction.mesh.triangles.size()) << "a triangle is there twice";
}

TEST_P(OddMeshes, ABowTieKeepsItsKnot) {
    const Mesh mesh = with_fields(meshes::bow_tie(8));
    const Reduction reduction = reduce(mesh);
    guarantee::expect_vertex_subset(mesh, reduction);
    EXPECT_EQ(meshes::topology(reduction.mesh), meshes::topology(mesh));
    guarantee::expect_judge_agrees(mesh, reduction);
    EXPECT_EQ(reduction.report.non_manifold_vertices, 1U);
    EXPECT_TRUE(std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), 80U)) << "the shared corner";
}

TEST_P(OddMeshes, ANonOrientableBandIsNoError) {
    const Mesh mesh = with_fields(meshes::moebius_band(40, 6));
    const Reduction reduction = reduce(mesh);
    guarantee::expect_everything(mesh, reduction);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
}

TEST_P(OddMeshes, DegenerateTrianglesAreReducedAsUsual) {
    for (const Mesh& plain : {meshes::sphere(8), meshes::plane(12, 12), meshes::cube(6)}) {
        const Mesh mesh = meshes::with_degenerate_triangles(with_fields(plain));
        const Reduction reduction = reduce(mesh);
        guarantee::expect_everything(mesh, reduction);
        EXPECT_GT(reduction.report.defects.zero_area_triangles, 0U);
        EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() * 3 / 4);
    }
}

TEST_P(OddMeshes, CoincidentVerticesGoWhereTheyCarryNothingNew) {
    // Vertices on top of others, in a plane. The stars of some of them have no direction to be laid out in, and stay.
    const Mesh mesh = meshes::with_degenerate_triangles(meshes::plane(8, 8));
    const Reduction reduction = reduce(mesh, {{"position", relative(1e-4)}});
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 3);
}

TEST_P(OddMeshes, TrianglesWithAVertexTwiceAreLeftOutAndCounted) {
    Mesh mesh = with_fields(meshes::sphere(6));
    const Mesh plain = mesh;
    mesh.triangles.insert(mesh.triangles.begin(), {5, 5, 7});
    mesh.triangles.push_back({1, 2, 1});
    mesh.triangles.push_back({3, 3, 3});
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.repeated_vertex_triangles, 3U);
    EXPECT_EQ(reduction.report.triangles_before, mesh.triangles.size());
    guarantee::expect_everything(plain, reduction);
    EXPECT_EQ(reduction.vertices, reduce(plain).vertices);
}

TEST_P(OddMeshes, UnusedVerticesAreLeftOutAndCounted) {
    Mesh mesh = with_fields(meshes::sphere(8));
    mesh = meshes::cut(mesh, [](glm::dvec3 p) { return p.z < 0.3; });
    const Reduction reduction = reduce(mesh);
    std::set<std::uint32_t> used;
    for (const glm::uvec3& t : mesh.triangles) used.insert({t.x, t.y, t.z});
    EXPECT_EQ(reduction.report.defects.unused_vertices, vertex_count(mesh) - used.size());
    guarantee::expect_everything(mesh, reduction);
}

TEST_P(OddMeshes, ATriangleThatIsThereTwiceIsNoError) {
    const Mesh once = with_fields(meshes::plane(8, 8));
    Mesh mesh = once;
    mesh.triangles.push_back(mesh.triangles[60]);
    const Reduction reduction = reduce(mesh);
    guarantee::expect_vertex_subset(mesh, reduction);
    guarantee::expect_judge_agrees(mesh, reduction);
    EXPECT_EQ(reduction.report.defects.copied_triangles, 1U);
    EXPECT_EQ(meshes::topology(reduction.mesh), meshes::topology(once)) << "the copy is left out";
}

TEST_P(OddMeshes, NeedlesAndTinyTrianglesGiveTheGuarantee) {
    // A plane whose columns crowd together by a factor of ten thousand, bent.
    Mesh mesh = meshes::mapped(meshes::plane(24, 24), [](glm::dvec3 p) {
        return glm::dvec3(std::pow(10.0, 4 * (p.x - 1)), p.y, std::sin(3 * p.y));
    });
    mesh = with_fields(meshes::flipped(mesh, 500, 3));
    guarantee::expect_everything(mesh, reduce(mesh));
}

TEST_P(OddMeshes, ASurfaceFoldedFlatOntoItselfGivesTheGuarantee) {
    // Two layers in one plane, joined at a crease of 180 degrees.
    Mesh mesh = meshes::mapped(meshes::plane(16, 8, 2, 1),
                               [](glm::dvec3 p) { return p.x <= 1 ? p : glm::dvec3(2 - p.x, p.y, 0); });
    mesh = with_fields(mesh);
    guarantee::expect_everything(mesh, reduce(mesh));
}

TEST_P(OddMeshes, AllVerticesInOnePlaceKeepTheirTopology) {
    Mesh mesh = meshes::mapped(meshes::sphere(4), [](glm::dvec3) { return glm::dvec3(1, 2, 3); });
    const Reduction reduction = reduce(mesh, {{"*", relative(0.1)}});
    guarantee::expect_same_topology(mesh, reduction);
    guarantee::expect_vertex_subset(mesh, reduction);
}

TEST_P(OddMeshes, SpecialNumbersComeThroughBitForBit) {
    Mesh mesh = meshes::plane(4, 4);
    meshes::add_scalar(mesh, "special", [](glm::dvec3 p) {
        return p.x == 0 ? -0.0 : p.x == 1 ? std::numeric_limits<double>::denorm_min() : p.y;
    });
    mesh.variables.push_back({"single", 1, std::vector<float>(25, -0.0F)});
    mesh.variables.push_back({"pair", 2, std::vector<float>(50, std::numeric_limits<float>::denorm_min())});
    guarantee::expect_vertex_subset(mesh, reduce(mesh, {{"position", relative(0.1)}}));
}

TEST_P(OddMeshes, HugeAndTinyValuesGiveTheGuarantee) {
    Mesh mesh = meshes::torus(24, 12);
    meshes::add_scalar(mesh, "huge", [](glm::dvec3 p) { return 1e200 * meshes::wave_field(p); });
    meshes::add_scalar(mesh, "tiny", [](glm::dvec3 p) { return 1e-200 * meshes::wave_field(p); });
    const Reduction reduction = reduce(mesh);
    guarantee::expect_everything(mesh, reduction);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size());
}

} // namespace
