#include "errors/propagated/mapping.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/plane.hpp"
#include "retriangulation/layout.hpp"
#include "util/indexing.hpp"

namespace meshbound {
void StarMap::enter(const Rows& rows, const Hole& hole) {
    rows_ = &rows;
    hole_ = &hole;
    normal_ = star_normal(hole);
    const double length = glm::length(normal_);
    if (length > 0) normal_ /= length;
    const int size = hole.size();
    candidate_.resize(to_index(width()));
    offsets_.assign(to_index(size * size), 0);
    crossings_.clear();
    for (int a = 0; a < size; ++a)
        for (int b = a + 2; b < size; ++b) {
            offsets_[to_index(a * size + b)] = crossings_.size();
            cross_spokes(a, b);
        }
}

/// Where the diagonal crosses each spoke: share u of the spoke by the layout, share t of the diagonal by proportional lengths
/// of the polyline that it makes on the star (figure 2).
void StarMap::cross_spokes(int a, int b) {
    const RingRange range = crossed_spokes(*hole_, a, b);
    const glm::dvec2 p = hole_->layout[to_index(a)], d = hole_->layout[to_index(b)] - p;
    const auto width = to_index(rows_->width());
    const double* centre = (*rows_)[hole_->candidate];
    scratch_.resize(to_index(range.count) * width);
    lengths_.clear();
    glm::dvec3 last = rows_->position(hole_->ring[to_index(a)]);
    double total = 0;
    const auto walk_to = [&](const glm::dvec3& point) {
        total += glm::distance(last, point);
        last = point;
    };
    // Along the diagonal from a to b the spokes come rising where the candidate is on the other side, falling else.
    const bool rising = !contains_candidate(*hole_, a, b);
    const auto spoke_of = [&](int n) { return (range.first + (rising ? n : range.count - 1 - n)) % hole_->size(); };
    for (int n = 0; n < range.count; ++n) {
        const int s = spoke_of(n);
        const double u = clamped(cross(p, d) / cross(hole_->layout[to_index(s)], d), 0, 1);
        const double* tip = (*rows_)[hole_->ring[to_index(s)]];
        double* row = &scratch_[to_index(n) * width];
        for (std::size_t i = 0; i < width; ++i) row[i] = centre[i] + u * (tip[i] - centre[i]);
        walk_to({row[0], row[1], row[2]});
        lengths_.push_back(total);
    }
    walk_to(rows_->position(hole_->ring[to_index(b)]));
    const std::size_t offset = crossings_.size();
    crossings_.resize(offset + to_index(range.count) * to_index(this->width()));
    for (int n = 0; n < range.count; ++n) {
        const int position_in_range = rising ? n : range.count - 1 - n;
        const double t = total > 0 ? lengths_[to_index(n)] / total : 0.5;
        difference(&scratch_[to_index(n) * width], a, b, t,
                   &crossings_[offset + to_index(position_in_range * this->width())]);
    }
}

/// Star row minus the row at share t of the edge between ring indices a and b.
void StarMap::difference(const double* star, int a, int b, double t, double* out) const {
    const double* start = (*rows_)[hole_->ring[to_index(a)]];
    const double* end = (*rows_)[hole_->ring[to_index(b)]];
    for (int i = 0; i < rows_->width(); ++i) out[i] = star[i] - (start[i] + t * (end[i] - start[i]));
    append_signed_distance(out);
}

void StarMap::append_signed_distance(double* row) const {
    row[rows_->width()] = -glm::dot(glm::dvec3(row[0], row[1], row[2]), normal_);
}

const double* StarMap::crossing(int a, int b, int s) const {
    const RingRange range = crossed_spokes(*hole_, a, b);
    const int n = (s - range.first + hole_->size()) % hole_->size();
    return n < range.count ? &crossings_[offsets_[to_index(a * hole_->size() + b)] + to_index(n * width())] : nullptr;
}

const double* StarMap::candidate(int a, int m, int b) {
    const double* centre = (*rows_)[hole_->candidate];
    if (hole_->open) { // onto the closing edge, at proportional lengths (figure 3)
        const glm::dvec3 c = rows_->position(hole_->candidate);
        const double before = glm::distance(rows_->position(hole_->ring[to_index(a)]), c);
        const double behind = glm::distance(c, rows_->position(hole_->ring[to_index(b)]));
        difference(centre, a, b, before + behind > 0 ? before / (before + behind) : 0.5, candidate_.data());
        return candidate_.data();
    }
    const glm::dvec3 share = clamped_barycentric(glm::dvec2(0), hole_->layout[to_index(a)], hole_->layout[to_index(m)],
                                                 hole_->layout[to_index(b)]);
    const double* p = (*rows_)[hole_->ring[to_index(a)]];
    const double* q = (*rows_)[hole_->ring[to_index(m)]];
    const double* r = (*rows_)[hole_->ring[to_index(b)]];
    for (int i = 0; i < rows_->width(); ++i)
        candidate_[to_index(i)] = centre[i] - (share.x * p[i] + share.y * q[i] + share.z * r[i]);
    append_signed_distance(candidate_.data());
    return candidate_.data();
}

} // namespace meshbound
