#include "joint_space.hpp"

#include <algorithm>

namespace meshbound {
namespace {

double ratio_within(double numerator, double denominator, double low, double high) {
    if (!(denominator > 0)) return low;
    return std::clamp(numerator / denominator, low, high);
}

double total(const Lane& lane) { return lane[0] + lane[1]; }

} // namespace

JointTriangle::JointTriangle(const MeasuredRows& rows, const double* a, const double* b, const double* c)
    : a_(a), b_(b), c_(c) {
    Lane uu = {0, 0}, uv = {0, 0}, vv = {0, 0};
    for (int i = 0; i < rows.lanes(); ++i) {
        const Lane u = MeasuredRows::lane(b, i) - MeasuredRows::lane(a, i);
        const Lane v = MeasuredRows::lane(c, i) - MeasuredRows::lane(a, i);
        uu += u * u;
        uv += u * v;
        vv += v * v;
    }
    uu_ = total(uu);
    uv_ = total(uv);
    vv_ = total(vv);
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

glm::dvec3 JointTriangle::nearest(double p, double q) const {
    const double determinant = uu_ * vv_ - uv_ * uv_;
    glm::dvec2 place((p * vv_ - q * uv_) / determinant, (q * uu_ - p * uv_) / determinant);
    if (!(determinant > 0 && place.x >= 0 && place.y >= 0 && place.x + place.y <= 1)) place = nearest_on_edges(p, q);
    return {std::max(0.0, 1 - place.x - place.y), place.x, place.y};
}

glm::dvec2 nearest_parameters(const MeasuredRows& rows, const JointSegment& first, double s_low, double s_high,
                              const JointSegment& second) {
    Lane sum_uu = {0, 0}, sum_uv = {0, 0}, sum_vv = {0, 0}, sum_uw = {0, 0}, sum_vw = {0, 0};
    for (int i = 0; i < rows.lanes(); ++i) { // u, v: the segments; w: from the first's start to the second's
        const Lane start = MeasuredRows::lane(first.start, i), second_start = MeasuredRows::lane(second.start, i);
        const Lane u = MeasuredRows::lane(first.end, i) - start, v = MeasuredRows::lane(second.end, i) - second_start;
        const Lane w = second_start - start;
        sum_uu += u * u;
        sum_uv += u * v;
        sum_vv += v * v;
        sum_uw += u * w;
        sum_vw += v * w;
    }
    const double uu = total(sum_uu), uv = total(sum_uv), vv = total(sum_vv), uw = total(sum_uw), vw = total(sum_vw);
    // Clamping one parameter at a time from the unconstrained solution ends at the constrained one or close to it; any
    // parameters are valid ones.
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 0 ? std::clamp((uw * vv - uv * vw) / determinant, s_low, s_high) : s_low;
    double t = ratio_within(s * uv - vw, vv, 0, 1);
    s = ratio_within(uw + t * uv, uu, s_low, s_high);
    t = ratio_within(s * uv - vw, vv, 0, 1);
    return {s, t};
}

} // namespace meshbound
