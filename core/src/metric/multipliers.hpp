#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"

namespace meshbound {

/// What multiplies the bounds at each point of the original (see Options::bound_multiplier): given at its vertices, linear on its
/// triangles, 1 everywhere where nothing is given.
///
/// Why it is enough to look at the corners of the map: on a piece of the original that Φ maps linearly, the error's length is
/// convex and the multiplier linear, so error - multiplier * bound is convex and largest at a corner of the piece. At a
/// corner on an original edge the multiplier is that between the edge's ends.
class Multipliers {
public:
    Multipliers() = default;
    /// `bound_multiplier`: a variable of the mesh, or null. `inputs`: by vertex that of the input (see Surface::inputs); empty: all are
    /// themselves. 1 where no triangle is.
    Multipliers(const Mesh& mesh, const Variable* bound_multiplier, const std::vector<std::uint32_t>& inputs = {});

    bool vary() const { return !at_vertex_.empty(); }
    double least() const { return least_; }
    double most() const { return most_; }

    double at(std::uint32_t vertex) const { return vary() ? at_vertex_[vertex] : 1; }
    /// At share s of the original edge; rounding takes it below neither end.
    double between(std::uint32_t lower, std::uint32_t upper, double s) const {
        if (!vary()) return 1;
        const double p = at_vertex_[lower], q = at_vertex_[upper];
        return std::max(p + s * (q - p), std::min(p, q));
    }

    /// Squared ratios to the bounds, multiplied as they are there.
    double scale_at(std::uint32_t vertex, double squared_ratio) const {
        return vary() ? scale(squared_ratio, at(vertex)) : squared_ratio;
    }
    double scale_between(std::uint32_t lower, std::uint32_t upper, double s, double squared_ratio) const {
        return vary() ? scale(squared_ratio, between(lower, upper, s)) : squared_ratio;
    }

private:
    static double scale(double squared_ratio, double multiplier) { return squared_ratio / (multiplier * multiplier); }

    std::vector<double> at_vertex_;
    double least_ = 1, most_ = 1;
};

} // namespace meshbound
