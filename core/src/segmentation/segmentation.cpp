#include "meshbound/segmentation.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/orientation.hpp"
#include "mesh/position_at.hpp"
#include "mesh/repeats_vertex.hpp"
#include "segmentation/both_sides.hpp"
#include "segmentation/cell_cutter.hpp"
#include "segmentation/cell_triangulation.hpp"
#include "segmentation/check_map.hpp"
#include "segmentation/face_lookup.hpp"
#include "segmentation/fold_count.hpp"
#include "segmentation/outline.hpp"
#include "util/out_of_memory.hpp"
#include "util/parallel_for.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {
namespace {

/// Barycentric coordinates of the point at `share` along an edge of a triangle.
glm::dvec3 barycentric_on_edge(const glm::uvec3& triangle, const glm::uvec2& edge, double share) {
    glm::dvec3 place(0);
    for (int i = 0; i < 3; ++i) {
        if (triangle[i] == edge.x) place[i] = 1 - share;
        if (triangle[i] == edge.y) place[i] = share;
    }
    return place;
}

glm::dvec3 barycentric_at_vertex(const glm::uvec3& triangle, std::uint32_t vertex) {
    return barycentric_on_edge(triangle, {vertex, vertex}, 1);
}

double area(const Mesh& mesh, const glm::uvec3& triangle) {
    const auto point = [&](int corner) { return position_at(mesh, triangle[corner]); };
    return glm::length(glm::cross(point(1) - point(0), point(2) - point(0))) / 2;
}

std::size_t sides_of(const Sides& sides, std::size_t triangle) { return sides.empty() ? 1 : sides[triangle]; }

double area(const Mesh& mesh, const Sides& sides) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!repeats_vertex(mesh.triangles[t]))
            sum += static_cast<double>(sides_of(sides, t)) * area(mesh, mesh.triangles[t]);
    return sum;
}

/// Whether a corner lies in the reduced triangle of its cell: elsewhere its coordinates in that do not add up.
bool lies_inside(const CellCorner& corner) {
    return std::abs(corner.reduced.x + corner.reduced.y + corner.reduced.z - 1) <= rounding_of_shares;
}

/// The lookup tables of two surfaces; several threads may read them.
struct Prepared {
    Prepared(const MappedSurfaces& mapped, const Sides& of_original)
        : surfaces(mapped), sides(of_original), faces(mapped.reduced), outlines(mapped, faces) {}

    const MappedSurfaces& surfaces;
    const Sides& sides; // of the original's triangles
    const FaceLookup faces;
    const Outlines outlines;
};

/// Segments one original triangle after the other.
class Segmenter {
public:
    explicit Segmenter(const Prepared& prepared)
        : surfaces_(prepared.surfaces), sides_(prepared.sides), outlines_(prepared.outlines),
          cutter_(prepared.faces, prepared.surfaces.original.regions) {}

    /// Adds the cells and pieces of a triangle, and how much of them is folded (areas in squared units of position).
    /// Stops and returns false where a cell fits no reduced triangle: then the map is not one between these surfaces.
    bool add(std::uint32_t triangle, Segmentation& segmentation);

private:
    bool cut_into_pieces(SegmentationCell& cell, Segmentation& segmentation);

    const MappedSurfaces& surfaces_;
    const Sides& sides_;
    const Outlines& outlines_;
    CellCutter cutter_;
    Outline outline_;
    CellTriangulation triangulation_;
    std::vector<CellCorner> corners_;
};

bool Segmenter::add(std::uint32_t triangle, Segmentation& segmentation) {
    const glm::uvec3& corners = surfaces_.original.triangles[triangle];
    if (repeats_vertex(corners)) return true;
    if (surfaces_.map.images[corners.x].triangle == nowhere) return true; // of a component that was dropped
    outlines_.trace(triangle, outline_);
    std::size_t cell = segmentation.cells.size();
    cutter_.cut(triangle, outline_, segmentation);
    for (; cell < segmentation.cells.size(); ++cell)
        if (!cut_into_pieces(segmentation.cells[cell], segmentation)) return false;
    return true;
}

bool Segmenter::cut_into_pieces(SegmentationCell& cell, Segmentation& segmentation) {
    if (cell.reduced == nowhere) return false;
    cell.first_piece = static_cast<std::uint32_t>(segmentation.pieces.size());
    const std::uint32_t* corners = &segmentation.corners[cell.first_corner];
    corners_.clear();
    for (std::uint32_t i = 0; i < cell.corner_count; ++i)
        corners_.push_back({barycentric_in_original(surfaces_, cell, corners[i]),
                            barycentric_in_reduced(surfaces_, cell, corners[i])});
    if (!std::all_of(corners_.begin(), corners_.end(), lies_inside)) return false;
    const std::size_t folded_before = segmentation.folded_pieces, sides = sides_of(sides_, cell.original);
    const auto both = static_cast<double>(sides);
    triangulation_.for_each_piece(corners_, [&](std::size_t i, std::size_t j, std::size_t k) {
        segmentation.pieces.push_back({corners[i], corners[j], corners[k]});
        const PieceShares shares = piece_shares(corners_[i], corners_[j], corners_[k]);
        if (!shares.folded()) return;
        const Mesh &original = surfaces_.original, &reduced = surfaces_.reduced;
        segmentation.folded_pieces += sides;
        segmentation.folded_original += both * shares.original * area(original, original.triangles[cell.original]);
        segmentation.folded_reduced -= both * shares.reduced * area(reduced, reduced.triangles[cell.reduced]);
    });
    if (segmentation.folded_pieces > folded_before) segmentation.folded_cells += sides;
    return true;
}

/// Counts folds in one original triangle after the other.
class FoldCounter {
public:
    explicit FoldCounter(const Prepared& prepared) : segmenter_(prepared), sides_(prepared.sides) {}

    void add(std::uint32_t triangle) {
        here_.cells.clear();
        here_.corners.clear();
        here_.pieces.clear();
        segmenter_.add(triangle, here_); // fits: the map is what the reduction made
        cells_ += sides_of(sides_, triangle) * here_.cells.size();
    }

    void add_to(Folds& folds) const {
        folds.cells += cells_;
        folds.folded_cells += here_.folded_cells;
    }

private:
    Segmenter segmenter_;
    const Sides& sides_;
    Segmentation here_; // of the last triangle; its numbers of folds are of all
    std::size_t cells_ = 0;
};

Status does_not_fit(std::uint32_t triangle) {
    return {Fault::bad_map,
            "The map cuts triangle " + std::to_string(triangle) +
                " of the original into parts of which one fits no triangle of the reduced mesh.",
            "", triangle};
}

/// How many sides the triangles of either surface have, where no two of them coincide.
struct SidesOfBoth {
    Sides original, reduced;
};

/// The original must be oriented consistently, and the map must have passed check_map.
Status segment_oriented(const MappedSurfaces& surfaces, const SidesOfBoth& sides, Segmentation& segmentation,
                        const Progress& progress) {
    segmentation = {};
    const Prepared prepared(surfaces, sides.original);
    Segmenter segmenter(prepared);
    ProgressReporter reporter(progress);
    const std::size_t triangles = surfaces.original.triangles.size();
    for (std::uint32_t triangle = 0; triangle < triangles; ++triangle) {
        if (!segmenter.add(triangle, segmentation)) return does_not_fit(triangle);
        if (reporter.advance(1, triangle / static_cast<double>(triangles))) continue;
        segmentation = {};
        return {};
    }
    if (segmentation.folded_original > 0) segmentation.folded_original /= area(surfaces.original, sides.original);
    if (segmentation.folded_reduced > 0) segmentation.folded_reduced /= area(surfaces.reduced, sides.reduced);
    return check_crossings_met(surfaces, segmentation);
}

/// The map is that of the triangles as `reduce` oriented them.
Status orient_and_segment(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress) {
    Orientation orientation = orient(surfaces.original.triangles, vertex_count(surfaces.original));
    if (orientation.flipped == 0) return segment_oriented(surfaces, {}, segmentation, progress);
    Mesh oriented;
    oriented.position = surfaces.original.position;
    oriented.triangles = std::move(orientation.triangles);
    oriented.regions = surfaces.original.regions;
    return segment_oriented({oriented, surfaces}, {}, segmentation, progress);
}

/// The map is of one sheet, where `reduce` found triangles on the same three vertices.
Status segment_both_sides(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress) {
    const OneSidedPair sheets(surfaces);
    if (Status status = check_map(sheets.surfaces()); !status.ok()) return status;
    const SidesOfBoth sides = {sheets.original().sides(), sheets.reduced().sides()};
    Segmentation one_sided;
    Status status = segment_oriented(sheets.surfaces(), sides, one_sided, progress);
    if (status.ok()) segmentation = sheets.on_both_sides(one_sided);
    else if (status.index && *status.index < sheets.original().fronts().size())
        status = does_not_fit(sheets.original().fronts()[*status.index]);
    return status;
}

Status segment_checked(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress) {
    if (has_coincident_triangles(surfaces.original) || has_coincident_triangles(surfaces.reduced))
        return segment_both_sides(surfaces, segmentation, progress);
    return orient_and_segment(surfaces, segmentation, progress);
}

/// So many triangles take a millisecond.
constexpr std::size_t triangles_per_chunk = 1024;

} // namespace

glm::dvec3 barycentric_in_original(const MappedSurfaces& surfaces, const SegmentationCell& cell, std::uint32_t corner) {
    const glm::uvec3& triangle = surfaces.original.triangles[cell.original];
    const std::size_t vertices = surfaces.map.images.size();
    if (corner < vertices) return barycentric_at_vertex(triangle, corner);
    const MapCrossing& crossing = surfaces.map.crossings[corner - vertices];
    return barycentric_on_edge(triangle, crossing.original, crossing.s);
}

glm::dvec3 barycentric_in_reduced(const MappedSurfaces& surfaces, const SegmentationCell& cell, std::uint32_t corner) {
    const glm::uvec3& triangle = surfaces.reduced.triangles[cell.reduced];
    const std::size_t vertices = surfaces.map.images.size();
    if (corner >= vertices) {
        const MapCrossing& crossing = surfaces.map.crossings[corner - vertices];
        return barycentric_on_edge(triangle, crossing.reduced, crossing.t);
    }
    const SurfacePoint& place = surfaces.map.images[corner];
    if (place.triangle == cell.reduced) return place.barycentric;
    // A kept vertex, or one on a curve, whose image is given in a neighbouring triangle.
    glm::dvec3 here(0);
    for (int i = 0; i < 3; ++i)
        here += place.barycentric[i] * barycentric_at_vertex(triangle, surfaces.reduced.triangles[place.triangle][i]);
    return here;
}

Folds count_folds(const MappedSurfaces& surfaces, const Sides& sides, ThreadPool& pool, ProgressReporter& reporter) {
    if (surfaces.map.images.empty()) return {};
    const Prepared prepared(surfaces, sides);
    pool.start();
    std::vector<FoldCounter> counters(pool.size(), FoldCounter(prepared));
    const auto count = [&](std::size_t worker, std::size_t triangle) {
        counters[worker].add(static_cast<std::uint32_t>(triangle));
    };
    if (!parallel_for(pool, reporter, surfaces.original.triangles.size(), triangles_per_chunk, count)) return {};
    Folds folds;
    for (const FoldCounter& counter : counters) counter.add_to(folds);
    return folds;
}

Status segment(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress) {
    try {
        Segmentation cut;
        if (!surfaces.map.images.empty() || !surfaces.map.crossings.empty()) {
            if (Status status = check_map(surfaces); !status.ok()) return status;
            if (Status status = segment_checked(surfaces, cut, progress); !status.ok()) return status;
        }
        segmentation = std::move(cut);
        return {};
    } catch (const std::bad_alloc&) {
        return out_of_memory("cutting", surfaces.original.triangles.size(), " by their map");
    }
}

} // namespace meshbound
