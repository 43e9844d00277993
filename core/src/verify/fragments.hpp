#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/joint_surface.hpp"

namespace meshbound::verification {

/// A part of a triangle that a tree of boxes holds: its corners, in shares of the triangle's second and third vertex.
struct Fragment {
    std::uint32_t triangle = 0;
    std::array<std::array<float, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};

    /// Number `dimension` of the row of a corner.
    double at(const JointSurface& surface, int corner, int dimension) const {
        const auto& [a, b, c] = surface.triangles[triangle];
        const double p = surface.row(a)[dimension], q = surface.row(b)[dimension], r = surface.row(c)[dimension];
        const double u = corners[corner][0], v = corners[corner][1];
        return u == 0 && v == 0 ? p : u == 1 ? q : v == 1 ? r : p + u * (q - p) + v * (r - p);
    }
};

/// The triangles of a surface cut so that boxes around the fragments fit closely. A long thin triangle that lies across the
/// axes has a box that holds much else: of a fan of them nearly every one would be looked at for every point. Together the
/// fragments of a triangle cover it. There are at most twice as many as triangles, or some hundred thousand more.
std::vector<Fragment> cut_into_fragments(const JointSurface& surface);

} // namespace meshbound::verification
