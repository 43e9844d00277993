#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace meshbound {

/// A corner of a cell, by barycentric coordinates in its original and in its reduced triangle.
struct CellPlace {
    glm::dvec3 original{0}, reduced{0};
};

/// Shares of the original and of the reduced triangle that a piece takes up, negative where it runs clockwise.
struct PieceShares {
    double original = 0, reduced = 0;

    bool folded() const;
    /// Flat on the original and not on the reduced surface.
    bool opening() const;
};

PieceShares piece_shares(const CellPlace& a, const CellPlace& b, const CellPlace& c);

/// Triangulates cells. Of all triangulations of the polygon it takes one with the fewest pieces that are folded or
/// opening, and among these one with the least folded area. By dynamic programming over the polygon's diagonals.
class CellTriangulation {
public:
    /// Calls `visit(i, j, k)` for every piece, with the indices of its corners in the cell, counter-clockwise.
    template <class Visit>
    void for_each_piece(const std::vector<CellPlace>& corners, const Visit& visit) {
        if (corners.size() == 3) {
            visit(0, 1, 2);
            return;
        }
        solve(corners);
        open_.assign(1, {0, corners.size() - 1});
        while (!open_.empty()) {
            const auto [first, last] = open_.back();
            open_.pop_back();
            if (last - first < 2) continue;
            const std::size_t middle = at(first, last).middle;
            visit(first, middle, last);
            open_.insert(open_.end(), {{middle, last}, {first, middle}});
        }
    }

private:
    /// The best triangulation of the corners first … last.
    struct Part {
        std::size_t bad = 0;
        double folded = 0;
        std::size_t middle = 0; ///< its piece at the diagonal is (first, middle, last)
    };
    void solve(const std::vector<CellPlace>& corners);
    Part& at(std::size_t first, std::size_t last) { return parts_[first * size_ + last]; }

    std::size_t size_ = 0;
    std::vector<Part> parts_;
    std::vector<std::pair<std::size_t, std::size_t>> open_;
};

} // namespace meshbound
