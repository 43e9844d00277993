#include "joint_space.hpp"

#include <algorithm>

namespace meshbound {
namespace {

/// Calls `visit(i)` for every component that is bounded.
template <class Visit> void for_each_bounded(const Rows& rows, const Visit& visit) {
    for (const RowGroup& group : rows.groups()) {
        if (!group.bounded) continue;
        for (int i = group.first; i < group.first + group.count; ++i) visit(i);
    }
}

double ratio_within(double numerator, double denominator, double low, double high) {
    if (!(denominator > 0)) return low;
    return std::clamp(numerator / denominator, low, high);
}

} // namespace

JointTriangle::JointTriangle(const Rows& rows, const double* a, const double* b, const double* c)
    : rows_(&rows), a_(a), b_(b), c_(c) {
    for_each_bounded(rows, [&](int i) {
        const double u = b[i] - a[i], v = c[i] - a[i];
        uu_ += u * u;
        uv_ += u * v;
        vv_ += v * v;
    });
}

/// p and q: the point's dot products with u and v. The nearest of the three edges' nearest points, as (weight of b, of c).
glm::dvec2 JointTriangle::nearest_on_edges(double p, double q) const {
    const auto squared_distance = [&](double x, double y) { // less the point's own squared length
        return x * x * uu_ + 2 * x * y * uv_ + y * y * vv_ - 2 * (x * p + y * q);
    };
    const double along_u = ratio_within(p, uu_, 0, 1), along_v = ratio_within(q, vv_, 0, 1);
    const double along_bc = ratio_within(uu_ - uv_ - p + q, uu_ - 2 * uv_ + vv_, 0, 1);
    glm::dvec2 best(along_u, 0);
    for (const glm::dvec2& place : {glm::dvec2(0, along_v), glm::dvec2(1 - along_bc, along_bc)})
        if (squared_distance(place.x, place.y) < squared_distance(best.x, best.y)) best = place;
    return best;
}

glm::dvec3 JointTriangle::nearest(const double* row) const {
    double p = 0, q = 0;
    for_each_bounded(*rows_, [&](int i) {
        const double d = row[i] - a_[i];
        p += d * (b_[i] - a_[i]);
        q += d * (c_[i] - a_[i]);
    });
    const double determinant = uu_ * vv_ - uv_ * uv_;
    glm::dvec2 place((p * vv_ - q * uv_) / determinant, (q * uu_ - p * uv_) / determinant);
    if (!(determinant > 0 && place.x >= 0 && place.y >= 0 && place.x + place.y <= 1)) place = nearest_on_edges(p, q);
    return {std::max(0.0, 1 - place.x - place.y), place.x, place.y};
}

glm::dvec2 nearest_parameters(const Rows& rows, const JointSegment& first, double s_low, double s_high,
                              const JointSegment& second) {
    double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0; // u, v: the segments; w: from the first's start to the second's
    for_each_bounded(rows, [&](int i) {
        const double u = first.end[i] - first.start[i], v = second.end[i] - second.start[i];
        const double w = second.start[i] - first.start[i];
        uu += u * u;
        uv += u * v;
        vv += v * v;
        uw += u * w;
        vw += v * w;
    });
    // Alternating along one parameter at a time from the unconstrained solution ends at the constrained one after two
    // steps: the optimum lies inside or on the side of the box that the first step hits.
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 0 ? std::clamp((uw * vv - uv * vw) / determinant, s_low, s_high) : s_low;
    double t = ratio_within(s * uv - vw, vv, 0, 1);
    s = ratio_within(uw + t * uv, uu, s_low, s_high);
    t = ratio_within(s * uv - vw, vv, 0, 1);
    return {s, t};
}

} // namespace meshbound
