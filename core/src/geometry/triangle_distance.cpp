#include "geometry/triangle_distance.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "util/indexing.hpp"

namespace meshbound {
namespace {

unsigned corner_bit(int corner) { return 1U << corner; }

/// The simplex (corner or edge) of the edge from corner i to the next one that has the point at parameter s in its
/// inside.
unsigned simplex_of_edge(int i, double s) {
    const unsigned first = corner_bit(i), last = corner_bit((i + 1) % 3);
    return s <= 0 ? first : s >= 1 ? last : first | last;
}

double clamped_share(double share) { return share > 0 ? std::min(share, 1.0) : 0; }

/// Parameters of the nearest points of two segments. After C. Ericson, Real-Time Collision Detection (2005), §5.1.9.
std::array<double, 2> nearest_shares(const glm::dvec3& p, const glm::dvec3& along_p, const glm::dvec3& q,
                                     const glm::dvec3& along_q) {
    const glm::dvec3 from_q = p - q;
    const double a = glm::dot(along_p, along_p), e = glm::dot(along_q, along_q), b = glm::dot(along_p, along_q);
    const double c = glm::dot(along_p, from_q), f = glm::dot(along_q, from_q), determinant = a * e - b * b;
    double s = determinant > 0 ? clamped_share((b * f - c * e) / determinant) : 0;
    double t = e > 0 ? (b * s + f) / e : 0;
    if (!(e > 0) || t < 0 || t > 1) { // from a point, too, the nearest one is looked for
        t = clamped_share(t);
        s = a > 0 ? clamped_share((b * t - c) / a) : 0;
    }
    return {s, t};
}

void keep_nearer(NearestPoints& nearest, const NearestPoints& found) {
    if (found.squared_distance < nearest.squared_distance) nearest = found;
}

NearestPoints nearest_of_edges(const TrianglePoints& one, int i, const TrianglePoints& other, int j) {
    const glm::dvec3 &p = one[to_index(i)], &q = other[to_index(j)];
    const glm::dvec3 along_p = one[to_index((i + 1) % 3)] - p, along_q = other[to_index((j + 1) % 3)] - q;
    const auto [s, t] = nearest_shares(p, along_p, q, along_q);
    const glm::dvec3 between = (p + s * along_p) - (q + t * along_q);
    return {glm::dot(between, between), simplex_of_edge(i, s), simplex_of_edge(j, t)};
}

/// The squared distance of a point from the face of a triangle, where its foot lies inside; else infinity.
double squared_distance_from_face(const TrianglePoints& t, const glm::dvec3& p) {
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    for (int i = 0; i < 3; ++i)
        if (!(glm::dot(glm::cross(t[to_index((i + 1) % 3)] - t[to_index(i)], p - t[to_index(i)]), normal) > 0))
            return std::numeric_limits<double>::infinity();
    const double height = glm::dot(normal, p - t[0]);
    return height * height / glm::dot(normal, normal);
}

} // namespace

NearestPoints nearest_points(const TrianglePoints& one, const TrianglePoints& other) {
    constexpr unsigned face = 7;
    NearestPoints nearest{std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) keep_nearer(nearest, nearest_of_edges(one, i, other, j));
        keep_nearer(nearest, {squared_distance_from_face(one, other[to_index(i)]), face, corner_bit(i)});
        keep_nearer(nearest, {squared_distance_from_face(other, one[to_index(i)]), corner_bit(i), face});
    }
    return nearest;
}

} // namespace meshbound
