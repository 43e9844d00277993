#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/api.hpp"
#include "meshbound/glm_layout.hpp"
#include "meshbound/mapped_surfaces.hpp"
#include "meshbound/options.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// A connected part of one original triangle that lands in one reduced triangle. Its corners run counter-clockwise in
/// the original triangle, where it is convex; its pieces, corner_count - 2 of them, triangulate it without further
/// corners.
struct SegmentationCell {
    std::uint32_t original = 0;     ///< the triangle of the original mesh that it is a part of
    std::uint32_t reduced = 0;      ///< the triangle of the reduced mesh that it lands in
    std::uint32_t first_corner = 0; ///< its corners are Segmentation::corners[first_corner …]
    std::uint32_t corner_count = 0; ///< at least 3
    std::uint32_t first_piece = 0;  ///< its pieces are Segmentation::pieces[first_piece …]
};

/// The mutual segmentation of the original and the reduced surface (figure 5): on every piece all variables, position
/// among them, are linear on both surfaces. What is interpolated between levels of detail (§4).
///
/// A corner is named by one number: below V = vertex_count(original) it is that vertex of the original, at its place
/// `map.images[corner]`; from there on it is `map.crossings[corner - V]`. So a corner has one place
/// on the original and one on the reduced surface, whatever cell one sees it from: neighbouring cells leave no crack.
///
///     a square, original triangles {0,1,2} and {0,2,3}; the reduced mesh has the other diagonal, which 0-2 crosses once:
///     V = 4, crossing 0 is corner 4;  cells (0,1,4), (1,2,4) of the one triangle, (0,4,3), (4,2,3) of the other.
///
/// Cells and pieces without area on the original occur where an original edge crosses the same reduced edges to and fro,
/// and where several crossings share one place of it: they open on the way to the reduced surface and keep it free of
/// holes. Together the pieces are a triangulation of the original surface. In triangles that `reduce` turns round
/// (MeshDefects::flipped_triangles) cells and pieces run the way of those around them, not the triangle's own.
struct Segmentation {
    std::vector<SegmentationCell> cells; ///< in the order of the original triangles
    std::vector<std::uint32_t> corners;  ///< cell by cell
    std::vector<glm::uvec3> pieces;      ///< three corners (by the same names) each, cell by cell

    /// Folds: where the map turns the surface over. A piece is folded when its image in the reduced triangle runs
    /// clockwise; a cell when any of its pieces is, in the triangulation that folds the least. The guarantee holds with
    /// or without folds.
    std::size_t folded_cells = 0, folded_pieces = 0;
    double folded_original = 0; ///< the folded pieces' share of the original's area, 0…1
    double folded_reduced = 0;  ///< the area of their images, as a share of the reduced surface's; may exceed 1
};

/// Below this share of its triangle's area a piece is flat: rounding decides on which side of it is up.
inline constexpr double flat_share = 1e-12;

/// Segments both surfaces by the map between them. Where there is none, after a reduction with propagated errors, the
/// segmentation is empty, and so it is when `progress` cancels.
///
/// Faults: those of validate, of either surface; bad_map, with the triangle or vertex of the original, the vertex of the reduced
/// mesh or the crossing as index: the map names what the surfaces lack, or its cells do not fit; out_of_memory. `segmentation`
/// is then untouched.
///
///     segment({mesh, reduction}, segmentation);
MESHBOUND_API Status segment(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress = {});

/// Barycentric coordinates of a corner of the cell in the cell's original triangle.
MESHBOUND_API glm::dvec3 barycentric_in_original(const MappedSurfaces& surfaces, const SegmentationCell& cell,
                                                 std::uint32_t corner);

/// Barycentric coordinates of a corner of the cell in the cell's reduced triangle.
MESHBOUND_API glm::dvec3 barycentric_in_reduced(const MappedSurfaces& surfaces, const SegmentationCell& cell,
                                                std::uint32_t corner);

} // namespace meshbound
