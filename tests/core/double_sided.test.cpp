// Triangles on the same three vertices: the two sides of a sheet are reduced together, copies are left out.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "map_certificate.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/sheet.hpp"
#include "meshes/topology.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;
using meshes::one_sided;

class DoubleSided : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds = guarantee::percent(2, 8)) const {
        return guarantee::reduced(mesh, bounds, GetParam().options());
    }
};
EVERY_MODE(DoubleSided);

glm::uvec3 turned(const glm::uvec3& t) { return {t.y, t.x, t.z}; }

/// Every triangle twice, once each way, all backs behind all fronts; labelled 1 and 2 where that is wanted.
Mesh with_backs(Mesh mesh) {
    const std::size_t fronts = mesh.triangles.size();
    for (std::size_t t = 0; t < fronts; ++t) {
        mesh.triangles.push_back(turned(mesh.triangles[t]));
        if (!mesh.regions.empty()) mesh.regions.push_back(mesh.regions[t]);
    }
    return mesh;
}

/// The backs have vertices of their own.
Mesh with_backs_apart(const Mesh& mesh) {
    Mesh both = mesh;
    const auto vertices = static_cast<std::uint32_t>(vertex_count(mesh));
    for (const glm::uvec3& t : mesh.triangles) both.triangles.push_back(turned(t) + vertices);
    const auto append = [](Values& to, const Values& from) {
        std::visit(
            [&from](auto& values) {
                const auto& more = std::get<std::decay_t<decltype(values)>>(from);
                values.insert(values.end(), more.begin(), more.end());
            },
            to);
    };
    append(both.position.values, mesh.position.values);
    for (std::size_t i = 0; i < mesh.variables.size(); ++i) append(both.variables[i].values, mesh.variables[i].values);
    return both;
}

using Corners = std::array<std::uint32_t, 3>;

Corners corners(const glm::uvec3& t) {
    Corners sorted = {t.x, t.y, t.z};
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

bool same_winding(const glm::uvec3& a, const glm::uvec3& b) {
    for (int i = 0; i < 3; ++i)
        if (b[i] == a.x) return b[(i + 1) % 3] == a.y;
    return false;
}

/// Each triangle has one that faces the other way, and is there once.
void expect_both_sides_everywhere(const Mesh& mesh) {
    std::map<Corners, std::vector<glm::uvec3>> sides;
    for (const glm::uvec3& t : mesh.triangles) sides[corners(t)].push_back(t);
    for (const auto& [at, both] : sides) {
        ASSERT_EQ(both.size(), 2U);
        EXPECT_FALSE(same_winding(both[0], both[1]));
    }
}

/// What is guaranteed of one side; its map, seen from one side.
void expect_certified(const Mesh& mesh, const Reduction& reduction) {
    if (reduction.map.images.empty()) return;
    const Mesh original = one_sided(mesh);
    const Reduction one = one_sided(reduction);
    const certificate::Certificate certificate(original, one); // keeps no copies
    EXPECT_THAT(certificate.faults(), testing::IsEmpty());
}

/// Segmentation covers every triangle of the original but copies, and every one of the reduced mesh, on its own side.
void expect_segmented(const Mesh& mesh, const Reduction& reduction) {
    if (reduction.map.images.empty()) return;
    Segmentation segmentation;
    const Status status = segment({mesh, reduction}, segmentation);
    ASSERT_TRUE(status.ok()) << status.message;
    EXPECT_EQ(segmentation.cells.size(), reduction.report.cells);
    EXPECT_EQ(segmentation.folded_cells, reduction.report.folded_cells);
    std::vector<double> covered(mesh.triangles.size(), 0);
    std::set<std::uint32_t> landed;
    const MappedSurfaces surfaces(mesh, reduction);
    for (const SegmentationCell& cell : segmentation.cells) {
        landed.insert(cell.reduced);
        for (std::uint32_t i = 0; i < cell.corner_count - 2; ++i) {
            const glm::uvec3& piece = segmentation.pieces[cell.first_piece + i];
            glm::dvec3 at[3];
            for (int k = 0; k < 3; ++k) {
                at[k] = barycentric_in_original(surfaces, cell, piece[k]);
                const glm::dvec3 in_reduced = barycentric_in_reduced(surfaces, cell, piece[k]);
                EXPECT_NEAR(in_reduced.x + in_reduced.y + in_reduced.z, 1, 1e-12);
            }
            covered[cell.original] +=
                (at[1].x - at[0].x) * (at[2].y - at[0].y) - (at[1].y - at[0].y) * (at[2].x - at[0].x);
        }
    }
    EXPECT_EQ(landed.size(), reduction.mesh.triangles.size());
    std::size_t uncovered = 0;
    for (const double share : covered) {
        uncovered += share == 0;
        EXPECT_NEAR(std::abs(share), share == 0 ? 0 : 1, 1e-9);
    }
    EXPECT_EQ(uncovered, reduction.report.defects.copied_triangles);
}

void expect_everything(const Mesh& mesh, const Reduction& reduction) {
    guarantee::expect_vertex_subset(mesh, reduction);
    guarantee::expect_judge_agrees(mesh, reduction, 5'000);
    const Reduction one = one_sided(reduction);
    guarantee::expect_same_topology(one_sided(mesh), one);
    guarantee::expect_judge_agrees(one_sided(mesh), one, 5'000);
    expect_certified(mesh, reduction);
    expect_segmented(mesh, reduction);
    for (const TriangleErrors& errors : reduction.triangle_errors)
        EXPECT_EQ(errors.largest.size(), reduction.mesh.triangles.size());
}

Mesh bumpy(int cells = 24) {
    Mesh mesh = meshes::plane(cells, cells);
    auto& positions = std::get<std::vector<double>>(mesh.position.values);
    for (std::size_t v = 0; v < vertex_count(mesh); ++v)
        positions[3 * v + 2] = 0.1 * std::sin(7 * positions[3 * v]) * std::cos(5 * positions[3 * v + 1]);
    meshes::add_usual_fields(mesh);
    return mesh;
}

TEST_P(DoubleSided, AFlatSquareEndsWithTwoTrianglesASide) {
    const Mesh mesh = with_backs(meshes::plane(2, 2));
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.mesh.triangles.size(), 4U);
    EXPECT_EQ(reduction.report.triangles_before, 16U);
    EXPECT_EQ(reduction.report.triangles_after, 4U);
    EXPECT_EQ(reduction.report.defects.two_sided_triangles, 8U);
    EXPECT_EQ(reduction.report.defects.copied_triangles, 0U);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 0U);
    expect_both_sides_everywhere(reduction.mesh);
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, BothSidesAreReducedAsOneWouldBe) {
    const Mesh one = bumpy(), mesh = with_backs(one);
    const Reduction expected = reduce(one), reduction = reduce(mesh);
    EXPECT_EQ(reduction.vertices, expected.vertices);
    EXPECT_EQ(reduction.mesh.triangles.size(), 2 * expected.mesh.triangles.size());
    EXPECT_EQ(one_sided(reduction.mesh).triangles, expected.mesh.triangles);
    EXPECT_EQ(reduction.report.flipped_normals_after, 2 * expected.report.flipped_normals_after);
    EXPECT_EQ(reduction.report.cells, 2 * expected.report.cells);
    expect_both_sides_everywhere(reduction.mesh);
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, PointsOfTheirOwnAndSharedOnesAgree) {
    const Mesh one = bumpy(48);
    const auto alone = static_cast<double>(reduce(one).mesh.triangles.size());
    EXPECT_EQ(reduce(with_backs(one)).mesh.triangles.size(), 2 * alone);
    // Sides with points of their own are reduced in turn with each other, in an order of their own: not to the same triangles.
    EXPECT_NEAR(reduce(with_backs_apart(one)).mesh.triangles.size(), 2 * alone, 2 * alone / 8);
}

TEST_P(DoubleSided, TheErrorsOfTheBackAreThoseOfTheFrontFromTheOtherSide) {
    const Reduction reduction = reduce(with_backs(bumpy()));
    const TriangleErrors &position = reduction.triangle_errors[0], &scalar = reduction.triangle_errors[1];
    for (std::size_t t = 0; t < reduction.mesh.triangles.size(); t += 2) {
        EXPECT_EQ(position.largest[t], position.largest[t + 1]);
        EXPECT_EQ(position.lowest[t], -position.highest[t + 1]);
        EXPECT_EQ(position.highest[t], -position.lowest[t + 1]);
        EXPECT_EQ(scalar.lowest[t], scalar.lowest[t + 1]);
    }
}

TEST_P(DoubleSided, CopiesAreLeftOutAndCounted) {
    const Mesh one = bumpy();
    Mesh mesh = one;
    for (std::size_t t = 0; t < one.triangles.size(); t += 3)
        mesh.triangles.push_back({one.triangles[t].y, one.triangles[t].z, one.triangles[t].x});
    const Reduction expected = reduce(one), reduction = reduce(mesh);
    EXPECT_EQ(reduction.mesh.triangles, expected.mesh.triangles);
    EXPECT_EQ(reduction.report.defects.copied_triangles, mesh.triangles.size() - one.triangles.size());
    EXPECT_EQ(reduction.report.defects.two_sided_triangles, 0U);
    EXPECT_EQ(reduction.report.triangles_before, mesh.triangles.size());
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, OfManyOnOneAnotherOneEachWayIsLeft) {
    const Mesh one = bumpy(8);
    Mesh mesh = with_backs(with_backs(one)); // front, back, back, front
    mesh.triangles.insert(mesh.triangles.end(), one.triangles.begin(), one.triangles.end());
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.two_sided_triangles, one.triangles.size());
    EXPECT_EQ(reduction.report.defects.copied_triangles, 3 * one.triangles.size());
    EXPECT_EQ(reduction.vertices, reduce(one).vertices);
    expect_both_sides_everywhere(reduction.mesh);
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, WhichSideComesFirstBearsOnNothing) {
    const Mesh one = bumpy();
    Mesh mesh = with_backs(one);
    meshes::Random random(5);
    for (std::size_t t = 0; t < one.triangles.size(); ++t)
        if (random.uniform(0, 1) < 0.5) std::swap(mesh.triangles[t], mesh.triangles[one.triangles.size() + t]);
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 0U) << "each faces both ways";
    EXPECT_NEAR(double(reduction.mesh.triangles.size()), double(reduce(with_backs(one)).mesh.triangles.size()),
                0.1 * double(reduction.mesh.triangles.size()));
    expect_both_sides_everywhere(reduction.mesh);
    guarantee::expect_judge_agrees(mesh, reduction, 5'000);
    expect_segmented(mesh, reduction);
}

/// The left half has two sides, the right one.
Mesh half_double_sided(int cells = 24) {
    Mesh mesh = bumpy(cells);
    const std::vector<glm::uvec3> fronts = mesh.triangles;
    for (const glm::uvec3& t : fronts) {
        const double x = (meshes::point(mesh, t.x).x + meshes::point(mesh, t.y).x + meshes::point(mesh, t.z).x) / 3;
        if (x < 0.5) mesh.triangles.push_back(turned(t));
    }
    return mesh;
}

double area(const Mesh& mesh, const std::vector<glm::uvec3>& triangles) {
    double sum = 0;
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a = meshes::point(mesh, t.x);
        sum += glm::length(glm::cross(meshes::point(mesh, t.y) - a, meshes::point(mesh, t.z) - a)) / 2;
    }
    return sum;
}

TEST_P(DoubleSided, WhereTheOtherSideEndsBothKeepTheirBorder) {
    const Mesh mesh = half_double_sided();
    const Reduction reduction = reduce(mesh);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
    std::map<Corners, int> sides;
    for (const glm::uvec3& t : reduction.mesh.triangles) ++sides[corners(t)];
    for (const auto& [at, count] : sides)
        for (const std::uint32_t vertex : at)
            EXPECT_TRUE(count == 2 ? meshes::point(reduction.mesh, vertex).x <= 0.5
                                   : meshes::point(reduction.mesh, vertex).x >= 0.5);
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, ASingleSideThatMeetsTwoIsNotTurned) {
    Mesh mesh = half_double_sided();
    for (glm::uvec3& t : mesh.triangles)
        if (meshes::point(mesh, t.x).x + meshes::point(mesh, t.y).x + meshes::point(mesh, t.z).x > 1.5) t = turned(t);
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 0U);
    guarantee::expect_judge_agrees(mesh, reduction, 5'000);
    expect_segmented(mesh, reduction);
}

TEST_P(DoubleSided, EachSideKeepsItsOwnLabel) {
    Mesh mesh = with_backs(meshes::plane(16, 16));
    const auto label = [&](std::size_t t) -> std::int32_t {
        const glm::uvec3& c = mesh.triangles[t];
        const glm::dvec3 p = (meshes::point(mesh, c.x) + meshes::point(mesh, c.y) + meshes::point(mesh, c.z)) / 3.0;
        if (t < mesh.triangles.size() / 2) return p.x < 0.5 ? 1 : 2; // fronts
        return p.y < 0.25 ? 7 : -3;
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.regions.push_back(label(t));
    const Reduction reduction = reduce(mesh);
    EXPECT_LT(reduction.mesh.triangles.size(), 40U);
    ASSERT_EQ(reduction.mesh.regions.size(), reduction.mesh.triangles.size());
    for (const RegionReport& region : reduction.report.regions)
        EXPECT_NEAR(region.area_before, region.area_after, 1e-9) << region.label; // flat, with straight borders
    for (std::size_t t = 0; t < reduction.mesh.triangles.size(); ++t) {
        const glm::uvec3& c = reduction.mesh.triangles[t];
        const glm::dvec3 a = meshes::point(reduction.mesh, c.x);
        const double up = glm::cross(meshes::point(reduction.mesh, c.y) - a, meshes::point(reduction.mesh, c.z) - a).z;
        EXPECT_EQ(up > 0, reduction.mesh.regions[t] == 1 || reduction.mesh.regions[t] == 2);
    }
    expect_segmented(mesh, reduction);
    guarantee::expect_judge_agrees(mesh, reduction, 5'000);
}

TEST_P(DoubleSided, AreasOfRegionsCountCopiesOnce) {
    Mesh mesh = meshes::plane(8, 8);
    mesh.regions.assign(mesh.triangles.size(), 4);
    for (std::size_t t = 0; t < 10; ++t) {
        mesh.triangles.push_back(mesh.triangles[t]);
        mesh.regions.push_back(4);
    }
    const Reduction reduction = reduce(mesh);
    ASSERT_EQ(reduction.report.regions.size(), 1U);
    EXPECT_EQ(reduction.report.regions[0].triangles_before, mesh.triangles.size());
    EXPECT_NEAR(reduction.report.regions[0].area_before, 1, 1e-12);
    EXPECT_NEAR(reduction.report.regions[0].area_after, 1, 1e-12);
}

TEST_P(DoubleSided, AClosedSurfaceWithAnInside) {
    Mesh one = meshes::sphere(12);
    meshes::add_usual_fields(one);
    const Mesh mesh = with_backs(one);
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(one_sided(reduction.mesh).triangles, reduce(one).mesh.triangles);
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, APillowOfTwoTrianglesStaysAndIsASheet) {
    Mesh mesh;
    mesh.position.values = std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.mesh.triangles, mesh.triangles);
    EXPECT_EQ(reduction.report.defects.two_sided_triangles, 1U);
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, AMoebiusBandWithBothSidesHasNothingToTurn) {
    Mesh one = meshes::moebius_band(60, 6);
    const Mesh mesh = with_backs(one);
    const Reduction reduction = reduce(mesh);
    EXPECT_EQ(reduction.report.defects.unorientable_components, 0U);
    EXPECT_EQ(reduction.report.defects.flipped_triangles, 0U);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
    expect_both_sides_everywhere(reduction.mesh);
    guarantee::expect_judge_agrees(mesh, reduction, 5'000);
    expect_segmented(mesh, reduction);
}

TEST_P(DoubleSided, ABookOfTwoSidedPages) {
    const Mesh one = meshes::three_sheets(12);
    const Mesh mesh = with_backs(one);
    const Reduction reduction = reduce(mesh);
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 4);
    expect_both_sides_everywhere(reduction.mesh);
    guarantee::expect_judge_agrees(mesh, reduction, 5'000);
    expect_segmented(mesh, reduction);
}

TEST_P(DoubleSided, WhatIsLockedStaysOnBothSides) {
    const Mesh mesh = with_backs(bumpy());
    Options options = GetParam().options();
    options.locked_boxes = {{{0.1, 0.1, -1}, {0.4, 0.4, 1}}};
    const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(5, 20), options);
    std::set<std::vector<std::uint32_t>> left;
    for (const glm::uvec3& t : reduction.mesh.triangles) {
        const Corners c = corners({reduction.vertices[t.x], reduction.vertices[t.y], reduction.vertices[t.z]});
        left.insert({c.begin(), c.end()});
    }
    for (const glm::uvec3& t : mesh.triangles) {
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 p = meshes::point(mesh, t[i]);
            inside = inside && p.x >= 0.1 && p.x <= 0.4 && p.y >= 0.1 && p.y <= 0.4;
        }
        const Corners c = corners(t);
        EXPECT_TRUE(!inside || left.count({c.begin(), c.end()}));
    }
    expect_everything(mesh, reduction);
}

TEST_P(DoubleSided, SmallPartsAreCountedWithBothSides) {
    Mesh mesh = meshes::plane(8, 8);
    const auto first = static_cast<std::uint32_t>(vertex_count(mesh));
    auto& positions = std::get<std::vector<double>>(mesh.position.values);
    positions.insert(positions.end(), {3, 0, 0, 3.001, 0, 0, 3, 0.001, 0});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh = with_backs(mesh);
    Options options = GetParam().options();
    options.drop_small_components = true;
    const Reduction reduction = guarantee::reduced(mesh, {{"position", absolute(0.01)}}, options);
    EXPECT_EQ(reduction.report.dropped.components, 1U);
    EXPECT_EQ(reduction.report.dropped.triangles, 2U);
    EXPECT_EQ(reduction.mesh.triangles.size(), 4U);
}

TEST_P(DoubleSided, PiercingIsRefusedAsOfOneSide) {
    const Mesh one = bumpy(), mesh = with_backs(one);
    Options options = GetParam().options();
    options.refuse_piercing = true;
    const Reduction expected = guarantee::reduced(one, guarantee::percent(5, 20), options);
    const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(5, 20), options);
    EXPECT_EQ(one_sided(reduction.mesh).triangles, expected.mesh.triangles);
}

TEST(DoubleSidedLevels, LinksAndMorphsHaveBothSides) {
    const Mesh mesh = half_double_sided();
    LevelOptions options;
    options.maps = options.morphs = true;
    Levels levels;
    const Status status = reduce_levels(
        mesh, {guarantee::percent(0.5, 2), guarantee::percent(2, 6), guarantee::percent(5, 15)}, options, levels);
    ASSERT_TRUE(status.ok()) << status.message;
    ASSERT_EQ(levels.morphs.size(), 3U);
    const Mesh* finer = &mesh;
    for (std::size_t n = 0; n < 3; ++n) {
        const Mesh start = morphed(levels.morphs[n], 0), end = morphed(levels.morphs[n], 1);
        EXPECT_NEAR(area(start, start.triangles), area(*finer, finer->triangles), 1e-9);
        finer = &levels.levels[n].mesh;
    }
}

TEST(DoubleSidedOnward, ACheckpointIsReducedOnBothSides) {
    const Mesh mesh = half_double_sided();
    Reduction reduction, onward;
    Checkpoint checkpoint;
    ASSERT_TRUE(meshbound::reduce(mesh, guarantee::percent(2, 8), {}, reduction, {}, &checkpoint).ok());
    const Status status = resume_reduction(checkpoint, guarantee::percent(3, 12), {}, onward);
    ASSERT_TRUE(status.ok()) << status.message;
    EXPECT_LT(onward.mesh.triangles.size(), checkpoint.mesh.triangles.size());
    EXPECT_EQ(onward.report.defects.two_sided_triangles, reduction.report.defects.two_sided_triangles);
    guarantee::expect_judge_agrees(mesh, onward, 5'000);
}

TEST(DoubleSidedMap, AMapMayNameEitherSide) {
    const Mesh mesh = half_double_sided();
    Reduction reduction = guarantee::reduced(mesh, guarantee::percent(2, 8));
    for (SurfacePoint& place : reduction.map.images) {
        const std::uint32_t next = place.triangle + 1;
        if (next >= reduction.mesh.triangles.size()) continue;
        const glm::uvec3 &here = reduction.mesh.triangles[place.triangle], &there = reduction.mesh.triangles[next];
        if (corners(here) != corners(there)) continue;
        glm::dvec3 turned_place(0);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (here[i] == there[j]) turned_place[j] = place.barycentric[i];
        place = {next, turned_place};
    }
    expect_segmented(mesh, reduction);
}

TEST(DoubleSidedRandom, TriangleSoupsOnFewPoints) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(static_cast<std::uint64_t>(seed));
        Mesh mesh = bumpy(4);
        const std::vector<glm::uvec3> fronts = mesh.triangles;
        for (const glm::uvec3& t : fronts)
            for (int n = 0; n < 3; ++n) {
                if (random.uniform(0, 1) < 0.6) continue;
                mesh.triangles.push_back(random.uniform(0, 1) < 0.5 ? t : turned(t));
            }
        for (int n = 0; n < seed % 5; ++n) {
            const auto vertex = [&] { return static_cast<std::uint32_t>(random.uniform(0, 24.99)); };
            mesh.triangles.push_back({vertex(), vertex(), vertex()});
        }
        if (seed % 2)
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                mesh.regions.push_back(random.uniform(0, 1) < 0.2 ? 1 : 0);
        const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(5, 10));
        guarantee::expect_vertex_subset(mesh, reduction);
        guarantee::expect_judge_agrees(mesh, reduction, 500);
        Segmentation segmentation;
        const Status status = segment({mesh, reduction}, segmentation);
        EXPECT_TRUE(status.ok()) << status.message;
        EXPECT_EQ(segmentation.cells.size(), reduction.report.cells);
    }
}

} // namespace
