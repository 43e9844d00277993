#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "surface/surface.hpp"

namespace meshbound {

/// The star of a candidate: what vanishes with it. What remains when it is gone is the hole, bounded by the ring.
///
///     closed: an interior candidate,          open: a boundary candidate,
///     4 ring vertices, 4 sectors              4 ring vertices, 3 sectors
///
///           r1                                     r2 ---- r1
///         / | \       sector i lies              /  \    /  \    .
///       r2--c--r0     between the spokes         / s2 \s1/ s0 \   .
///         \ | /       to r(i) and r(i+1)       r3 ---- c ---- r0     boundary: r3 → c → r0
///           r3
struct Hole {
    std::uint32_t candidate = no_index;
    bool open = false;
    std::vector<std::uint32_t> ring;            ///< vertices, counter-clockwise
    std::vector<std::uint32_t> spoke_edges;     ///< edge between candidate and ring[i]
    std::vector<std::uint32_t> slots;           ///< triangle of each sector
    std::vector<std::uint32_t> link_half_edges; ///< ring[i] → ring[i + 1], in the sector's triangle
    std::vector<std::uint32_t> link_edges;      ///< the edges of these, the link of the candidate
    std::vector<glm::dvec3> positions;          ///< of ring[i], in bounds of position (filled by lay_out)
    std::vector<glm::dvec3> spokes; ///< ring[i] less the candidate, in bounds of position (filled by lay_out)
    std::vector<glm::dvec2> layout; ///< ring[i] in the plane, the candidate at the origin (filled by lay_out)

    int size() const { return static_cast<int>(ring.size()); }
    int sectors() const { return static_cast<int>(slots.size()); }
    /// The ring index after i, cyclically.
    int after(int i) const { return i + 1 == size() ? 0 : i + 1; }
};

/// A hole with more corners is left alone: the dynamic programme takes the cube of their number, and the valence of
/// such a vertex falls as its neighbours are removed.
inline constexpr int largest_ring = 48;

/// One triangle of a retriangulation, by ring indices a < m < b. The triangles form a tree (the dual of the
/// triangulation): the root has the edge (0, last), every other one shares the diagonal (a, b) with its parent.
struct NewTriangle {
    int a = 0, m = 0, b = 0;
    int parent = -1;               ///< across (a, b); -1: the root
    int left = -1, right = -1;     ///< across (a, m) and (m, b); -1: a link edge
    std::uint32_t slot = no_index; ///< the triangle it becomes (filled when the surface takes it)
    std::uint32_t edge = no_index; ///< the edge that (a, b) becomes: a diagonal or the closing edge
};

/// Triangles that fill a hole, parents before children.
struct Retriangulation {
    std::vector<NewTriangle> triangles;
};

/// Gathers the star of an interior or boundary vertex. The hole's vectors are reused, so that the loop does not
/// allocate.
void gather_star(const Surface& surface, std::uint32_t candidate, Hole& hole);

} // namespace meshbound
