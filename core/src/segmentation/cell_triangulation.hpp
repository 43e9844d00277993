#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace meshbound {

/// A corner of a cell: its barycentric coordinates in the original and in the reduced triangle.
struct CellCorner {
    glm::dvec3 original{0}, reduced{0};
};

/// Shares of the original and of the reduced triangle that a piece takes up, negative where it runs clockwise.
struct PieceShares {
    double original = 0, reduced = 0;

    bool folded() const;
    /// Flat on the original and not on the reduced surface.
    bool opening() const;
};

PieceShares piece_shares(const CellCorner& a, const CellCorner& b, const CellCorner& c);

/// Triangulates a cell into pieces: with the fewest folded or opening ones and, among such triangulations, with the
/// least folded area. By dynamic programming over the polygon's diagonals.
class CellTriangulation {
public:
    /// Calls `visit(i, j, k)` for every piece, with the indices of its corners in the cell, counter-clockwise.
    template <class Visit>
    void for_each_piece(const std::vector<CellCorner>& corners, const Visit& visit) {
        if (corners.size() == 3) {
            visit(0, 1, 2);
            return;
        }
        solve(corners);
        pending_.assign(1, {0, corners.size() - 1});
        while (!pending_.empty()) {
            const auto [first, last] = pending_.back();
            pending_.pop_back();
            if (last - first < 2) continue;
            const std::size_t middle = at(first, last).middle;
            visit(first, middle, last);
            pending_.insert(pending_.end(), {{middle, last}, {first, middle}});
        }
    }

private:
    /// The best triangulation of the corners first … last.
    struct SubPolygon {
        std::size_t bad = 0;
        double folded = 0;
        std::size_t middle = 0; ///< its piece at the diagonal is (first, middle, last)
    };
    void solve(const std::vector<CellCorner>& corners);
    SubPolygon& at(std::size_t first, std::size_t last) { return sub_polygons_[first * size_ + last]; }

    std::size_t size_ = 0;
    std::vector<SubPolygon> sub_polygons_;
    std::vector<std::pair<std::size_t, std::size_t>> pending_;
};

} // namespace meshbound
