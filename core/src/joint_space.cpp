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

/// The nearest of the three edges' nearest points.
glm::dvec2 nearest_on_edges(const PlaneProducts& products) {
    const auto& [uu, uv, vv, uw, vw, ww] = products;
    const double along_u = ratio_within(uw, uu, 0, 1), along_v = ratio_within(vw, vv, 0, 1);
    const double along_bc = ratio_within(uu - uv - uw + vw, uu - 2 * uv + vv, 0, 1);
    glm::dvec2 best(along_u, 0);
    for (const glm::dvec2& place : {glm::dvec2(0, along_v), glm::dvec2(1 - along_bc, along_bc)})
        if (products.squared_at(place) < products.squared_at(best)) best = place;
    return best;
}

/// 0 where the two have no area.
double inverse_of_determinant(const PlaneProducts& products) {
    const double determinant = products.uu * products.vv - products.uv * products.uv;
    return determinant > 0 ? 1 / determinant : 0;
}

glm::dvec2 nearest_in_triangle(const PlaneProducts& products, double inverse_determinant) {
    const auto& [uu, uv, vv, uw, vw, ww] = products;
    const glm::dvec2 place((uw * vv - vw * uv) * inverse_determinant, (vw * uu - uw * uv) * inverse_determinant);
    const bool inside = inverse_determinant > 0 && place.x >= 0 && place.y >= 0 && place.x + place.y <= 1;
    return inside ? place : nearest_on_edges(products);
}

} // namespace

double without_noise(double squared_distance, double products) {
    return squared_distance > noise_share * products ? squared_distance : 0;
}

glm::dvec2 nearest_in_triangle(const PlaneProducts& products) {
    return nearest_in_triangle(products, inverse_of_determinant(products));
}

JointTriangle::JointTriangle(const HoleProducts& products, int a, int b, int c)
    : a_(a), b_(b), c_(c), size_(products.size()) {
    aa_ = products.ring(a, a);
    const double ab = products.ring(a, b), ac = products.ring(a, c);
    au_ = ab - aa_;
    av_ = ac - aa_;
    edges_.uu = products.ring(b, b) - ab - au_;
    edges_.uv = products.ring(b, c) - ac - au_;
    edges_.vv = products.ring(c, c) - ac - av_;
    inverse_determinant_ = inverse_of_determinant(edges_);
}

JointTriangle::Nearest JointTriangle::nearest(const double* along) const {
    const double from_a = along[a_];
    PlaneProducts to_vertex = edges_;
    to_vertex.uw = along[b_] - from_a - au_;
    to_vertex.vw = along[c_] - from_a - av_;
    const glm::dvec2 place = nearest_in_triangle(to_vertex, inverse_determinant_);
    const double own = along[size_] - 2 * from_a + aa_;
    return {{std::max(0.0, 1 - place.x - place.y), place.x, place.y},
            without_noise(own + to_vertex.squared_at(place), along[size_] + aa_ + edges_.uu + edges_.vv)};
}

glm::dvec2 nearest_parameters(const PlaneProducts& products, double low, double high) {
    const auto& [uu, uv, vv, uw, vw, ww] = products;
    // Clamping one parameter at a time from the unconstrained solution ends at the constrained one or close to it; any
    // parameters are valid ones.
    const double determinant = uu * vv - uv * uv;
    double x = determinant > 0 ? std::clamp((uw * vv - uv * vw) / determinant, low, high) : low;
    double y = ratio_within(vw - x * uv, vv, 0, 1);
    x = ratio_within(uw - y * uv, uu, low, high);
    y = ratio_within(vw - x * uv, vv, 0, 1);
    return {x, y};
}

PlaneProducts products_of(const MeasuredRows& rows, const JointSegment& first, const JointSegment& second) {
    const auto lanes = between(first, second);
    LaneProducts sum;
    for (int i = 0; i < rows.lanes(); ++i) sum.add(lanes(i));
    return sum.total();
}

} // namespace meshbound
