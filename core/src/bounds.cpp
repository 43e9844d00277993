#include "meshbound/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measured_bounds.hpp"
#include "number_text.hpp"
#include "rows.hpp"

namespace meshbound {
namespace {

/// Extent (diagonal of the box) and magnitude of a variable; the values of a valid mesh are finite.
void measure_values(const Variable& variable, ResolvedBound& bound) {
    const auto components = static_cast<std::size_t>(variable.components);
    const std::size_t vertices = value_count(variable) / components;
    double widest = 0, square = 0; // squares relative to the widest component, so that they cannot overflow
    for (int component = 0; component < variable.components; ++component) {
        double lowest = value_at(variable, 0, component), highest = lowest;
        for (std::size_t vertex = 1; vertex < vertices; ++vertex) {
            const double value = value_at(variable, vertex, component);
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
        const double width = highest - lowest;
        const double rescale = width > widest ? widest / width : 1;
        widest = std::max(widest, width);
        if (widest > 0) square = square * rescale * rescale + (width / widest) * (width / widest);
        bound.magnitude = std::max({bound.magnitude, std::abs(lowest), std::abs(highest)});
    }
    bound.extent = widest * std::sqrt(square);
}

/// What a relative bound of this variable is a fraction of. A variable that is zero everywhere keeps its errors at zero
/// whatever the bound, so any scale serves.
double scale_of(const ResolvedBound& bound) {
    if (!bound.constant) return bound.extent > 0 ? bound.extent : 1;
    return bound.magnitude > 0 ? bound.magnitude : 1;
}

Status check_bound(const std::string& name, const Bound& bound) {
    if (bound.kind == Bound::Kind::free) return {};
    if (std::isfinite(bound.value) && bound.value > 0) return {};
    return {Fault::bad_bound,
            "The bound of “" + name + "” is " + number_text(bound.value) + "; it must be a number above zero.",
            name,
            {}};
}

/// The entry that holds for a variable: the last one with its name, else the last "*", else none (free).
Bound bound_for(const std::string& name, const Bounds& bounds) {
    Bound found = free_of_bound();
    bool named = false;
    for (const NamedBound& entry : bounds) {
        const bool by_name = entry.name == name;
        if (!by_name && (named || entry.name != "*")) continue;
        found = entry.bound;
        named = named || by_name;
    }
    return found;
}

Status check_names(const Mesh& mesh, const Bounds& bounds) {
    for (const NamedBound& entry : bounds) {
        const bool known = entry.name == "*" || entry.name == "position" ||
                           std::any_of(mesh.variables.begin(), mesh.variables.end(),
                                       [&](const Variable& variable) { return variable.name == entry.name; });
        if (!known)
            return {Fault::unknown_variable,
                    "There is a bound for “" + entry.name + "”, but no such variable.",
                    entry.name,
                    {}};
        if (Status status = check_bound(entry.name, entry.bound); !status.ok()) return status;
    }
    return {};
}

/// Even where the variable is free: its errors could not be told.
Status too_far_apart(const Variable& variable, bool is_data) {
    return {is_data ? Fault::non_finite_value : Fault::non_finite_position,
            "The values of “" + variable.name + "” lie farther apart than double precision can carry.",
            variable.name,
            {}};
}

Status measure(const Variable& variable, bool may_be_constant, ResolvedBound& resolved) {
    measure_values(variable, resolved);
    if (!std::isfinite(resolved.extent)) return too_far_apart(variable, may_be_constant);
    resolved.constant = may_be_constant && resolved.extent <= constant_extent * resolved.magnitude;
    return {};
}

/// The variable is measured.
Status resolve(const std::string& name, const Bound& given, ResolvedBound& resolved) {
    resolved.given = given;
    switch (given.kind) {
    case Bound::Kind::free: resolved.absolute = std::numeric_limits<double>::infinity(); return {};
    case Bound::Kind::absolute: resolved.absolute = given.value; break;
    case Bound::Kind::relative: resolved.absolute = given.value * scale_of(resolved); break;
    }
    if (can_be_carried(resolved)) return {};
    return {Fault::bound_too_fine,
            "The bound of “" + name + "” is " + number_text(resolved.absolute) +
                ", finer than double precision can carry beside an extent of " + number_text(resolved.extent) + ".",
            name,
            {}};
}

} // namespace

bool can_be_carried(const ResolvedBound& bound) {
    return rounding_margin(bound) < largest_rounding_margin && std::isnormal(bound.absolute);
}

Status resolve_bounds(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved) {
    if (Status status = check_names(mesh, bounds); !status.ok()) return status;
    resolved.assign(1 + mesh.variables.size(), {});
    for (std::size_t i = 0; i < resolved.size(); ++i) {
        const Variable& variable = i == 0 ? mesh.position : mesh.variables[i - 1];
        Status status = measure(variable, i > 0, resolved[i]);
        if (status.ok()) status = resolve(variable.name, bound_for(variable.name, bounds), resolved[i]);
        if (!status.ok()) return status;
    }
    return {};
}

Status resolve_measured_bounds(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved) {
    if (Status status = check_names(mesh, bounds); !status.ok()) return status;
    for (std::size_t i = 0; i < resolved.size(); ++i) {
        const std::string& name = i == 0 ? mesh.position.name : mesh.variables[i - 1].name;
        if (Status status = resolve(name, bound_for(name, bounds), resolved[i]); !status.ok()) return status;
    }
    return {};
}

} // namespace meshbound
