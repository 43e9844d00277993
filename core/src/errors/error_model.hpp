#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "retriangulation/retriangulation.hpp"
#include "surface/hole.hpp"

namespace meshbound {

/// The worst error that a removal would leave: its squared ratio to the bound and the variable that has it (0:
/// position).
struct RemovalError {
    double squared_ratio = 0;
    std::uint32_t variable = 0;
};

/// The error of one variable on one triangle, in bounds (free variables: in units of their scale).
struct ErrorRange {
    double largest = 0;             ///< no point mapped into the triangle has a larger error
    double ratio = 0;               ///< nor a larger one in multiples of its bound where it came from
    double lowest = 0, highest = 0; ///< signed; of position: the distance along the normal
    bool known = true;              ///< else something there is NaN or infinite, and the numbers above mean nothing
};

/// Measures the errors of one removal after another. For each candidate it is called in this order: enter, cost,
/// measure, and, when the removal is accepted, commit.
class RemovalErrorModel {
public:
    virtual ~RemovalErrorModel() = default;

    /// Prepares for the hole of a candidate, which is laid out.
    virtual void enter(const Hole& hole) = 0;

    /// For a removal of several stars along a curve: puts each vertex of the curve at the same share of the closing
    /// edges of all of them. `models`: those of all stars, which have entered their holes; this is the first of them.
    /// Called once, on the first.
    virtual void share_closing_edges(const std::vector<RemovalErrorModel*>& models, double squared_limit) = 0;

    /// The cost by which a retriangulation of this hole is chosen.
    virtual HoleCost& cost() = 0;

    /// The worst error after this removal. May stop early, with a lower bound of it, once it is above `squared_limit`.
    virtual RemovalError measure(const Retriangulation& retriangulation, double squared_limit) = 0;

    /// Accepts the removal measured last; the surface has been retriangulated, so slots and edges are known.
    virtual void commit(const Retriangulation& retriangulation) = 0;

    /// Whether the normals of new triangles must keep to the hole's. Steep slivers do no harm where the map is tracked;
    /// where errors are propagated, they accumulate.
    virtual bool limits_normal_deviation() const { return true; }

    /// The work that a candidate takes, in units of a small star: how much is tracked in it.
    virtual std::size_t work() const = 0;
};

/// How errors are measured (§3.3): by the paper's propagation, or by the tracked map. It has the state of the whole
/// surface, and outlives the RemovalErrorModels that it makes.
class ErrorModel {
public:
    virtual ~ErrorModel() = default;

    virtual std::unique_ptr<RemovalErrorModel> make_removal_model() = 0;

    /// From now on errors are measured in the bounds of `rows`. The rows so far must still be there. Invalidates what
    /// make_removal_model returned.
    virtual void set_bounds(const Rows& rows) = 0;

    /// The errors on the triangle in `slot`, by row group (position first).
    virtual void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const = 0;
};

} // namespace meshbound
