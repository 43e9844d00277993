#pragma once

#include <algorithm>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace meshbound {

/// Geometry in the plane in which a star is laid out.

inline double cross(const glm::dvec2& p, const glm::dvec2& q) { return p.x * q.y - p.y * q.x; }

/// Twice the signed area of the triangle p, q, r; positive when counter-clockwise.
inline double orientation(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Barycentric coordinates of p in the triangle q, r, s, moved into the triangle where they lie outside.
inline glm::dvec3 clamped_barycentric(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r,
                                      const glm::dvec2& s) {
    glm::dvec3 weight(orientation(p, r, s), orientation(q, p, s), orientation(q, r, p));
    for (int i = 0; i < 3; ++i) weight[i] = weight[i] > 0 ? weight[i] : 0;
    const double sum = weight.x + weight.y + weight.z;
    if (!(sum > 0)) return glm::dvec3(1, 0, 0);
    weight /= sum;
    weight.z = std::max(0.0, 1 - weight.x - weight.y); // sums to 1, so that the point lies on the triangle
    return weight;
}

/// Clamped to [low, high]; NaN, from a degenerate crossing, becomes low.
inline double clamped(double x, double low, double high) { return x > low ? std::min(x, high) : low; }

} // namespace meshbound
