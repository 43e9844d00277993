#include "geometry/triangle_intersection.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/vec2.hpp>

#include "geometry/exact_orientation.hpp"

namespace meshbound {
namespace {

using Points = std::array<glm::dvec3, 3>;

/// Whether at least one sign is negative and one positive.
bool have_opposite_signs(int s, int t, int u = 0) { return std::min({s, t, u}) < 0 && std::max({s, t, u}) > 0; }

/// Projects a point along an axis. In a plane at least one of the three projections is one to one; what intersects does
/// so in all of them.
glm::dvec2 drop_axis(int axis, const glm::dvec3& p) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

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

bool contains(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p) {
    return !have_opposite_signs(exact_orientation(t[0], t[1], p), exact_orientation(t[1], t[2], p),
                                exact_orientation(t[2], t[0], p));
}

bool meet_in_plane(const std::array<glm::dvec2, 3>& t, const glm::dvec2& p, const glm::dvec2& q) {
    return segments_meet(t[0], t[1], p, q) || segments_meet(t[1], t[2], p, q) || segments_meet(t[2], t[0], p, q) ||
           contains(t, p);
}

/// Whether an axis separates the segment p, q from a triangle.
bool separated_by_axis(const Points& t, const glm::dvec3& p, const glm::dvec3& q) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::max(p[axis], q[axis]) < std::min({t[0][axis], t[1][axis], t[2][axis]}) ||
            std::min(p[axis], q[axis]) > std::max({t[0][axis], t[1][axis], t[2][axis]}))
            return true;
    return false;
}

/// Whether the closed segment p, q meets the closed triangle.
bool segment_meets(const Points& t, const glm::dvec3& p, const glm::dvec3& q) {
    const int at_p = exact_orientation(t[0], t[1], t[2], p), at_q = exact_orientation(t[0], t[1], t[2], q);
    if (at_p * at_q > 0) return false;
    if (at_p != 0 || at_q != 0) // the line meets the plane in one point, which lies on the segment
        return !have_opposite_signs(exact_orientation(p, q, t[0], t[1]), exact_orientation(p, q, t[1], t[2]),
                                    exact_orientation(p, q, t[2], t[0]));
    if (separated_by_axis(t, p, q)) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (!meet_in_plane({drop_axis(axis, t[0]), drop_axis(axis, t[1]), drop_axis(axis, t[2])}, drop_axis(axis, p),
                           drop_axis(axis, q)))
            return false;
    return true;
}

/// The same triangle, its corners rotated so that corner `first` comes first.
Points rotated(const Points& t, std::size_t first) { return {t[first], t[(first + 1) % 3], t[(first + 2) % 3]}; }

/// Whether the last two corners of a triangle lie strictly on one side of the other's plane: then it meets the plane in
/// its first corner at most.
bool lies_on_one_side(const Points& t, const Points& other) {
    return exact_orientation(other[0], other[1], other[2], t[1]) *
               exact_orientation(other[0], other[1], other[2], t[2]) >
           0;
}

/// Of two triangles without a shared corner: they meet where an edge of one meets the other.
bool meet(const Points& one, const Points& other) {
    for (std::size_t i = 0; i < 3; ++i)
        if (segment_meets(one, other[i], other[(i + 1) % 3]) || segment_meets(other, one[i], one[(i + 1) % 3]))
            return true;
    return false;
}

/// Whether an axis separates two triangles that share their first corner, but for that corner: a cheap early exit.
bool separated_at_corner(const Points& one, const Points& other) {
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

/// Of two triangles that share their first corner: where they meet elsewhere, they do so along a ray from it, which
/// leaves one of them through its opposite edge while inside the other.
bool meet_beyond_corner(const Points& one, const Points& other) {
    if (separated_at_corner(one, other) || lies_on_one_side(one, other) || lies_on_one_side(other, one)) return false;
    return segment_meets(one, other[1], other[2]) || segment_meets(other, one[1], one[2]);
}

/// Of two triangles with the shared edge p, q and opposite corners r and s: they overlap where they are coplanar and on
/// one side of it.
bool meet_beyond_edge(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
    if (exact_orientation(p, q, r, s) != 0) return false;
    for (int axis = 0; axis < 3; ++axis)
        if (exact_orientation(drop_axis(axis, p), drop_axis(axis, q), drop_axis(axis, r)) *
                exact_orientation(drop_axis(axis, p), drop_axis(axis, q), drop_axis(axis, s)) >
            0)
            return true;
    return false;
}

/// Which corners two triangles share.
struct SharedCorners {
    std::size_t count = 0, one = 0, other = 0;        // the last shared corner, …
    std::size_t one_unshared = 0, other_unshared = 0; // … and the last corner of each that the other lacks
};

SharedCorners shared_corners(const SpatialTriangle& one, const SpatialTriangle& other) {
    SharedCorners shared;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto found = std::find(other.ids.begin(), other.ids.end(), one.ids[i]);
        if (found == other.ids.end()) {
            shared.one_unshared = i;
            continue;
        }
        ++shared.count;
        shared.one = i;
        shared.other = static_cast<std::size_t>(found - other.ids.begin());
    }
    for (std::size_t j = 0; j < 3; ++j)
        if (std::find(one.ids.begin(), one.ids.end(), other.ids[j]) == one.ids.end()) shared.other_unshared = j;
    return shared;
}

} // namespace

bool intersect_beyond_shared(const SpatialTriangle& one, const SpatialTriangle& other) {
    const SharedCorners shared = shared_corners(one, other);
    if (shared.count == 0) return meet(one.points, other.points);
    if (shared.count == 1)
        return meet_beyond_corner(rotated(one.points, shared.one), rotated(other.points, shared.other));
    if (shared.count == 3) return true;
    const Points edge = rotated(one.points, (shared.one_unshared + 1) % 3);
    return meet_beyond_edge(edge[0], edge[1], edge[2], other.points[shared.other_unshared]);
}

} // namespace meshbound
