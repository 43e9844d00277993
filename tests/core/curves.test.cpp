// Curves in which sheets meet, borders of regions, seams, edges of three or more triangles: they get shorter on all sheets
// at once, so that nothing opens, and each side keeps its own.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "map_certificate.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/topology.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

class Curves : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds = guarantee::percent(2, 8)) const {
        return guarantee::reduced(mesh, bounds, GetParam().options());
    }
};
EVERY_MODE(Curves);

/// What there is only where the map is kept.
class MappedCurves : public Curves {};
EVERY_TRACKED_MODE(MappedCurves);

Mesh with_fields(Mesh mesh) {
    meshes::add_usual_fields(mesh);
    return mesh;
}

/// Labelled by the place of each triangle's centre.
Mesh labelled(Mesh mesh, const std::function<std::int32_t(glm::dvec3)>& label) {
    mesh.regions.clear();
    for (const glm::uvec3& t : mesh.triangles)
        mesh.regions.push_back(
            label((meshes::point(mesh, t.x) + meshes::point(mesh, t.y) + meshes::point(mesh, t.z)) / 3.0));
    return mesh;
}

/// The triangles of one label, with all vertices.
Mesh region(const Mesh& mesh, std::int32_t label) {
    Mesh part = mesh;
    part.triangles.clear();
    part.regions.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (mesh.regions[t] == label) part.triangles.push_back(mesh.triangles[t]);
    return part;
}

/// Edges between two labels, and the labels at each vertex.
std::set<Edge> border(const Mesh& mesh) {
    std::map<Edge, std::set<std::int32_t>> labels;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i)
            labels[std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])].insert(mesh.regions[t]);
    std::set<Edge> found;
    for (const auto& [edge, sides] : labels)
        if (sides.size() > 1) found.insert(edge);
    return found;
}

std::map<std::uint32_t, std::set<std::int32_t>> labels_at_vertices(const Mesh& mesh) {
    std::map<std::uint32_t, std::set<std::int32_t>> labels;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) labels[mesh.triangles[t][i]].insert(mesh.regions[t]);
    return labels;
}

/// Each region is within the bounds of itself, its outline within those of its outline, its topology what it was; vertices
/// have the labels that they had.
void expect_regions(const Mesh& mesh, const Reduction& reduction) {
    ASSERT_EQ(reduction.mesh.regions.size(), reduction.mesh.triangles.size());
    for (const std::int32_t label : std::set<std::int32_t>(mesh.regions.begin(), mesh.regions.end())) {
        SCOPED_TRACE(label);
        Reduction part;
        part.mesh = region(reduction.mesh, label);
        part.report = reduction.report;
        const Mesh original = region(mesh, label);
        guarantee::expect_judge_agrees(original, part, 5'000);
        EXPECT_EQ(meshes::topology(part.mesh), meshes::topology(original));
    }
    const auto before = labels_at_vertices(mesh);
    const auto after = labels_at_vertices(reduction.mesh);
    for (const auto& [vertex, labels] : after) EXPECT_EQ(labels, before.at(reduction.vertices[vertex])) << vertex;
    for (const auto& [vertex, labels] : before)
        if (labels.size() > 2) {
            EXPECT_TRUE(std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), vertex))
                << "a corner of " << labels.size() << " regions";
        }
}

std::int32_t halves(glm::dvec3 p) { return p.x + 0.3 * p.y < 0.31 ? -7 : 4; }
std::int32_t wedges(glm::dvec3 p) {
    const double x = p.x - 0.47, y = p.y - 0.52;
    return (x > 0 ? 1 : 0) + (y > 0 ? 2 : 0) + (p.z > 0.7 ? 4 : 0);
}
/// An island, and a ring around it.
std::int32_t island(glm::dvec3 p) {
    const double distance = std::hypot(p.x - 0.5, p.y - 0.5);
    return distance < 0.2 ? 2 : distance < 0.35 ? 1 : 0;
}
/// Labels by chance: borders everywhere, in every configuration.
std::int32_t noise(glm::dvec3 p) {
    return static_cast<std::int32_t>(std::floor(1e4 * std::abs(std::sin(1e3 * p.x + 777 * p.y + 55 * p.z)))) % 3;
}

TEST_P(Curves, BordersOfRegionsAreKeptWithinTheBounds) {
    for (const auto& labels : {halves, wedges, island})
        for (const Mesh& plain :
             {meshes::plane(20, 20), meshes::terrain(5, 3), meshes::noisy_sphere(10, 0.03, 5), meshes::torus(24, 12)}) {
            const Mesh mesh = labelled(with_fields(plain), labels);
            const Reduction reduction = reduce(mesh);
            guarantee::expect_everything(mesh, reduction, 5'000);
            expect_regions(mesh, reduction);
            EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size());
        }
}

TEST_P(Curves, BordersGetShorter) {
    const Mesh mesh = labelled(meshes::plane(24, 24), [](glm::dvec3 p) { return p.x < 0.5 ? 1 : 2; });
    const Reduction reduction = reduce(mesh, {{"position", relative(1e-3)}});
    EXPECT_EQ(border(mesh).size(), 24U);
    EXPECT_EQ(border(reduction.mesh).size(), 1U);
    EXPECT_EQ(reduction.mesh.triangles.size(), 4U) << "two for each side";
    const Mesh round = labelled(meshes::sphere(16), [](glm::dvec3 p) { return p.z < 0.1 ? 0 : 1; });
    EXPECT_LT(border(reduce(round, {{"position", relative(0.02)}}).mesh).size(), border(round).size() / 2);
}

TEST_P(Curves, ManySmallRegionsKeepTheirTopology) {
    for (const Mesh& plain : {meshes::plane(12, 12), meshes::sphere(6)}) {
        const Mesh mesh = labelled(with_fields(plain), noise);
        const Reduction reduction = reduce(mesh, guarantee::percent(20, 50));
        guarantee::expect_everything(mesh, reduction, 5'000);
        expect_regions(mesh, reduction);
    }
}

TEST_P(Curves, OneLabelForAllChangesNothing) {
    const Mesh plain = with_fields(meshes::noisy_sphere(8, 0.05, 3));
    Mesh mesh = labelled(plain, [](glm::dvec3) { return 9; });
    const Reduction with = reduce(mesh), without = reduce(plain);
    EXPECT_TRUE(guarantee::same_bits(with.mesh, without.mesh));
    EXPECT_EQ(with.mesh.regions, std::vector<std::int32_t>(with.mesh.triangles.size(), 9));
}

TEST_P(Curves, TwoHalvesOfABallDoNotCollapseIntoOneTriangle) {
    const Mesh mesh = labelled(meshes::sphere(4), [](glm::dvec3 p) { return p.z < 0 ? 0 : 1; });
    const Reduction reduction = reduce(mesh, {{"position", relative(1)}});
    guarantee::expect_same_topology(mesh, reduction);
    EXPECT_GE(reduction.mesh.triangles.size(), 4U);
    std::set<std::set<std::uint32_t>> triangles;
    for (const glm::uvec3& t : reduction.mesh.triangles)
        EXPECT_TRUE(triangles.insert({t.x, t.y, t.z}).second) << "a triangle twice";
}

TEST_P(MappedCurves, TheMapIsContinuousAcrossThem) {
    std::vector<Mesh> surfaces = {meshes::three_sheets(8), meshes::cubes_on_one_edge(4)};
    for (const auto& labels : {halves, wedges, island})
        for (const Mesh& plain : {meshes::plane(16, 16), meshes::noisy_sphere(8, 0.03, 5)})
            surfaces.push_back(labelled(plain, labels));
    for (Mesh& plain : surfaces) {
        const Mesh mesh = with_fields(plain);
        const Reduction reduction = reduce(mesh);
        const certificate::Certificate certificate(mesh, reduction);
        EXPECT_THAT(certificate.faults(), testing::IsEmpty());
        const std::vector<double> errors = certificate.largest_errors();
        for (std::size_t i = 0; i < errors.size(); ++i)
            EXPECT_LE(errors[i], reduction.report.variables[i].bound.absolute * (1 + guarantee::hair));
        // A border edge stays on one border edge.
        if (mesh.regions.empty()) continue;
        std::set<Edge> reduced;
        for (const Edge& edge : border(reduction.mesh))
            reduced.insert(std::minmax(reduction.vertices[edge.first], reduction.vertices[edge.second]));
        for (const auto& [from, to] : border(mesh)) {
            std::set<std::uint32_t> corners; // of the reduced mesh, with a share in either end
            for (const std::uint32_t end : {from, to}) {
                const SurfacePoint& place = reduction.map.images[end];
                for (int i = 0; i < 3; ++i)
                    if (place.barycentric[i] != 0)
                        corners.insert(reduction.vertices[reduction.mesh.triangles[place.triangle][i]]);
            }
            ASSERT_EQ(corners.size(), 2U) << from << "-" << to;
            EXPECT_TRUE(reduced.count({*corners.begin(), *corners.rbegin()})) << from << "-" << to;
        }
    }
}

/// All corners of every cell lie in its two triangles.
TEST_P(MappedCurves, TheSegmentationKnowsTheSheets) {
    for (const Mesh& mesh : {labelled(with_fields(meshes::terrain(4, 5)), wedges), with_fields(meshes::three_sheets(8)),
                             labelled(with_fields(meshes::sphere(6)), halves)}) {
        const Reduction reduction = reduce(mesh);
        Segmentation segmentation;
        const MappedSurfaces surfaces{mesh, reduction};
        ASSERT_TRUE(segment(surfaces, segmentation).ok());
        std::vector<double> covered(mesh.triangles.size(), 0); // in barycentric coordinates, where a triangle has 1/2
        for (const SegmentationCell& cell : segmentation.cells)
            for (std::uint32_t i = 0; i < cell.corner_count; ++i) {
                const auto place = [&](std::uint32_t n) {
                    return barycentric_in_original(surfaces, cell, segmentation.corners[cell.first_corner + n]);
                };
                const std::uint32_t corner = segmentation.corners[cell.first_corner + i];
                const glm::dvec3 from = place(i), next = place((i + 1) % cell.corner_count);
                covered[cell.original] += (from.x * next.y - from.y * next.x) / 2;
                const glm::dvec3 to = barycentric_in_reduced(surfaces, cell, corner);
                EXPECT_NEAR(from.x + from.y + from.z, 1, 1e-12);
                EXPECT_NEAR(to.x + to.y + to.z, 1, 1e-12);
                if (mesh.regions.empty()) continue;
                EXPECT_EQ(mesh.regions[cell.original], reduction.mesh.regions[cell.reduced]);
            }
        for (std::size_t t = 0; t < covered.size(); ++t) EXPECT_NEAR(covered[t], 0.5, 1e-9) << "triangle " << t;
    }
}

void expect_cells_in_their_regions(const Mesh& mesh, const Reduction& reduction) {
    Segmentation segmentation;
    ASSERT_TRUE(segment({mesh, reduction}, segmentation).ok());
    for (const SegmentationCell& cell : segmentation.cells) {
        ASSERT_LT(cell.reduced, reduction.mesh.triangles.size());
        EXPECT_EQ(mesh.regions[cell.original], reduction.mesh.regions[cell.reduced]);
    }
}

/// Of a border both sides have a triangle, so a cell that is flattened onto it could be of either.
TEST_P(MappedCurves, TheSegmentationKnowsTheSideOfAFlatCell) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const Mesh mesh = labelled(meshes::jittered(meshes::plane(10, 10), 0.15, seed), noise);
        expect_cells_in_their_regions(mesh, reduce(mesh, guarantee::percent(20, 50)));
    }
}

/// Found by the fuzzer: put on the very end of an edge of a curve, in which other curves end, a vertex seemed to be on one of
/// those, and cells of its sheet found no triangle.
TEST_P(MappedCurves, TheSegmentationKnowsTheCurveOfAVertexAtItsEnd) {
    std::size_t at_ends = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        const auto number = [&random] { return random.uniform(-16, 16) * (random.below(8) == 0 ? 1e30 : 1); };
        Mesh mesh =
            meshes::mapped(meshes::plane(5, 5), [&](glm::dvec3) { return glm::dvec3(number(), number(), number()); });
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            mesh.regions.push_back(static_cast<std::int32_t>(random.below(3)));
        const Reduction reduction = reduce(mesh, {{"position", relative(0.5)}});
        for (const SurfacePoint& place : reduction.map.images)
            at_ends += std::max({place.barycentric.x, place.barycentric.y, place.barycentric.z}) == 1;
        at_ends -= reduction.vertices.size();
        expect_cells_in_their_regions(mesh, reduction);
    }
    EXPECT_GT(at_ends, 0U);
}

/// Two halves with vertices of their own along the cut, where "side" jumps.
Mesh seamed(const Mesh& plain) {
    Mesh low = with_fields(meshes::cut(plain, [](glm::dvec3 p) { return p.x < 0.4; }));
    Mesh high = with_fields(meshes::cut(plain, [](glm::dvec3 p) { return !(p.x < 0.4); }));
    meshes::add_scalar(low, "side", [](glm::dvec3 p) { return p.y; });
    meshes::add_scalar(high, "side", [](glm::dvec3 p) { return 10 - p.y; });
    return meshes::joined(low, high);
}

using Place = std::tuple<double, double, double>;

/// Boundary edges by the places of their ends, as often as they are there.
std::multiset<std::pair<Place, Place>> boundary_places(const Mesh& mesh) {
    std::map<Edge, int> triangles;
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) ++triangles[std::minmax(t[i], t[(i + 1) % 3])];
    std::multiset<std::pair<Place, Place>> found;
    for (const auto& [edge, count] : triangles) {
        if (count != 1) continue;
        const glm::dvec3 p = meshes::point(mesh, edge.first), q = meshes::point(mesh, edge.second);
        found.insert(std::minmax(Place(p.x, p.y, p.z), Place(q.x, q.y, q.z)));
    }
    return found;
}

TEST_P(Curves, NoCrackOpensAlongASeam) {
    for (const Mesh& plain : {meshes::noisy_sphere(10, 0.03, 5), meshes::torus(30, 14), meshes::sphere(12)}) {
        const Mesh mesh = seamed(plain); // closed, but for the seam
        const auto before = boundary_places(mesh);
        for (const auto& edge : before) ASSERT_EQ(before.count(edge), 2U);
        const Reduction reduction = reduce(mesh);
        guarantee::expect_everything(mesh, reduction, 5'000);
        const auto after = boundary_places(reduction.mesh);
        for (const auto& edge : after) EXPECT_EQ(after.count(edge), 2U) << "a crack";
        EXPECT_LT(after.size(), before.size());
    }
}

/// A plane that is slit along x = 0.5 between y = 0.25 and y = 0.75: the vertices between the ends of the slit stand twice, but
/// for one at y = `held`, which holds two slits apart.
Mesh slit_plane(double held = -1) {
    constexpr int cells = 8;
    Mesh mesh = meshes::plane(cells, cells);
    auto& position = std::get<std::vector<double>>(mesh.position.values);
    const auto in_slit = [held](glm::dvec3 p) { return p.x == 0.5 && p.y > 0.25 && p.y < 0.75 && p.y != held; };
    std::map<std::uint32_t, std::uint32_t> copies;
    for (glm::uvec3& t : mesh.triangles) {
        double middle = 0;
        for (int i = 0; i < 3; ++i) middle += meshes::point(mesh, t[i]).x / 3;
        for (int i = 0; i < 3 && middle > 0.5; ++i) {
            const glm::dvec3 p = meshes::point(mesh, t[i]);
            if (!in_slit(p)) continue;
            const auto next = static_cast<std::uint32_t>(position.size() / 3);
            const auto [copy, is_new] = copies.try_emplace(t[i], next);
            if (is_new) position.insert(position.end(), {p.x, p.y, p.z});
            t[i] = copy->second;
        }
    }
    return mesh;
}

/// Found by the fuzzer: shortened to one edge, both sides had the same two ends, and were one.
TEST_P(Curves, ASlitStaysOpen) {
    const Mesh mesh = slit_plane();
    ASSERT_EQ(meshes::topology(mesh).boundary_loops, 2U);
    const Reduction reduction = guarantee::reduced(mesh, {{"position", relative(1)}}, GetParam().options());
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
    guarantee::expect_same_topology(mesh, reduction);
}

/// Found by the fuzzer: without the vertex that held them apart, the two were one.
TEST_P(Curves, TwoSlitsStayApart) {
    const Mesh mesh = slit_plane(0.5);
    const Reduction reduction = guarantee::reduced(mesh, {{"position", relative(1)}}, GetParam().options());
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
    guarantee::expect_same_topology(mesh, reduction);
}

std::size_t on_seam(const Reduction& reduction) {
    std::size_t found = 0;
    for (std::uint32_t v = 0; v < vertex_count(reduction.mesh); ++v) found += meshes::point(reduction.mesh, v).x == 1;
    return found;
}

TEST_P(Curves, ABoundHoldsOnBothSidesOfASeam) {
    // Along the seam a variable is wild on one side only: the seam must stay for it.
    Mesh low = meshes::plane(16, 16),
         high = meshes::mapped(low, [](glm::dvec3 p) { return glm::dvec3(2 - p.x, p.y, p.z); });
    high = meshes::reversed(high);
    meshes::add_scalar(low, "f", [](glm::dvec3 p) { return std::sin(50 * p.y); });
    meshes::add_scalar(high, "f", [](glm::dvec3) { return 0.0; });
    for (const Mesh& mesh : {meshes::joined(low, high), meshes::joined(high, low)}) {
        const Reduction reduction = reduce(mesh, {{"position", relative(0.1)}, {"f", absolute(0.05)}});
        guarantee::expect_everything(mesh, reduction);
        const Reduction without = reduce(mesh, {{"position", relative(0.1)}});
        EXPECT_EQ(on_seam(without), 2 * 2) << "two ends on either side";
        EXPECT_GT(on_seam(reduction), 2 * 8);
    }
}

TEST_P(Curves, LockedVerticesOnThemStay) {
    const Mesh mesh = labelled(meshes::plane(8, 8), [](glm::dvec3 p) { return p.x < 0.5 ? 1 : 2; });
    Options options = GetParam().options();
    options.locked = {4 + 9 * 3};
    const Reduction reduction = guarantee::reduced(mesh, {{"position", relative(0.1)}}, options);
    EXPECT_TRUE(std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), options.locked[0]));
    EXPECT_EQ(border(reduction.mesh).size(), 2U);
}

TEST_P(Curves, ALockedRegionStaysAsItIs) {
    const Mesh mesh = labelled(with_fields(meshes::noisy_sphere(8, 0.03, 5)), wedges);
    Options options = GetParam().options();
    options.locked_regions = {2};
    const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(3, 12), options);
    const auto triangles_of = [](const Mesh& of, const std::vector<std::uint32_t>& names) {
        std::set<std::set<std::uint32_t>> found;
        for (const glm::uvec3& t : region(of, 2).triangles) found.insert({names[t.x], names[t.y], names[t.z]});
        return found;
    };
    std::vector<std::uint32_t> all(vertex_count(mesh));
    for (std::uint32_t v = 0; v < all.size(); ++v) all[v] = v;
    EXPECT_EQ(triangles_of(reduction.mesh, reduction.vertices), triangles_of(mesh, all));
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size());
    expect_regions(mesh, reduction);

    options.locked_regions = {2, 99};
    Reduction none;
    const Status status = meshbound::reduce(mesh, guarantee::percent(1, 1), options, none);
    EXPECT_EQ(status.fault, Fault::bad_option);
    EXPECT_EQ(status.index, 1U);
}

TEST_P(Curves, LevelsKeepThem) {
    const Mesh mesh = labelled(with_fields(meshes::noisy_sphere(10, 0.03, 5)), wedges);
    LevelOptions how{GetParam().options(), true, true};
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, {guarantee::percent(1, 4), guarantee::percent(3, 12)}, how, levels).ok());
    for (const Reduction& level : levels.levels) {
        guarantee::expect_everything(mesh, level, 5'000);
        expect_regions(mesh, level);
    }
}

TEST_P(Curves, AnyNumberOfThreadsGivesTheSameBytes) {
    const Mesh mesh = labelled(with_fields(meshes::terrain(7, 3)), wedges);
    Options options = GetParam().options();
    options.threads = 1;
    const Reduction one = guarantee::reduced(mesh, guarantee::percent(1, 4), options);
    options.threads = 4;
    const Reduction four = guarantee::reduced(mesh, guarantee::percent(1, 4), options);
    EXPECT_TRUE(guarantee::same_bits(one.mesh, four.mesh));
    EXPECT_EQ(one.mesh.regions, four.mesh.regions);
}

TEST_P(Curves, TooFewLabelsAreRefused) {
    Mesh mesh = meshes::plane(4, 4);
    mesh.regions = {1, 2, 3};
    Reduction reduction;
    const Status status = meshbound::reduce(mesh, guarantee::percent(1, 1), GetParam().options(), reduction);
    EXPECT_EQ(status.fault, Fault::wrong_value_count);
}

} // namespace
