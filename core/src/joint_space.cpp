#include "joint_space.hpp"

#include <algorithm>

#include "indexing.hpp"

namespace meshbound {
namespace {

double ratio_within(double numerator, double denominator, double low, double high) {
    if (!(denominator > 0)) return low;
    return std::clamp(numerator / denominator, low, high);
}

/// A sum of products no larger than this share of them is noise of rounding: there is no distance.
constexpr double noise_share = 1e-14;

double total(const Lane& lane) { return lane[0] + lane[1]; }

} // namespace

double without_noise(double squared_distance, double products) {
    return squared_distance > noise_share * products ? squared_distance : 0;
}

JointTriangle::JointTriangle(const HoleProducts& products, int a, int b, int c)
    : a_(a), b_(b), c_(c), size_(products.size()) {
    aa_ = products.ring(a, a);
    const double ab = products.ring(a, b), ac = products.ring(a, c);
    au_ = ab - aa_;
    av_ = ac - aa_;
    uu_ = products.ring(b, b) - ab - au_;
    uv_ = products.ring(b, c) - ac - au_;
    vv_ = products.ring(c, c) - ac - av_;
    const double determinant = uu_ * vv_ - uv_ * uv_;
    inverse_determinant_ = determinant > 0 ? 1 / determinant : 0;
}

/// p and q: dot products of the vertex less a with u and v; less the vertex's own square.
double JointTriangle::squared_distance(const glm::dvec2& place, double p, double q) const {
    return place.x * (place.x * uu_ + 2 * (place.y * uv_ - p)) + place.y * (place.y * vv_ - 2 * q);
}

/// The nearest of the three edges' nearest points, as (weight of b, of c).
glm::dvec2 JointTriangle::nearest_on_edges(double p, double q) const {
    const double along_u = ratio_within(p, uu_, 0, 1), along_v = ratio_within(q, vv_, 0, 1);
    const double along_bc = ratio_within(uu_ - uv_ - p + q, uu_ - 2 * uv_ + vv_, 0, 1);
    glm::dvec2 best(along_u, 0);
    for (const glm::dvec2& place : {glm::dvec2(0, along_v), glm::dvec2(1 - along_bc, along_bc)})
        if (squared_distance(place, p, q) < squared_distance(best, p, q)) best = place;
    return best;
}

JointTriangle::Nearest JointTriangle::nearest(const double* along) const {
    const double from_a = along[a_];
    const double p = along[b_] - from_a - au_, q = along[c_] - from_a - av_;
    glm::dvec2 place((p * vv_ - q * uv_) * inverse_determinant_, (q * uu_ - p * uv_) * inverse_determinant_);
    if (!(inverse_determinant_ > 0 && place.x >= 0 && place.y >= 0 && place.x + place.y <= 1))
        place = nearest_on_edges(p, q);
    const double own = along[size_] - 2 * from_a + aa_;
    return {{std::max(0.0, 1 - place.x - place.y), place.x, place.y},
            without_noise(own + squared_distance(place, p, q), along[size_] + aa_ + uu_ + vv_)};
}

glm::dvec2 nearest_parameters(const SegmentProducts& products, double s_low, double s_high) {
    const auto& [uu, uv, vv, uw, vw] = products;
    // Clamping one parameter at a time from the unconstrained solution ends at the constrained one or close to it; any
    // parameters are valid ones.
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 0 ? std::clamp((uw * vv - uv * vw) / determinant, s_low, s_high) : s_low;
    double t = ratio_within(s * uv - vw, vv, 0, 1);
    s = ratio_within(uw + t * uv, uu, s_low, s_high);
    t = ratio_within(s * uv - vw, vv, 0, 1);
    return {s, t};
}

SegmentProducts products_of(const MeasuredRows& rows, const JointSegment& first, const JointSegment& second) {
    Lane uu = {0, 0}, uv = {0, 0}, vv = {0, 0}, uw = {0, 0}, vw = {0, 0};
    for (int i = 0; i < rows.lanes(); ++i) {
        const Lane start = MeasuredRows::lane(first.start, i), second_start = MeasuredRows::lane(second.start, i);
        const Lane u = MeasuredRows::lane(first.end, i) - start, v = MeasuredRows::lane(second.end, i) - second_start;
        const Lane w = second_start - start;
        uu += u * u;
        uv += u * v;
        vv += v * v;
        uw += u * w;
        vw += v * w;
    }
    return {total(uu), total(uv), total(vv), total(uw), total(vw)};
}

} // namespace meshbound
