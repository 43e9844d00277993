#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "meshbound/api.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/progress.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// A ratio in a verdict is too large by no more than this, in bounds: so a ratio up to 1 + `verify_accuracy` keeps them.
inline constexpr double verify_accuracy = 1e-6;

/// How thoroughly `verify` looks, and at what.
struct VerifyOptions {
    /// How many points of each surface are looked at, more or less; never fewer than its vertices, edges and triangles.
    std::size_t samples = 50'000;
    /// The same of each boundary; never fewer than its vertices and edges.
    std::size_t boundary_samples = 50'000;
    /// What multiplies all bounds at each vertex of the original, linear on its triangles: one finite number above zero a
    /// vertex, or none at all. What stands at vertices of no triangle counts for nothing.
    std::vector<double> multipliers;
};

/// The sample of one surface that lies farthest from the other.
struct Deviation {
    double ratio = 0;                    ///< distance in bounds: 1 is the limit; 0 stands for anything below 1e-6
    std::size_t triangle = 0;            ///< of the sampled surface, counting those with three distinct vertices; of a
                                         ///< boundary the edge
    std::array<double, 3> barycentric{}; ///< where in it
    std::array<double, 3> position{};    ///< the same point in space, in the user's unit of length
    std::size_t variable = 0;            ///< which variable is farthest there: 0 position, i + 1 the mesh's variable i
    std::size_t samples = 0;             ///< how many points were looked at
};

/// What was found between two surfaces, or two boundaries, both ways.
struct Judgement {
    Deviation from_original; ///< from points of the original to the reduced surface
    Deviation from_reduced;  ///< from points of the reduced surface to the original
    double ratio() const { return std::max(from_original.ratio, from_reduced.ratio); } ///< the worse of the two
};

/// What the judge says of a reduced surface.
struct Verdict {
    Judgement surface;
    Judgement boundary; ///< as curves: the boundary must map to the boundary. Infinite where only one surface has one
    bool cancelled = false; ///< `progress` cancelled: not all was looked at

    double ratio() const { return std::max(surface.ratio(), boundary.ratio()); } ///< the worse of the two
    /// Whether all was looked at and no bound is broken at any sample.
    bool within_bounds() const { return !cancelled && ratio() <= 1 + verify_accuracy; }
};

/// Judges a reduced surface by what anyone can see of it, whoever made it and however: no map is asked for, and nothing
/// that reduces is used.
///
/// Original and reduced are two surfaces in the joint space of position and variables. If a continuous map of one onto the
/// other keeps the bounds, then their Hausdorff distance in the norm max(|Δx| / bound of position, |Δf| / bound of f, …) is
/// at most 1, and that of their boundaries, too. This distance is measured from samples of each surface to the whole of the
/// other one, by the distance of a point from a triangle in this norm, within `verify_accuracy`.
///
/// - A ratio above 1 + `verify_accuracy` proves that there is no map which keeps the bounds.
/// - A ratio up to that proves that each sample has a point of the other surface within the bounds. It does not prove that
///   there is a map, nor anything of the points between the samples. (What `reduce` guarantees is proved by its map instead.)
///
/// `bounds`: absolute, each in the unit of its variable, that of position first, then one a variable of the original; each
/// above zero, infinity where it is free. `reduced` has the bounded variables of the original by the same names and numbers.
/// With multipliers a point p of the original, of multiplier m, may be no farther than m from some point of the reduced
/// surface, and for every point of that one there must be such a p that it is no farther from than p's own m.
///
/// Faults: those of `validate` for either mesh, whose message says which; unknown_variable and bad_components where the
/// reduced surface has not a bounded variable of the original; non_finite_value where one is NaN or infinite on the surface;
/// bad_bound; bound_too_fine where a surface is wider than 2e9 bounds of a variable, beside which the accuracy could not be
/// kept; bad_option for multipliers; out_of_memory. `verdict` is then untouched. A cancelled call returns an ok status and
/// what was found so far, marked as cancelled.
///
/// Source: the sampled Hausdorff distance is that of P. Cignoni, C. Rocchini, R. Scopigno, *Metro: measuring error on simplified
/// surfaces* (1998), in place of whose distance in space stands the one in the joint space; the bounds are those of Bajaj &
/// Schikore 1996, §3.1.
MESHBOUND_API Status verify(const Mesh& original, const Mesh& reduced, const std::vector<double>& bounds,
                            const VerifyOptions& options, Verdict& verdict, const Progress& progress = {});

} // namespace meshbound
