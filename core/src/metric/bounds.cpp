#include "meshbound/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/non_finite.hpp"
#include "mesh/used_vertices.hpp"
#include "metric/measured_bounds.hpp"
#include "metric/rounding_margin.hpp"
#include "util/number_text.hpp"

namespace meshbound {
namespace {

/// The span of a component over the used vertices at which it is a number.
struct Span {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;

    void include(double value) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    bool is_empty() const { return lowest > highest; }
};

Span span_of(const VariableView& variable, int component, const std::vector<char>& used) {
    Span span;
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        if (!used[vertex]) continue;
        if (const double value = value_at(variable, vertex, component); std::isfinite(value)) span.include(value);
    }
    return span;
}

/// Extent (diagonal of the box) and magnitude of a variable.
void measure_values(const VariableView& variable, const std::vector<char>& used, ResolvedBound& bound) {
    double widest = 0, square = 0; // squares relative to the widest component, so that they cannot overflow
    for (int component = 0; component < variable.components; ++component) {
        const Span span = span_of(variable, component, used);
        if (span.is_empty()) continue;
        const double width = span.highest - span.lowest;
        const double rescale = width > widest ? widest / width : 1;
        widest = std::max(widest, width);
        if (widest > 0) square = square * rescale * rescale + (width / widest) * (width / widest);
        bound.magnitude = std::max({bound.magnitude, std::abs(span.lowest), std::abs(span.highest)});
    }
    bound.extent = widest * std::sqrt(square);
}

void count_non_finite(const VariableView& variable, const std::vector<char>& used, ResolvedBound& bound) {
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        if (!used[vertex] || is_finite_at(variable, vertex)) continue;
        if (bound.non_finite++ == 0) bound.first_non_finite = vertex;
    }
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

/// The entry that holds for a variable: the last one with its name, else the last "*" unless it is an identifier, else none
/// (free).
Bound bound_for(const VariableView& variable, const Bounds& bounds) {
    Bound found = unbounded();
    bool named = variable.kind == VariableKind::identifier;
    for (const NamedBound& entry : bounds) {
        const bool by_name = entry.name == variable.name;
        if (!by_name && (named || entry.name != "*")) continue;
        found = entry.bound;
        named = named || by_name;
    }
    return found;
}

Status check_names(const Mesh& mesh, const Bounds& bounds) {
    for (const NamedBound& entry : bounds) {
        const bool known = entry.name == "*" || entry.name == position_name ||
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

Status too_far_apart(const VariableView& variable, Fault fault) {
    const std::string name(variable.name);
    return {fault, "The values of “" + name + "” lie farther apart than double precision can carry.", name, {}};
}

/// The extent of the geometry must be finite even where it is free; that of another variable need not.
Status check_geometry(const Mesh& mesh, const ResolvedBound& position) {
    if (std::isfinite(position.extent)) return {};
    return too_far_apart(mesh.position, Fault::non_finite_position);
}

ResolvedBound measure(const VariableView& variable, bool may_be_constant, const std::vector<char>& used) {
    ResolvedBound resolved;
    measure_values(variable, used, resolved);
    count_non_finite(variable, used, resolved);
    resolved.constant = may_be_constant && resolved.extent <= constant_extent * resolved.magnitude;
    return resolved;
}

Status check_fineness(const VariableView& variable, const ResolvedBound& resolved) {
    if (can_be_carried(resolved)) return {};
    const std::string name(variable.name);
    return {Fault::bound_too_fine,
            "The bound of “" + name + "” is " + number_text(resolved.absolute) +
                ", finer than double precision can carry beside an extent of " + number_text(resolved.extent) + ".",
            name,
            {}};
}

/// The variable is measured.
void resolve(const Bound& given, ResolvedBound& resolved) {
    resolved.given = given;
    switch (given.kind) {
    case Bound::Kind::free: resolved.absolute = std::numeric_limits<double>::infinity(); break;
    case Bound::Kind::absolute: resolved.absolute = given.value; break;
    case Bound::Kind::relative: resolved.absolute = given.value * scale_of(resolved); break;
    }
}

Status resolve_all(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved) {
    if (Status status = check_names(mesh, bounds); !status.ok()) return status;
    for (std::size_t i = 0; i < resolved.size(); ++i) resolve(bound_for(variable_of(mesh, i), bounds), resolved[i]);
    return {};
}

/// Calls `check(variable, resolved)` for each variable with a bound; returns the first fault.
template <class Check>
Status check_bounded(const Mesh& mesh, const std::vector<ResolvedBound>& resolved, const Check& check) {
    for (std::size_t i = 0; i < resolved.size(); ++i) {
        if (resolved[i].given.kind == Bound::Kind::free) continue;
        if (Status status = check(variable_of(mesh, i), resolved[i]); !status.ok()) return status;
    }
    return {};
}

/// Whether what is measured of a variable lets it have a bound. It may be measured elsewhere: nothing is looked up.
Status check_measured(const VariableView& variable, const ResolvedBound& resolved) {
    if (resolved.non_finite > 0) {
        const std::string name(variable.name);
        return {Fault::non_finite_value,
                "The variable “" + name + "” is not a number, or infinite, at vertex " +
                    std::to_string(resolved.first_non_finite) + " of the original; so it can have no bound.",
                name, resolved.first_non_finite};
    }
    if (!std::isfinite(resolved.extent)) return too_far_apart(variable, Fault::non_finite_value);
    return {};
}

} // namespace

bool can_be_carried(const ResolvedBound& bound) {
    return rounding_margin(bound) < largest_rounding_margin && std::isnormal(bound.absolute);
}

Status resolve_bounds(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved) {
    const std::vector<char> used = find_used_vertices(mesh);
    resolved.clear();
    for (std::size_t i = 0; i < variable_count(mesh); ++i)
        resolved.push_back(measure(variable_of(mesh, i), i > 0, used));
    if (Status status = check_geometry(mesh, resolved[0]); !status.ok()) return status;
    if (Status status = resolve_all(mesh, bounds, resolved); !status.ok()) return status;
    const auto check = [](const VariableView& variable, const ResolvedBound& bound) {
        if (bound.non_finite > 0) return non_finite_at(Fault::non_finite_value, variable, bound.first_non_finite);
        const Status status = check_measured(variable, bound);
        return status.ok() ? check_fineness(variable, bound) : status;
    };
    return check_bounded(mesh, resolved, check);
}

Status resolve_measured_bounds(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved) {
    if (Status status = resolve_all(mesh, bounds, resolved); !status.ok()) return status;
    const std::vector<char> used = find_used_vertices(mesh);
    const auto check = [&used](const VariableView& variable, const ResolvedBound& bound) {
        if (Status status = check_measured(variable, bound); !status.ok()) return status;
        for (std::size_t vertex = 0; vertex < used.size(); ++vertex)
            if (used[vertex] && !is_finite_at(variable, vertex))
                return non_finite_at(Fault::non_finite_value, variable, vertex);
        return check_fineness(variable, bound);
    };
    return check_bounded(mesh, resolved, check);
}

} // namespace meshbound
