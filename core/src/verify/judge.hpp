#pragma once

#include <array>
#include <cstddef>
#include <ostream>
#include <vector>

#include "meshbound/mesh.hpp"

namespace judge {

/// The farthest that a sample of one surface lies from the other.
struct Deviation {
    double ratio = 0;                    ///< distance in bounds: 1 is the limit; 0 stands for anything below 1e-6
    std::size_t triangle = 0;            ///< of the sampled surface, counting those with three distinct vertices
    std::array<double, 3> barycentric{}; ///< where in it
    std::array<double, 3> position{};    ///< the same place in space
    std::size_t variable = 0;            ///< which variable is farthest there: 0 position, i + 1 the mesh's variable i
    std::size_t samples = 0;             ///< how many points were looked at
};

/// What the judge found, both ways.
struct Judgement {
    Deviation from_original; ///< from points of the original to the reduced surface
    Deviation from_reduced;  ///< from points of the reduced to the original surface
    double ratio() const;    ///< the worse of the two
};
std::ostream& operator<<(std::ostream& out, const Judgement& judgement);

/// How many points of each surface are looked at, more or less; never fewer than its vertices, edges and triangles.
inline constexpr std::size_t usual_samples = 50'000;

/// Judges a reduced surface by what anyone can see of it, knowing nothing of how it was made. Original and reduced are
/// two surfaces in the joint space of position and variables; if a map keeps the bounds then their Hausdorff distance
/// in the norm max(|Δx| / bound of position, |Δf| / bound of f, ...) is at most 1. Each sample's distance is attained by
/// a point of the other surface (within 1e-6), so only what lies between the samples can hide.
///
/// `bounds`: absolute, of position first, then one a variable; infinity is free. `multipliers`: what multiplies all bounds at
/// each vertex of the original, linear on its triangles; none where nothing does. So a point p of the original, of multiplier
/// m, may be no farther than m from some point of the reduced surface, and for every point of that one there must be such a p
/// which it is no farther from than p's own m. Throws std::invalid_argument where bounds or multipliers are not positive, or
/// the two surfaces do not carry the same variables, or one has no triangle.
Judgement judge(const meshbound::Mesh& original, const meshbound::Mesh& reduced, const std::vector<double>& bounds,
                std::size_t samples = usual_samples, const std::vector<double>& multipliers = {});

/// The same for the two boundaries, as curves: the boundary must map to the boundary. Two closed surfaces agree.
/// A curve against none is infinitely far.
Judgement judge_boundary(const meshbound::Mesh& original, const meshbound::Mesh& reduced,
                         const std::vector<double>& bounds, std::size_t samples = usual_samples,
                         const std::vector<double>& multipliers = {});

} // namespace judge
