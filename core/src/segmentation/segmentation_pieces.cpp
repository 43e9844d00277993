#include "segmentation/segmentation_pieces.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "meshbound/segmentation.hpp"

namespace meshbound {

bool PieceShares::folded() const { return reduced < -flat_share; }

bool PieceShares::opening() const { return original <= flat_share && std::abs(reduced) > flat_share; }

PieceShares piece_shares(const CellPlace& a, const CellPlace& b, const CellPlace& c) {
    // The determinant of barycentric coordinates; of three places on one edge it is exactly zero.
    return {glm::dot(a.original, glm::cross(b.original, c.original)),
            glm::dot(a.reduced, glm::cross(b.reduced, c.reduced))};
}

void CellTriangulation::solve(const std::vector<CellPlace>& corners) {
    size_ = corners.size();
    parts_.assign(size_ * size_, {});
    for (std::size_t span = 2; span < size_; ++span)
        for (std::size_t first = 0; first + span < size_; ++first) {
            const std::size_t last = first + span;
            Part& best = at(first, last);
            for (std::size_t middle = first + 1; middle < last; ++middle) {
                const PieceShares shares = piece_shares(corners[first], corners[middle], corners[last]);
                const Part &left = at(first, middle), &right = at(middle, last);
                Part part{left.bad + right.bad, left.folded + right.folded, middle};
                if (shares.folded() || shares.opening()) ++part.bad;
                if (shares.folded()) part.folded -= shares.reduced;
                const bool better = part.bad != best.bad ? part.bad < best.bad : part.folded < best.folded;
                if (best.middle == 0 || better) best = part;
            }
        }
}

} // namespace meshbound
