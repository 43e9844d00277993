#include "geometry/triangle_contact.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/vec2.hpp>

#include "geometry/exact_orientation.hpp"

namespace meshbound {
namespace {

using Points = std::array<glm::dvec3, 3>;

/// Whether one sign at least is negative and one positive.
bool differ(int s, int t, int u = 0) { return std::min({s, t, u}) < 0 && std::max({s, t, u}) > 0; }

/// A point without one of its coordinates. What lies in a plane is seen rightly along one axis at least, and things that
/// meet do so along all of them.
glm::dvec2 along(int axis, const glm::dvec3& p) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

bool in_box(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& x) {
    const auto between = [](double a, double b, double c) { return std::min(a, b) <= c && c <= std::max(a, b); };
    return between(p.x, q.x, x.x) && between(p.y, q.y, x.y);
}

bool segments_meet(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r, const glm::dvec2& s) {
    const int rs_p = exact_orientation(r, s, p), rs_q = exact_orientation(r, s, q);
    const int pq_r = exact_orientation(p, q, r), pq_s = exact_orientation(p, q, s);
    if (rs_p * rs_q < 0 && pq_r * pq_s < 0) return true;
    return (rs_p == 0 && in_box(r, s, p)) || (rs_q == 0 && in_box(r, s, q)) || (pq_r == 0 && in_box(p, q, r)) ||
           (pq_s == 0 && in_box(p, q, s));
}

bool holds(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p) {
    return !differ(exact_orientation(t[0], t[1], p), exact_orientation(t[1], t[2], p),
                   exact_orientation(t[2], t[0], p));
}

bool meet_in_plane(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p, const glm::dvec2& q) {
    return segments_meet(t[0], t[1], p, q) || segments_meet(t[1], t[2], p, q) || segments_meet(t[2], t[0], p, q) ||
           holds(t, p);
}

/// Whether a segment lies, along some axis, on one side of a triangle.
bool apart(const Points& t, const glm::dvec3& p, const glm::dvec3& q) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::max(p[axis], q[axis]) < std::min({t[0][axis], t[1][axis], t[2][axis]}) ||
            std::min(p[axis], q[axis]) > std::max({t[0][axis], t[1][axis], t[2][axis]}))
            return true;
    return false;
}

/// Whether the segment p, q meets the triangle, ends and rim among both.
bool segment_meets(const Points& t, const glm::dvec3& p, const glm::dvec3& q) {
    const int at_p = exact_orientation(t[0], t[1], t[2], p), at_q = exact_orientation(t[0], t[1], t[2], q);
    if (at_p * at_q > 0) return false;
    if (at_p != 0 || at_q != 0) // the line meets the plane in one point, which lies on the segment
        return !differ(exact_orientation(p, q, t[0], t[1]), exact_orientation(p, q, t[1], t[2]),
                       exact_orientation(p, q, t[2], t[0]));
    if (apart(t, p, q)) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (!meet_in_plane({along(axis, t[0]), along(axis, t[1]), along(axis, t[2])}, along(axis, p), along(axis, q)))
            return false;
    return true;
}

/// The same triangle with its corners turned so that corner `first` comes first.
Points turned(const Points& t, std::size_t first) { return {t[first], t[(first + 1) % 3], t[(first + 2) % 3]}; }

/// Whether the last two points of a triangle lie strictly on one side of the other's plane, so that it meets the plane in its
/// first point at most.
bool lies_aside(const Points& t, const Points& other) {
    return exact_orientation(other[0], other[1], other[2], t[1]) *
               exact_orientation(other[0], other[1], other[2], t[2]) >
           0;
}

/// Two triangles without a common corner: where they meet, an edge of one meets the other.
bool meet(const Points& one, const Points& other) {
    for (std::size_t i = 0; i < 3; ++i)
        if (segment_meets(one, other[i], other[(i + 1) % 3]) || segment_meets(other, one[i], one[(i + 1) % 3]))
            return true;
    return false;
}

/// Whether two triangles with their first corners in common lie, along some axis, on either side of these, one of them with
/// nothing but its corner in between: a test that costs next to nothing.
bool part_at_corner(const Points& one, const Points& other) {
    for (int axis = 0; axis < 3; ++axis) {
        const double corner = one[0][axis];
        const double one_least = std::min(one[1][axis], one[2][axis]), one_most = std::max(one[1][axis], one[2][axis]);
        const double least = std::min(other[1][axis], other[2][axis]), most = std::max(other[1][axis], other[2][axis]);
        if ((one_most < corner && corner <= least) || (one_most <= corner && corner < least) ||
            (most < corner && corner <= one_least) || (most <= corner && corner < one_least))
            return true;
    }
    return false;
}

/// Two triangles with their first corners in common: where they meet elsewhere, a ray from there leaves one of them through
/// the edge that faces the corner, inside the other.
bool meet_beyond_corner(const Points& one, const Points& other) {
    if (part_at_corner(one, other) || lies_aside(one, other) || lies_aside(other, one)) return false;
    return segment_meets(one, other[1], other[2]) || segment_meets(other, one[1], one[2]);
}

/// Two triangles with the edge p, q in common and the tips r and s: they meet elsewhere where they lie in one plane on one
/// side of it.
bool meet_beyond_edge(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
    if (exact_orientation(p, q, r, s) != 0) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (exact_orientation(along(axis, p), along(axis, q), along(axis, r)) *
                exact_orientation(along(axis, p), along(axis, q), along(axis, s)) >
            0)
            return true;
    return false;
}

/// Which corners two triangles have in common.
struct Common {
    std::size_t count = 0, one = 0, other = 0;  // the last common corner, …
    std::size_t one_alone = 0, other_alone = 0; // … and the last corner of each that the other lacks
};

Common common_corners(const PlacedTriangle& one, const PlacedTriangle& other) {
    Common common;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto found = std::find(other.places.begin(), other.places.end(), one.places[i]);
        if (found == other.places.end()) {
            common.one_alone = i;
            continue;
        }
        ++common.count;
        common.one = i;
        common.other = static_cast<std::size_t>(found - other.places.begin());
    }
    for (std::size_t j = 0; j < 3; ++j)
        if (std::find(one.places.begin(), one.places.end(), other.places[j]) == one.places.end())
            common.other_alone = j;
    return common;
}

} // namespace

bool pierce(const PlacedTriangle& one, const PlacedTriangle& other) {
    const Common common = common_corners(one, other);
    if (common.count == 0) return meet(one.points, other.points);
    if (common.count == 1)
        return meet_beyond_corner(turned(one.points, common.one), turned(other.points, common.other));
    if (common.count == 3) return true;
    const Points edge = turned(one.points, (common.one_alone + 1) % 3);
    return meet_beyond_edge(edge[0], edge[1], edge[2], other.points[common.other_alone]);
}

} // namespace meshbound
