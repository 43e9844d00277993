// Triangles that face the wrong side are turned round where that can be; parts are independent, and small ones can be dropped.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class Orientation : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, bool drop_small_components = false) const {
        Options options = GetParam().options();
        options.drop_small_components = drop_small_components;
        return guarantee::reduced(mesh, guarantee::percent(3, 10), options);
    }
};
EVERY_MODE(Orientation);

/// What there is only where the map is kept.
class MappedOrientation : public Orientation {};
EVERY_TRACKED_MODE(MappedOrientation);

Mesh with_fields(Mesh mesh) {
    meshes::add_usual_fields(mesh);
    return mesh;
}

/// With each triangle turned round by chance.
std::size_t turn_some(Mesh& mesh, double share, std::uint64_t seed) {
    meshes::Random random(seed);
    std::size_t turned = 0;
    for (glm::uvec3& t : mesh.triangles)
        if (random.uniform(0, 1) < share) {
            std::swap(t.y, t.z);
            ++turned;
        }
    return turned;
}

TEST_P(Orientation, OneTriangleTheWrongWayRoundIsTurned) {
    const Mesh mesh = with_fields(meshes::one_triangle_reversed(8));
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 1U);
    EXPECT_EQ(reduction.report.defects.unorientable_components, 0U);
    EXPECT_EQ(reduction.report.non_manifold_vertices, 0U);
    guarantee::expect_everything(with_fields(meshes::plane(8, 8)), reduction);
}

TEST_P(Orientation, ADisorderedSurfaceIsReducedAsIfItWereInOrder) {
    for (const Mesh& plain : {meshes::noisy_sphere(8, 0.05, 3), meshes::plane(12, 12), meshes::torus(24, 12)}) {
        const Mesh mesh = with_fields(plain);
        Mesh disordered = mesh;
        const std::size_t turned = turn_some(disordered, 0.3, 7);
        const Reduction reduction = reduce(disordered);
        EXPECT_EQ(reduction.report.defects.flipped_triangles, turned);
        guarantee::expect_everything(mesh, reduction);
        EXPECT_EQ(meshes::topology(reduction.mesh).discordant_edges, 0U);
        const std::size_t in_order = reduce(mesh).mesh.triangles.size();
        EXPECT_LT(std::abs(double(reduction.mesh.triangles.size()) - double(in_order)), 0.1 * double(in_order) + 4);
    }
}

TEST_P(Orientation, EachPartFacesAsMostOfItsTrianglesDo) {
    const Mesh ball = meshes::sphere(8);
    const Mesh hollow = meshes::reversed(meshes::mapped(ball, [](glm::dvec3 p) { return 0.5 * p; }));
    Mesh mesh = with_fields(meshes::joined(ball, hollow));
    const Mesh plain = mesh;
    turn_some(mesh, 0.2, 3);
    const Reduction reduction = reduce(mesh);
    guarantee::expect_everything(plain, reduction);
    EXPECT_GT(meshes::enclosed_volume(reduction.mesh), 0) << "the hollow is still one";
    EXPECT_LT(meshes::enclosed_volume(reduction.mesh), meshes::enclosed_volume(ball));
}

TEST_P(Orientation, ASurfaceInOrderStaysAsItIsWhicheverSideItFaces) {
    for (const Mesh& mesh : {with_fields(meshes::sphere(8)), meshes::reversed(with_fields(meshes::sphere(8)))}) {
        const Reduction reduction = reduce(mesh);
        EXPECT_EQ(reduction.report.defects.flipped_triangles, 0U);
        EXPECT_GT(meshes::enclosed_volume(mesh) * meshes::enclosed_volume(reduction.mesh), 0);
    }
}

TEST_P(MappedOrientation, TheMapCountsNoTurnedTriangleAsAFold) {
    Mesh mesh = meshes::plane(12, 12);
    turn_some(mesh, 0.3, 5);
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.mesh.triangles.size(), 2U);
    EXPECT_EQ(reduction.report.folded_cells, 0U);
}

/// A Möbius band in front of a sphere.
Mesh band_and_ball() {
    return meshes::joined(meshes::mapped(meshes::sphere(6), [](glm::dvec3 p) { return p + glm::dvec3(5, 0, 0); }),
                          meshes::moebius_band(40, 6));
}

TEST_P(Orientation, WhatHasNoTwoSidesIsLeftAsItIsAndSaid) {
    Mesh mesh = band_and_ball();
    const std::size_t of_ball = meshes::sphere(6).triangles.size();
    const std::size_t discordant = meshes::topology(mesh).discordant_edges;
    ASSERT_GT(discordant, 0U);
    mesh = with_fields(mesh);
    std::swap(mesh.triangles[3].x, mesh.triangles[3].y); // of the ball
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 1U);
    EXPECT_EQ(reduction.report.defects.unorientable_components, 1U);
    EXPECT_EQ(reduction.report.defects.unorientable_triangle, of_ball);
    guarantee::expect_judge_agrees(mesh, reduction);
    EXPECT_GT(meshes::topology(reduction.mesh).discordant_edges, 0U);
    EXPECT_EQ(meshes::topology(reduction.mesh).euler, meshes::topology(mesh).euler);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() * 2 / 3);
}

TEST_P(Orientation, ADisorderedBandIsReducedLikeOneInOrder) {
    const Mesh band = with_fields(meshes::moebius_band(40, 6));
    Mesh disordered = band;
    turn_some(disordered, 0.3, 7);
    const Reduction reduction = reduce(disordered);
    EXPECT_EQ(reduction.report.defects.unorientable_components, 1U);
    EXPECT_GT(reduction.report.defects.flipped_triangles, 0U);
    guarantee::expect_judge_agrees(band, reduction);
    EXPECT_EQ(meshes::topology(reduction.mesh).euler, meshes::topology(band).euler);
    EXPECT_EQ(meshes::topology(reduction.mesh).boundary_loops, 1U);
    const std::size_t in_order = reduce(band).mesh.triangles.size();
    EXPECT_LT(double(reduction.mesh.triangles.size()), 1.5 * double(in_order)) << "the line is no straight one";
    EXPECT_EQ(reduce(band).report.defects.flipped_triangles, 0U) << "it is in as good an order as can be";
}

TEST_P(Orientation, TrianglesWithAVertexTwiceStandInNobodysWay) {
    Mesh mesh = with_fields(meshes::plane(8, 8));
    std::swap(mesh.triangles[20].x, mesh.triangles[20].y);
    const glm::uvec3 t = mesh.triangles[20];
    mesh.triangles.insert(mesh.triangles.begin(), {t.x, t.x, t.y});
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 1U);
    guarantee::expect_everything(with_fields(meshes::plane(8, 8)), reduction);
}

/// A sphere with crumbs around it: of 2, 2 and 30 % of its size.
Mesh with_crumbs() {
    Mesh mesh = meshes::sphere(10);
    for (const glm::dvec3 crumb : {glm::dvec3(2, 0, 0.01), glm::dvec3(0, 2, 0.01), glm::dvec3(0, 0, 0.15)}) {
        const glm::dvec3 place = crumb.z < 0.1 ? glm::dvec3(crumb.x, crumb.y, 0) : glm::dvec3(0, 0, 2);
        mesh =
            meshes::joined(mesh, meshes::mapped(meshes::sphere(2), [&](glm::dvec3 p) { return crumb.z * p + place; }));
    }
    return with_fields(mesh);
}

TEST_P(Orientation, SmallPartsGoOnlyWhenAskedForAndAreCounted) {
    const Mesh mesh = with_crumbs();
    const Reduction all = reduce(mesh);
    EXPECT_EQ(all.report.dropped.components, 0U);
    guarantee::expect_everything(mesh, all);

    const Reduction reduction = reduce(mesh, true);
    EXPECT_EQ(reduction.report.dropped.components, 2U);
    EXPECT_EQ(reduction.report.dropped.triangles, 2 * meshes::sphere(2).triangles.size());
    Mesh rest = mesh;
    std::erase_if(rest.triangles, [&](const glm::uvec3& t) {
        const glm::dvec3 p = meshes::point(mesh, t.x);
        return std::max(p.x, p.y) > 1.5;
    });
    guarantee::expect_everything(rest, reduction);
}

TEST_P(Orientation, SmallPartsThatAreLockedOrOneWithALargerOneStay) {
    Mesh mesh = with_crumbs();
    Options options = GetParam().options();
    options.drop_small_components = true;
    options.locked = {static_cast<std::uint32_t>(vertex_count(meshes::sphere(10)))}; // of the first crumb
    EXPECT_EQ(guarantee::reduced(mesh, guarantee::percent(3, 10), options).report.dropped.components, 1U);

    // Everything is smaller than the bound: the largest part stays.
    options.locked.clear();
    const Reduction one = guarantee::reduced(mesh, {{"position", relative(2)}}, options);
    EXPECT_EQ(one.report.dropped.components, 3U);
    EXPECT_GE(one.mesh.triangles.size(), 4U);

    // A scrap of a seamed surface: its vertices are its own, its places are not.
    Mesh seamed = with_fields(meshes::plane(10, 10));
    const Mesh scrap = meshes::cut(seamed, [](glm::dvec3 p) { return p.x < 0.02 + 0.1 && p.y < 0.1; });
    const Mesh rest = meshes::cut(seamed, [](glm::dvec3 p) { return !(p.x < 0.02 + 0.1 && p.y < 0.1); });
    const Reduction seams = guarantee::reduced(meshes::joined(rest, scrap), {{"position", relative(0.2)}}, options);
    EXPECT_EQ(seams.report.dropped.components, 0U);
}

TEST_P(Orientation, SmallPartsStayAwayInEveryLevel) {
    const Mesh mesh = with_crumbs();
    LevelOptions how{GetParam().options(), true, true};
    how.reduction.drop_small_components = true;
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, {guarantee::percent(3, 10), guarantee::percent(6, 20)}, how, levels).ok());
    for (const Reduction& level : levels.levels) EXPECT_EQ(meshes::topology(level.mesh).components, 2U);
}

TEST_P(Orientation, SmallPartsNeedABoundToBeSmallerThan) {
    LevelOptions how{GetParam().options()};
    how.reduction.drop_small_components = true;
    const Mesh mesh = with_crumbs();
    const Bounds bounded = guarantee::percent(3, 10), free = {{"*", relative(0.1)}, {"position", unbounded()}};
    Reduction reduction;
    const Status status = meshbound::reduce(mesh, free, how.reduction, reduction);
    EXPECT_EQ(status.fault, Fault::bad_option);
    EXPECT_EQ(status.variable, "position");
    Levels levels;
    EXPECT_EQ(reduce_levels(mesh, {free, {}}, how, levels).fault, Fault::bad_option);
    EXPECT_TRUE(reduce_levels(mesh, {bounded, {}}, how, levels).ok()) << "the first level's bound is what counts";
}

} // namespace
