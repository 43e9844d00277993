#include "errors/tracked/joint_space.hpp"

#include <algorithm>
#include <limits>

#include "util/indexing.hpp"

namespace meshbound {
namespace {

double clamped_ratio(double numerator, double denominator, double low, double high) {
    if (!(denominator > 0)) return low;
    return std::clamp(numerator / denominator, low, high);
}

/// 0 where the inverse is not finite.
double inverse_of(double extent) {
    const double inverse = 1 / extent;
    return extent > 0 && inverse < std::numeric_limits<double>::infinity() ? inverse : 0;
}

/// A sum of products no larger than this share of them is noise of rounding: there is no distance.
constexpr double noise_share = 1e-14;

double squared_bc(const PlaneProducts& products) { return products.uu - 2 * products.uv + products.vv; }

JointTriangle::Inverses inverses_of(const PlaneProducts& products) {
    return {inverse_of(products.uu * products.vv - products.uv * products.uv), inverse_of(products.uu),
            inverse_of(products.vv), inverse_of(squared_bc(products))};
}

/// The nearest of the three edges' nearest points.
glm::dvec2 nearest_on_edges(const PlaneProducts& products, const JointTriangle::Inverses& inverses) {
    const auto& [uu, uv, vv, uw, vw, ww] = products;
    const double along_u = std::clamp(uw * inverses.uu, 0.0, 1.0), along_v = std::clamp(vw * inverses.vv, 0.0, 1.0);
    const double along_bc = std::clamp((uu - uv - uw + vw) * inverses.bc, 0.0, 1.0);
    glm::dvec2 best(along_u, 0);
    for (const glm::dvec2& parameters : {glm::dvec2(0, along_v), glm::dvec2(1 - along_bc, along_bc)})
        if (products.squared_at(parameters) < products.squared_at(best)) best = parameters;
    return best;
}

/// In the plane of the triangle.
glm::dvec2 nearest_in_plane(const PlaneProducts& products, const JointTriangle::Inverses& inverses) {
    const auto& [uu, uv, vv, uw, vw, ww] = products;
    return {(uw * vv - vw * uv) * inverses.determinant, (vw * uu - uw * uv) * inverses.determinant};
}

bool lies_inside(const glm::dvec2& parameters) {
    return parameters.x >= 0 && parameters.y >= 0 && parameters.x + parameters.y <= 1;
}

} // namespace

double without_noise(double squared_distance, double products) {
    return squared_distance > noise_share * products ? squared_distance : 0;
}

glm::dvec2 nearest_in_triangle(const PlaneProducts& products) {
    const JointTriangle::Inverses inverses = inverses_of(products);
    const glm::dvec2 parameters = nearest_in_plane(products, inverses);
    return inverses.determinant > 0 && lies_inside(parameters) ? parameters : nearest_on_edges(products, inverses);
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
    inverses_ = inverses_of(edges_);
}

JointTriangle::Nearest JointTriangle::nearest(const double* along, double limit) const {
    const double from_a = along[a_];
    PlaneProducts to_vertex = edges_;
    to_vertex.uw = along[b_] - from_a - au_;
    to_vertex.vw = along[c_] - from_a - av_;
    to_vertex.ww = along[size_] - 2 * from_a + aa_;
    const double products = along[size_] + aa_ + edges_.uu + edges_.vv;
    const bool has_area = inverses_.determinant > 0;
    glm::dvec2 parameters = nearest_in_plane(to_vertex, inverses_);
    double squared_distance = without_noise(to_vertex.squared_at(parameters), products);
    if (!has_area || (squared_distance < limit && !lies_inside(parameters))) {
        parameters = nearest_on_edges(to_vertex, inverses_);
        squared_distance = without_noise(to_vertex.squared_at(parameters), products);
    }
    return {{std::max(0.0, 1 - parameters.x - parameters.y), parameters.x, parameters.y}, squared_distance};
}

glm::dvec2 nearest_parameters(const PlaneProducts& products, double low, double high) {
    const auto& [uu, uv, vv, uw, vw, ww] = products;
    // Clamping one parameter at a time from the unconstrained solution ends at the constrained one or close to it; any
    // parameters are valid ones.
    const double determinant = uu * vv - uv * uv;
    double x = determinant > 0 ? std::clamp((uw * vv - uv * vw) / determinant, low, high) : low;
    double y = clamped_ratio(vw - x * uv, vv, 0, 1);
    x = clamped_ratio(uw - y * uv, uu, low, high);
    y = clamped_ratio(vw - x * uv, vv, 0, 1);
    return {x, y};
}

PlaneProducts products_of(const BoundedRows& rows, const JointSegment& first, const JointSegment& second) {
    const auto lanes = between(first, second);
    LaneProducts sum;
    for (int i = 0; i < rows.lanes(); ++i) sum.add(lanes(i));
    return sum.total();
}

} // namespace meshbound
