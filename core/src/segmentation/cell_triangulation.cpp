#include "segmentation/cell_triangulation.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "meshbound/segmentation.hpp"

namespace meshbound {

bool PieceShares::folded() const { return reduced < -flat_share; }

bool PieceShares::opening() const { return original <= flat_share && std::abs(reduced) > flat_share; }

PieceShares piece_shares(const CellCorner& a, const CellCorner& b, const CellCorner& c) {
    // The determinant of barycentric coordinates; of three points on one edge it is exactly zero.
    return {glm::dot(a.original, glm::cross(b.original, c.original)),
            glm::dot(a.reduced, glm::cross(b.reduced, c.reduced))};
}

void CellTriangulation::solve(const std::vector<CellCorner>& corners) {
    size_ = corners.size();
    sub_polygons_.assign(size_ * size_, {});
    for (std::size_t span = 2; span < size_; ++span)
        for (std::size_t first = 0; first + span < size_; ++first) {
            const std::size_t last = first + span;
            SubPolygon& best = at(first, last);
            for (std::size_t middle = first + 1; middle < last; ++middle) {
                const PieceShares shares = piece_shares(corners[first], corners[middle], corners[last]);
                const SubPolygon &left = at(first, middle), &right = at(middle, last);
                SubPolygon sub_polygon{left.bad + right.bad, left.folded + right.folded, middle};
                if (shares.folded() || shares.opening()) ++sub_polygon.bad;
                if (shares.folded()) sub_polygon.folded -= shares.reduced;
                const bool better =
                    sub_polygon.bad != best.bad ? sub_polygon.bad < best.bad : sub_polygon.folded < best.folded;
                if (best.middle == 0 || better) best = sub_polygon;
            }
        }
}

} // namespace meshbound
