#include "geometry/exact_orientation.hpp"

#include <cmath>
#include <limits>

#include "geometry/expansion.hpp"

namespace meshbound {
namespace {

/// Half of what the library calls epsilon: the largest relative error of one operation.
constexpr double rounding = std::numeric_limits<double>::epsilon() / 2;

/// How far rounding can take the determinants below from the truth, as a fraction of the sum of their terms' magnitudes
/// (Shewchuk's bounds A).
constexpr double error_in_space = (7 + 56 * rounding) * rounding, error_in_plane = (3 + 16 * rounding) * rounding;

int sign(double value) { return (value > 0) - (value < 0); }

/// The differences are exact where they are zero, so a sum of magnitudes that is zero tells as much.
bool certain(double determinant, double magnitude, double error) {
    return std::abs(determinant) > error * magnitude || magnitude == 0;
}

Expansion<16> minor(const Expansion<2>& px, const Expansion<2>& py, const Expansion<2>& qx, const Expansion<2>& qy) {
    return sum(product(px, qy), negated(product(py, qx)));
}

int orientation_by_expansions(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const Expansion<2> ax = difference(a.x, d.x), ay = difference(a.y, d.y), az = difference(a.z, d.z);
    const Expansion<2> bx = difference(b.x, d.x), by = difference(b.y, d.y), bz = difference(b.z, d.z);
    const Expansion<2> cx = difference(c.x, d.x), cy = difference(c.y, d.y), cz = difference(c.z, d.z);
    const auto first = product(minor(bx, by, cx, cy), az);
    const auto second = product(minor(cx, cy, ax, ay), bz);
    const auto third = product(minor(ax, ay, bx, by), cz);
    return -sum(sum(first, second), third).sign();
}

} // namespace

int exact_orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const glm::dvec3 p = a - d, q = b - d, r = c - d;
    const double qr = q.x * r.y, rq = q.y * r.x, rp = r.x * p.y, pr = r.y * p.x, pq = p.x * q.y, qp = p.y * q.x;
    const double determinant = p.z * (qr - rq) + q.z * (rp - pr) + r.z * (pq - qp);
    const double magnitude = std::abs(p.z) * (std::abs(qr) + std::abs(rq)) +
                             std::abs(q.z) * (std::abs(rp) + std::abs(pr)) +
                             std::abs(r.z) * (std::abs(pq) + std::abs(qp));
    if (certain(determinant, magnitude, error_in_space)) return -sign(determinant);
    return orientation_by_expansions(a, b, c, d);
}

int exact_orientation(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
    const glm::dvec2 u = p - r, v = q - r;
    const double left = u.x * v.y, right = u.y * v.x;
    if (certain(left - right, std::abs(left) + std::abs(right), error_in_plane)) return sign(left - right);
    return minor(difference(p.x, r.x), difference(p.y, r.y), difference(q.x, r.x), difference(q.y, r.y)).sign();
}

} // namespace meshbound
