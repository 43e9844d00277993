#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "meshbound/api.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// The largest allowed error of one variable.
struct Bound {
    enum class Kind {
        relative, ///< `value` is a fraction of the variable's extent: 0.01 is one percent
        absolute, ///< `value` is in the variable's own unit
        free,     ///< no bound: the variable is carried along and its error reported, but it holds nothing back
    };
    Kind kind = Kind::relative;
    double value = 0.01;
};

inline Bound relative(double fraction) { return {Bound::Kind::relative, fraction}; }
inline Bound absolute(double value) { return {Bound::Kind::absolute, value}; }
inline Bound unbounded() { return {Bound::Kind::free, 0}; }

/// A bound for the variable `name`. "position" is the geometry; "*" stands for every variable that no other entry names,
/// position among them, but for identifiers (Variable::kind), which only their own names reach. Of two entries with one name
/// the later one holds. A variable that no entry reaches is free.
///
///     Bounds bounds = {{"position", relative(0.01)}, {"velocity", absolute(0.2)}, {"*", relative(0.03)}};
struct NamedBound {
    std::string name;
    Bound bound;
};
using Bounds = std::vector<NamedBound>;

/// The bound of one variable in its own unit, with what it was taken from: the vertices that triangles use, and of these what
/// is a number.
struct ResolvedBound {
    Bound given;
    double extent = 0;    ///< length of the diagonal of the box of the values: max - min for a scalar, in its unit
    double magnitude = 0; ///< largest absolute value of a component, in the variable's unit
    /// At how many of these vertices a component is NaN or infinite, and the first of them. Such a variable must be free.
    std::size_t non_finite = 0, first_non_finite = 0;
    bool constant =
        false; ///< extent below `constant_extent` of the magnitude: a relative bound is taken from the magnitude
    double absolute = 0; ///< the bound in the variable's unit; infinity where it is free
};

/// A variable whose extent is below this fraction of its magnitude is constant up to rounding (an isosurface of density
/// carries density). Single precision rounds at 6e-8; interpolation loses a digit. Never applied to position, where
/// moving the mesh must change nothing.
inline constexpr double constant_extent = 1e-6;

/// Bounds in the unit of each variable: position first, then the mesh's variables in their order.
/// Faults: unknown_variable, bad_bound, bound_too_fine; non_finite_value, with the vertex, where a variable with a bound is NaN
/// or infinite at a vertex that a triangle uses. The mesh must be valid (see validate).
MESHBOUND_API Status resolve_bounds(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved);

} // namespace meshbound
