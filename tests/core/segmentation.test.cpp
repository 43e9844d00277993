// The mutual segmentation covers both surfaces exactly, without cracks, and its corners carry the errors reported.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "mesh/orientation.hpp"
#include "meshbound/segmentation.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/shapes.hpp"
#include "meshes/topology.hpp"
#include "meshes/variations.hpp"
#include "samples.hpp"
#include "segmentation/cell_cutter.hpp"

namespace {

using namespace meshbound;

/// Sums of shares of a triangle: a few units in the last place for each piece.
constexpr double rounding = 1e-9;

Options choosing(bool places, bool crossings) {
    Options options;
    options.errors = ErrorAccounting::tracked;
    options.optimize_vertex_images = places;
    options.optimize_edge_crossings = crossings;
    return options;
}

std::vector<Options> all_choices() {
    return {choosing(false, false), choosing(true, false), choosing(false, true), choosing(true, true)};
}

/// A mesh, its reduction and their segmentation, with what can be asked of them.
class Segmented {
public:
    Segmented(const Mesh& mesh, const Bounds& bounds, const Options& options)
        : mesh_(mesh), reduction_(guarantee::reduced(mesh, bounds, options)) {
        const Status status = segment({mesh_, reduction_}, segmentation_);
        EXPECT_TRUE(status.ok()) << status.message;
        // From here on as they are reduced: turned where they face the wrong side.
        mesh_.triangles = orient(mesh.triangles, vertices()).triangles;
    }

    const Reduction& reduction() const { return reduction_; }
    const Segmentation& segmentation() const { return segmentation_; }
    std::size_t vertices() const { return vertex_count(mesh_); }

    void expect_everything() const {
        expect_corners_in_place();
        expect_pieces_of_cells();
        expect_originals_covered();
        expect_reduced_covered_once();
        expect_all_corners();
        expect_no_cracks();
        expect_few_cells();
        expect_folds_counted();
        expect_reported_errors();
    }

    /// Every corner lies in both triangles of its cell, and where the map says.
    void expect_corners_in_place() const {
        for_each_corner([&](const SegmentationCell& cell, std::uint32_t corner) {
            for (const glm::dvec3& w : {in_original(cell, corner), in_reduced(cell, corner)}) {
                ASSERT_NEAR(w.x + w.y + w.z, 1, rounding) << name(cell, corner);
                ASSERT_GE(std::min({w.x, w.y, w.z}), -rounding) << name(cell, corner);
            }
            if (corner >= vertices() || is_kept(corner)) return;
            const SurfacePoint& place = reduction_.map.images[corner];
            if (place.triangle == cell.reduced) return;
            // Where sheets meet, a place is in a triangle of each of them: on an edge that they share.
            const glm::uvec3 &named = reduction_.mesh.triangles[place.triangle],
                             &here = reduction_.mesh.triangles[cell.reduced];
            for (int i = 0; i < 3; ++i) {
                const bool shared = named[i] == here.x || named[i] == here.y || named[i] == here.z;
                ASSERT_TRUE(shared || place.barycentric[i] == 0) << name(cell, corner);
            }
        });
    }

    /// A polygon of n corners has n - 2 pieces, and they use no other corners.
    void expect_pieces_of_cells() const {
        std::size_t corners = 0, pieces = 0;
        for (const SegmentationCell& cell : segmentation_.cells) {
            ASSERT_EQ(cell.first_corner, corners);
            ASSERT_EQ(cell.first_piece, pieces);
            ASSERT_GE(cell.corner_count, 3U);
            corners += cell.corner_count;
            pieces += cell.corner_count - 2;
            const auto begin = segmentation_.corners.begin() + cell.first_corner, end = begin + cell.corner_count;
            for (std::size_t n = cell.first_piece; n < pieces; ++n)
                for (int i = 0; i < 3; ++i) ASSERT_NE(std::find(begin, end, segmentation_.pieces[n][i]), end);
        }
        EXPECT_EQ(corners, segmentation_.corners.size());
        EXPECT_EQ(pieces, segmentation_.pieces.size());
    }

    /// The pieces cover every original triangle, and none overlap.
    void expect_originals_covered() const {
        std::vector<double> covered(mesh_.triangles.size(), 0);
        for_each_piece([&](const SegmentationCell& cell, const glm::uvec3& piece) {
            const double share = share_of(piece, [&](std::uint32_t corner) { return in_original(cell, corner); });
            ASSERT_GE(share, -rounding) << "a piece of triangle " << cell.original << " is turned over";
            covered[cell.original] += share;
        });
        for (std::size_t t = 0; t < covered.size(); ++t)
            ASSERT_NEAR(covered[t], repeats_vertex(mesh_.triangles[t]) ? 0 : 1, rounding) << "triangle " << t;
    }

    /// The map is of degree one: folded pieces counted as negative, the images fill every reduced triangle once.
    void expect_reduced_covered_once() const {
        std::vector<double> covered(reduction_.mesh.triangles.size(), 0);
        for_each_piece([&](const SegmentationCell& cell, const glm::uvec3& piece) {
            covered[cell.reduced] += share_of(piece, [&](std::uint32_t corner) { return in_reduced(cell, corner); });
        });
        for (std::size_t t = 0; t < covered.size(); ++t)
            ASSERT_NEAR(covered[t], 1, rounding) << "reduced triangle " << t;
    }

    /// Every used vertex and every crossing is a corner; a crossing in all triangles that meet there, of both surfaces.
    void expect_all_corners() const {
        std::map<std::uint32_t, std::set<std::uint32_t>> original, reduced;
        for_each_corner([&](const SegmentationCell& cell, std::uint32_t corner) {
            original[corner].insert(cell.original);
            reduced[corner].insert(cell.reduced);
        });
        for (const glm::uvec3& t : mesh_.triangles)
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(original.count(t[i]) == 1 || repeats_vertex(t)) << "vertex " << t[i];
        for (std::size_t n = 0; n < reduction_.map.crossings.size(); ++n) {
            const auto corner = static_cast<std::uint32_t>(vertices() + n);
            ASSERT_EQ(original[corner].size(), 2U) << "crossing " << n;
            ASSERT_LE(reduced[corner].size(), 2U) << "crossing " << n;
        }
    }

    /// The pieces form a surface of their own, closed up to the original's boundary, of the original's Euler number.
    void expect_no_cracks() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> pieces_at, triangles_at;
        for (const glm::uvec3& piece : segmentation_.pieces) add_half_edges(piece, pieces_at);
        for (const glm::uvec3& triangle : mesh_.triangles)
            if (!repeats_vertex(triangle)) add_half_edges(triangle, triangles_at);
        const auto count = [](const auto& at, std::uint32_t a, std::uint32_t b) {
            const auto found = at.find({a, b});
            return found == at.end() ? 0 : found->second;
        };
        long long edges = 0;
        for (const auto& [ends, here] : pieces_at) {
            const auto [a, b] = ends;
            const int back = count(pieces_at, b, a);
            ASSERT_EQ(here - back, count(triangles_at, a, b) - count(triangles_at, b, a)) << "edge " << a << "-" << b;
            if (back == 0 || a < b) edges += std::max(here, back);
        }
        const meshes::Topology topology = meshes::topology(mesh_);
        if (topology.non_manifold_edges > 0 || topology.discordant_edges > 0) return;
        const std::set<std::uint32_t> corners(segmentation_.corners.begin(), segmentation_.corners.end());
        EXPECT_EQ(static_cast<long long>(corners.size()) - edges + static_cast<long long>(segmentation_.pieces.size()),
                  topology.euler);
    }

    void expect_few_cells() const {
        EXPECT_LE(segmentation_.cells.size(), 3 * (mesh_.triangles.size() + reduction_.mesh.triangles.size()));
    }

    /// The counts of folds, from the pieces alone.
    void expect_folds_counted() const {
        std::size_t pieces = 0;
        std::set<std::uint32_t> cells;
        double folded = 0, all = 0;
        for_each_piece([&](const SegmentationCell& cell, const glm::uvec3& piece) {
            const double area = area_of(piece, cell);
            all += area;
            if (share_of(piece, [&](std::uint32_t corner) { return in_reduced(cell, corner); }) >= -flat_share) return;
            ++pieces;
            folded += area;
            cells.insert(cell.first_corner);
        });
        EXPECT_EQ(segmentation_.folded_pieces, pieces);
        EXPECT_EQ(segmentation_.folded_cells, cells.size());
        EXPECT_NEAR(segmentation_.folded_original, folded / all, rounding);
        EXPECT_GE(segmentation_.folded_reduced, 0);
    }

    /// The largest errors at the corners are those reported.
    void expect_reported_errors() const {
        for (std::size_t i = 0; i <= mesh_.variables.size(); ++i) {
            const VariableView original = variable_of(mesh_, i);
            const VariableView reduced = variable_of(reduction_.mesh, i);
            double largest = 0;
            for_each_corner([&](const SegmentationCell& cell, std::uint32_t corner) {
                const std::vector<double> there =
                    mixed(original, mesh_.triangles[cell.original], in_original(cell, corner));
                const std::vector<double> here =
                    mixed(reduced, reduction_.mesh.triangles[cell.reduced], in_reduced(cell, corner));
                double square = 0;
                for (std::size_t c = 0; c < there.size(); ++c) square += (there[c] - here[c]) * (there[c] - here[c]);
                largest = std::max(largest, std::sqrt(square));
            });
            const VariableReport& report = reduction_.report.variables[i];
            EXPECT_NEAR(largest, report.error,
                        1e-9 * report.error + 1e-12 * (report.bound.extent + report.bound.magnitude))
                << report.name;
        }
    }

private:
    static bool repeats_vertex(const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

    static void add_half_edges(const glm::uvec3& triangle, std::map<std::pair<std::uint32_t, std::uint32_t>, int>& at) {
        for (int i = 0; i < 3; ++i) ++at[{triangle[i], triangle[(i + 1) % 3]}];
    }

    static std::vector<double> mixed(const VariableView& variable, const glm::uvec3& triangle,
                                     const glm::dvec3& weight) {
        std::vector<double> sum(static_cast<std::size_t>(variable.components), 0);
        for (int i = 0; i < 3; ++i)
            for (std::size_t c = 0; c < sum.size(); ++c)
                sum[c] += weight[i] * value_at(variable, triangle[i], static_cast<int>(c));
        return sum;
    }

    bool is_kept(std::uint32_t vertex) const {
        return std::binary_search(reduction_.vertices.begin(), reduction_.vertices.end(), vertex);
    }
    glm::dvec3 in_original(const SegmentationCell& cell, std::uint32_t corner) const {
        return barycentric_in_original({mesh_, reduction_}, cell, corner);
    }
    glm::dvec3 in_reduced(const SegmentationCell& cell, std::uint32_t corner) const {
        return barycentric_in_reduced({mesh_, reduction_}, cell, corner);
    }
    static std::string name(const SegmentationCell& cell, std::uint32_t corner) {
        return "corner " + std::to_string(corner) + " of triangle " + std::to_string(cell.original);
    }

    template <class Visit>
    void for_each_corner(const Visit& visit) const {
        for (const SegmentationCell& cell : segmentation_.cells)
            for (std::uint32_t i = 0; i < cell.corner_count; ++i)
                visit(cell, segmentation_.corners[cell.first_corner + i]);
    }
    template <class Visit>
    void for_each_piece(const Visit& visit) const {
        for (const SegmentationCell& cell : segmentation_.cells)
            for (std::uint32_t i = 0; i + 2 < cell.corner_count; ++i)
                visit(cell, segmentation_.pieces[cell.first_piece + i]);
    }

    template <class Place>
    static double share_of(const glm::uvec3& piece, const Place& place) {
        const glm::dvec3 a = place(piece.x), b = place(piece.y), c = place(piece.z);
        return (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
    }
    double area_of(const glm::uvec3& piece, const SegmentationCell& cell) const {
        const glm::uvec3& t = mesh_.triangles[cell.original];
        const glm::dvec3 a = meshes::point(mesh_, t.x), b = meshes::point(mesh_, t.y), c = meshes::point(mesh_, t.z);
        return glm::length(glm::cross(b - a, c - a)) / 2 *
               share_of(piece, [&](std::uint32_t corner) { return in_original(cell, corner); });
    }

    Mesh mesh_;
    Reduction reduction_;
    Segmentation segmentation_;
};

TEST(Segmentation, CoversEveryKindOfSurface) {
    for (const meshes::Exhibit& exhibit : meshes::gallery())
        for (const Bounds& bounds : {guarantee::percent(1, 3), guarantee::percent(6, 10), guarantee::percent(50, 100)})
            for (const Options& options : all_choices()) {
                SCOPED_TRACE(exhibit.name);
                Segmented(exhibit.mesh, bounds, options).expect_everything();
            }
}

TEST(Segmentation, CoversOddSurfaces) {
    std::size_t number = 0;
    for (const Mesh& odd : meshes::odd_surfaces()) {
        SCOPED_TRACE(number++);
        if (meshes::topology(odd).discordant_edges > 0)
            continue; // what the reduction turns round lies the other way here
        for (const Options& options : all_choices())
            Segmented(odd, guarantee::percent(3, 10), options).expect_everything();
    }
}

TEST(Segmentation, CoversSurfacesOfSeveralRegions) {
    for (Mesh mesh : {meshes::terrain(4, 5), meshes::noisy_sphere(8, 0.03, 5), meshes::plane(12, 12)}) {
        meshes::add_usual_fields(mesh);
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 p = meshes::point(mesh, t.x);
            mesh.regions.push_back((p.x > 0.3) + 2 * (p.y > 0.4 * p.x) + 4 * (p.z > 0.5));
        }
        for (const Options& options : all_choices())
            Segmented(mesh, guarantee::percent(3, 10), options).expect_everything();
    }
}

TEST(Segmentation, CoversSamples) {
    for_each_sample(15'000,
                    [](const Mesh& mesh) { Segmented(mesh, guarantee::percent(1, 3), {}).expect_everything(); });
}

TEST(Segmentation, LeavesRepeatedVerticesOut) {
    Mesh mesh = meshes::sphere(6);
    mesh.triangles.insert(mesh.triangles.begin() + 7, {3, 3, 5});
    Segmented(mesh, guarantee::percent(3, 3), {}).expect_everything();
}

TEST(Segmentation, OfAPlaneAsLaidOutHasNoFolds) {
    for (const Mesh& plane : {meshes::plane(20, 20), meshes::jittered(meshes::plane(16, 12), 0.01, 3)}) {
        Mesh mesh = plane;
        meshes::add_usual_fields(mesh);
        for (const double bound : {0.01, 0.05, 0.3}) {
            const Segmented segmented(mesh, {{"position", relative(0.01)}, {"*", relative(bound)}},
                                      choosing(false, false));
            ASSERT_LT(segmented.reduction().mesh.triangles.size(), mesh.triangles.size());
            EXPECT_EQ(segmented.segmentation().folded_pieces, 0U);
            EXPECT_EQ(segmented.segmentation().folded_original, 0);
            EXPECT_EQ(segmented.segmentation().folded_reduced, 0);
        }
    }
}

TEST(Segmentation, IsTheMeshItselfWhereNothingWasRemoved) {
    const Mesh mesh = meshes::noisy_sphere(6, 0.1, 1);
    const Segmented same(mesh, {{"position", relative(1e-9)}}, {});
    ASSERT_EQ(same.reduction().mesh.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(same.segmentation().pieces, mesh.triangles);
    EXPECT_EQ(same.segmentation().cells.size(), mesh.triangles.size());
    EXPECT_EQ(same.segmentation().folded_cells, 0U);
    same.expect_everything();
}

TEST(Segmentation, OfPropagatedErrorsIsEmpty) {
    Options options;
    options.errors = ErrorAccounting::propagated;
    const Segmented none(meshes::sphere(6), guarantee::percent(3, 3), options);
    EXPECT_TRUE(none.segmentation().cells.empty());
    EXPECT_TRUE(none.segmentation().pieces.empty());
}

// Outlines of triangles by hand, through a reduced mesh with the vertices 0 … 6: a fan around 0.
//
//        2 --- 1
//       / \ B / \       A = (0, 6, 1), B = (0, 1, 2), C = (0, 2, 3), D = (0, 3, 4), E = (0, 4, 5), F = (0, 5, 6)
//      / C \ / A \.
//     3 --- 0 --- 6     and outside of it G = (2, 1, 7) at B, H = (1, 6, 7) at A
//      \ D / \ F /
//       \ / E \ /
//        4 --- 5
class Cutting : public testing::Test {
protected:
    enum Triangle : std::uint32_t { A, B, C, D, E, F, G, H };
    const std::vector<glm::uvec3> fan_ = {{0, 6, 1}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4},
                                          {0, 4, 5}, {0, 5, 6}, {2, 1, 7}, {1, 6, 7}};

    static constexpr std::uint32_t first_crossing = 100;
    void removed(std::uint32_t vertex, std::uint32_t triangle) {
        outline_.push_back({vertex, nowhere, glm::uvec2(nowhere), triangle, triangle});
    }
    void kept(std::uint32_t vertex, std::uint32_t as) {
        outline_.push_back({vertex, as, glm::uvec2(nowhere), nowhere, nowhere});
    }
    void crossing(std::uint32_t name, glm::uvec2 edge, std::uint32_t before, std::uint32_t after) {
        outline_.push_back({first_crossing + name, nowhere, edge, before, after});
    }

    /// The cells: the reduced triangle and the corners, from the lowest.
    using Cells = std::set<std::pair<std::uint32_t, std::vector<std::uint32_t>>>;
    Cells cut() {
        Mesh fan;
        fan.triangles = fan_;
        const FaceLookup faces(fan);
        Segmentation segmentation;
        CellCutter(faces, fan.regions).cut(0, outline_, segmentation);
        Cells cells;
        for (const SegmentationCell& cell : segmentation.cells) {
            const auto first = segmentation.corners.begin() + cell.first_corner;
            std::vector<std::uint32_t> corners(first, first + cell.corner_count);
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            cells.insert({cell.reduced, corners});
        }
        return cells;
    }

private:
    Outline outline_;
};

TEST_F(Cutting, CutsRemovedCornersOff) {
    removed(10, A);
    crossing(0, {0, 1}, A, B);
    removed(11, B);
    crossing(1, {0, 2}, B, C);
    removed(12, C);
    crossing(2, {0, 2}, C, B);
    crossing(3, {0, 1}, B, A);
    EXPECT_EQ(cut(), (Cells{{A, {10, 100, 103}}, {B, {11, 101, 102, 103, 100}}, {C, {12, 102, 101}}}));
}

TEST_F(Cutting, FansAroundAKeptCorner) {
    kept(10, 0);
    removed(11, A);
    crossing(0, {0, 1}, A, B);
    crossing(1, {0, 2}, B, C);
    removed(12, C);
    EXPECT_EQ(cut(), (Cells{{A, {10, 11, 100}}, {B, {10, 100, 101}}, {C, {10, 101, 12}}}));
}

TEST_F(Cutting, FansAllTheWayAroundAKeptCorner) {
    kept(10, 0);
    removed(11, A);
    crossing(0, {0, 1}, A, B);
    crossing(1, {0, 2}, B, C);
    crossing(2, {0, 3}, C, D);
    crossing(3, {0, 4}, D, E);
    crossing(4, {0, 5}, E, F);
    crossing(5, {0, 6}, F, A);
    removed(12, A);
    EXPECT_EQ(cut(), (Cells{{A, {10, 11, 100}},
                            {B, {10, 100, 101}},
                            {C, {10, 101, 102}},
                            {D, {10, 102, 103}},
                            {E, {10, 103, 104}},
                            {F, {10, 104, 105}},
                            {A, {10, 105, 12}}}));
}

TEST_F(Cutting, JoinsCrossingsAroundKeptCorners) {
    kept(10, 7); // G behind the edge 1-2 …
    crossing(0, {1, 2}, G, B);
    crossing(1, {0, 1}, B, A);
    kept(11, 6); // … A
    crossing(2, {0, 1}, A, B);
    crossing(3, {0, 2}, B, C);
    kept(12, 3); // … C
    crossing(4, {0, 2}, C, B);
    crossing(5, {1, 2}, B, G);
    EXPECT_EQ(
        cut(),
        (Cells{{G, {10, 100, 105}}, {A, {11, 102, 101}}, {C, {12, 104, 103}}, {B, {100, 101, 102, 103, 104, 105}}}));
}

TEST_F(Cutting, JoinsCrossingsToTheOppositeKeptCorner) {
    kept(10, 6);
    crossing(0, {0, 1}, A, B);
    crossing(1, {0, 2}, B, C);
    kept(11, 3);
    kept(12, 0);
    EXPECT_EQ(cut(), (Cells{{A, {10, 100, 12}}, {B, {12, 100, 101}}, {C, {11, 12, 101}}}));
}

TEST_F(Cutting, KeepsApartWhatAnEdgeBetweenKeptCornersSeparates) {
    kept(10, 1);
    removed(11, A);
    kept(12, 0);
    crossing(0, {0, 2}, C, B); // turns around the kept corner
    EXPECT_EQ(cut(), (Cells{{A, {10, 11, 12}}, {B, {10, 12, 100}}}));
}

TEST_F(Cutting, KeepsSidesApartFromTheMiddleOfThreeKeptCorners) {
    kept(10, 0);
    kept(11, 6);
    crossing(0, {1, 6}, A, H); // out and in around a kept corner
    kept(12, 1);
    crossing(1, {0, 2}, B, C);
    EXPECT_EQ(cut(), (Cells{{A, {10, 11, 12}}, {H, {11, 100, 12}}, {B, {10, 12, 101}}}));
}

/// Once round, one crossing on each side: no two of them can be joined, nor all of them with the opposite corners.
TEST_F(Cutting, EndsWhereTheOutlineIsOfNoMap) {
    kept(10, 7);
    crossing(0, {0, 1}, A, B);
    kept(11, 3);
    crossing(1, {0, 2}, B, C);
    kept(12, 5);
    crossing(2, {0, 6}, F, A);
    EXPECT_EQ(cut(), (Cells{{B, {10, 100, 11}}, {C, {11, 101, 12}}, {A, {10, 12, 102}}, {nowhere, {10, 11, 12}}}));
}

TEST_F(Cutting, TakesAWholeTriangle) {
    kept(10, 0);
    kept(11, 6);
    kept(12, 1);
    EXPECT_EQ(cut(), (Cells{{A, {10, 11, 12}}}));
}

TEST_F(Cutting, TakesATriangleTurnedOver) {
    kept(10, 0);
    kept(11, 1);
    kept(12, 6);
    EXPECT_EQ(cut(), (Cells{{A, {10, 11, 12}}}));
}

TEST_F(Cutting, OpensASideThatRunsToAndFro) {
    removed(10, A);
    crossing(0, {0, 1}, A, B);
    crossing(1, {0, 2}, B, C);
    crossing(2, {0, 2}, C, B);
    crossing(3, {0, 1}, B, A);
    removed(11, A);
    removed(12, A);
    EXPECT_EQ(cut(), (Cells{{B, {100, 101, 102, 103}}, {A, {10, 100, 103, 11, 12}}}));
}

} // namespace
