#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "surface/hole.hpp"
#include "retriangulation/retriangulation.hpp"

namespace meshbound {

/// The worst error that a removal would leave: its squared ratio to the bound and the variable it stands in (0: position).
struct Measured {
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

/// The accounting of one removal after another. The loop that removes vertices asks in this order, for each candidate: enter,
/// cost, measure, and, when the removal is accepted, commit.
class RemovalAccounting {
public:
    virtual ~RemovalAccounting() = default;

    /// Looks at the laid-out hole of a candidate.
    virtual void enter(const Hole& hole) = 0;

    /// Of a removal of several parts along a curve: all of them, this one the first, have entered their holes. What goes to
    /// their closing edges goes to the same share of each. Called once, for the first part.
    virtual void join(const std::vector<RemovalAccounting*>& parts, double squared_limit) = 0;

    /// What a retriangulation of this hole is charged for.
    virtual HoleCost& cost() = 0;

    /// The worst error after this removal. May stop early, with a lower bound of it, once it is above `squared_limit`.
    virtual Measured measure(const Retriangulation& retriangulation, double squared_limit) = 0;

    /// Takes the removal measured last; the surface has been retriangulated, so slots and edges are known.
    virtual void commit(const Retriangulation& retriangulation) = 0;

    /// Whether new triangles must keep to the hole's normal. Steep slivers do no harm to a map that is kept; their errors
    /// add up where it is not.
    virtual bool minds_turns() const { return true; }

    /// What a candidate costs in time, in units of a small star: how much the accounting carries along for it.
    virtual std::size_t work() const = 0;
};

/// How errors are accounted for (§3.3): the one difference between the paper's propagation and the tracked map. What is known
/// of the whole surface; it outlives what looks at one removal after another.
class Accounting {
public:
    virtual ~Accounting() = default;

    virtual std::unique_ptr<RemovalAccounting> removals() = 0;

    /// Goes on with other bounds: from now on errors are measured in those of `rows`. The rows so far are still there. Ends
    /// what `removals` gave.
    virtual void measure_in(const Rows& rows) = 0;

    /// The errors on the triangle in `slot`, by row group (position first).
    virtual void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const = 0;
};

} // namespace meshbound
