#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "verify/joint_surface.hpp"

namespace meshbound::verification {

/// A point of a surface by its barycentric coordinates in a triangle.
struct Sample {
    std::uint32_t triangle;
    std::array<double, 3> barycentric;
};

/// Visits about `budget` samples of a surface, always the same ones: every vertex that a triangle uses, at least one
/// point on every edge and one inside every triangle, and more in proportion to length and area in the joint space, so
/// that no part of a large triangle is far from a sample. Ends early where `visit` returns false.
void sample_surface(const JointSurface& surface, std::size_t budget, const std::function<bool(const Sample&)>& visit);

} // namespace meshbound::verification
