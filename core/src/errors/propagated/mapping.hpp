#pragma once

#include <vector>

#include "metric/rows.hpp"
#include "retriangulation/overlap.hpp"
#include "surface/hole.hpp"

namespace meshbound {

/// The mapping between a star and a retriangulation of its hole (§3.2, figures 2, 3 and 5). Old and new triangles overlap in
/// pieces on which everything is linear, so differences stand at the corners of the pieces alone: where a diagonal crosses
/// a spoke, and at the candidate. A difference is a row: star minus new triangle (§3.3.2), in bounds, and behind it the
/// signed distance of §3.3.1, positive where the new triangle lies outside.
class StarMap {
public:
    /// Intersects every possible diagonal with the spokes. The hole is laid out.
    void enter(const Rows& rows, const Hole& hole);

    /// Numbers in a difference: the row and the signed distance.
    int width() const { return rows_->width() + 1; }

    /// Difference where the diagonal (a, b) crosses spoke s; null where it does not.
    const double* crossing(int a, int b, int s) const;
    /// Difference at the candidate when it lies in the triangle a < m < b (an open hole's goes to the closing edge). The row is
    /// overwritten by the next call.
    const double* candidate(int a, int m, int b);

private:
    void cross_spokes(int a, int b);
    void difference(const double* star, int a, int b, double t, double* out) const;
    void append_signed_distance(double* row) const;

    const Rows* rows_ = nullptr;
    const Hole* hole_ = nullptr;
    glm::dvec3 normal_{0};
    std::vector<std::size_t> offsets_; // [a * size + b]: where the crossings of the diagonal begin in crossings_
    std::vector<double> crossings_;
    std::vector<double> candidate_;
    std::vector<double> scratch_, lengths_;
};

} // namespace meshbound
