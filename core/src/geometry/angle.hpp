#pragma once

#include <cmath>

#include <glm/vec2.hpp>

namespace meshbound {

/// Angles from +, −, ×, ÷ and sqrt alone: the last digits of a libm's atan2 and sin differ from platform to platform, and a
/// reduction must give the same bytes everywhere. Accurate to about 1e-13, more than a layout needs.

inline constexpr double pi = 3.14159265358979323846;

/// Arc tangent of z in [0, 1]: halved twice, then the series.
inline double arc_tangent(double z) {
    z = z / (1 + std::sqrt(1 + z * z));
    z = z / (1 + std::sqrt(1 + z * z));
    const double q = z * z;
    double sum = 0;
    for (int n = 17; n >= 1; n -= 2) sum = 1.0 / n - q * sum;
    return 4 * z * sum;
}

/// The angle of the vector (x, y), y ≥ 0: 0…π. The zero vector has angle 0.
inline double half_plane_angle(double x, double y) {
    const double ax = x < 0 ? -x : x;
    if (ax == 0 && y == 0) return 0;
    const double angle = y <= ax ? arc_tangent(y / ax) : pi / 2 - arc_tangent(ax / y);
    return x < 0 ? pi - angle : angle;
}

/// (cos, sin) of an angle in [0, 2π]: the series for an eighth of it, doubled three times.
inline glm::dvec2 unit_vector(double angle) {
    const double a = angle / 8, q = a * a;
    double sine = 0, cosine = 0;
    for (int n = 15; n >= 1; n -= 2) {
        sine = 1 - q / ((n + 1) * (n + 2)) * sine;
        cosine = 1 - q / (n * (n + 1)) * cosine;
    }
    sine *= a;
    for (int doubling = 0; doubling < 3; ++doubling) {
        const double doubled = 2 * sine * cosine;
        cosine = 1 - 2 * sine * sine;
        sine = doubled;
    }
    return {cosine, sine};
}

} // namespace meshbound
