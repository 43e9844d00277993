#include "segmentation/both_sides.hpp"

#include <algorithm>
#include <utility>

namespace meshbound {
namespace {

/// The same point, in the triangle of the sheet that has the same corners.
SurfacePoint on_sheet(const SurfacePoint& place, const Mesh& reduced, const OneSided& sheet) {
    if (place.triangle == nowhere) return place;
    SurfacePoint here{sheet.triangles_in_shape()[place.triangle], glm::dvec3(0)};
    if (here.triangle == no_index) return {nowhere, glm::dvec3(0)};
    const glm::uvec3 &from = reduced.triangles[place.triangle], &to = sheet.shape().triangles[here.triangle];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (from[i] == to[j]) here.barycentric[j] = place.barycentric[i];
    return here;
}

SurfaceMap map_onto_sheet(const MappedSurfaces& both, const OneSided& sheet) {
    SurfaceMap map{{}, both.map.crossings};
    for (const SurfacePoint& place : both.map.images) map.images.push_back(on_sheet(place, both.reduced, sheet));
    return map;
}

} // namespace

OneSidedPair::OneSidedPair(const MappedSurfaces& both)
    : original_(both.original, OneSided::Orienting::as_reduced, labels_),
      reduced_(both.reduced, OneSided::Orienting::none, labels_), map_(map_onto_sheet(both, reduced_)),
      surfaces_(original_.shape(), reduced_.shape(), both.vertices, map_) {}

Segmentation OneSidedPair::on_both_sides(const Segmentation& one_sided) const {
    Segmentation both = one_sided;
    both.cells.clear();
    both.corners.clear();
    both.pieces.clear();
    std::vector<Cells> cells(original_.fronts().size(), Cells{0, 0});
    for (std::size_t n = 0; n < one_sided.cells.size(); ++n) {
        Cells& here = cells[one_sided.cells[n].original];
        if (here.last == here.first) here.first = n;
        here.last = n + 1;
    }
    for (std::uint32_t triangle = 0; triangle < original_.triangles_in_shape().size(); ++triangle) {
        const std::uint32_t in_shape = original_.triangles_in_shape()[triangle];
        if (in_shape != no_index) add(one_sided, cells[in_shape], triangle, both);
    }
    return both;
}

/// Adds the cells of a triangle of the original; a copy has none.
void OneSidedPair::add(const Segmentation& one_sided, const Cells& cells, std::uint32_t triangle,
                       Segmentation& both) const {
    const std::uint32_t in_shape = original_.triangles_in_shape()[triangle];
    const bool is_back = original_.backs()[in_shape] == triangle;
    if (!is_back && original_.fronts()[in_shape] != triangle) return;
    for (std::size_t n = cells.first; n < cells.last; ++n) {
        SegmentationCell cell = one_sided.cells[n];
        const auto corners = one_sided.corners.begin() + cell.first_corner;
        const auto pieces = one_sided.pieces.begin() + cell.first_piece;
        const std::uint32_t back = reduced_.backs()[cell.reduced];
        cell.original = triangle;
        cell.reduced = is_back && back != no_index ? back : reduced_.fronts()[cell.reduced];
        cell.first_corner = static_cast<std::uint32_t>(both.corners.size());
        cell.first_piece = static_cast<std::uint32_t>(both.pieces.size());
        both.cells.push_back(cell);
        both.corners.insert(both.corners.end(), corners, corners + cell.corner_count);
        both.pieces.insert(both.pieces.end(), pieces, pieces + cell.corner_count - 2);
        if (!is_back) continue;
        std::reverse(both.corners.begin() + cell.first_corner, both.corners.end());
        for (std::size_t i = cell.first_piece; i < both.pieces.size(); ++i)
            std::swap(both.pieces[i].y, both.pieces[i].z);
    }
}

} // namespace meshbound
