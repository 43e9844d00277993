#include "verify/check_comparable.hpp"

#include <cmath>
#include <string>

#include "mesh/check_arrays.hpp"
#include "mesh/non_finite.hpp"
#include "util/number_text.hpp"

namespace meshbound::verification {
namespace {

/// The widest that a surface may be, in bounds. Rounding makes distances wrong by some 3e-16 of that (measured up to 1e10): this
/// leaves them within `verify_accuracy`.
constexpr double widest = 2e9;

std::string quoted(std::string_view name) { return "“" + std::string(name) + "”"; }

/// Says which of the two surfaces a fault is of.
Status of(const char* surface, Status status) {
    if (!status.ok()) status.message = std::string("In the ") + surface + " surface: " + status.message;
    return status;
}

Status check_bounds(const Mesh& original, const std::vector<double>& bounds) {
    if (bounds.size() != variable_count(original))
        return {Fault::bad_bound,
                "There are " + std::to_string(bounds.size()) +
                    " bounds; there must be one for position and one for each of " +
                    std::to_string(original.variables.size()) + " variables.",
                "",
                {}};
    for (std::size_t i = 0; i < bounds.size(); ++i)
        if (!(bounds[i] > 0))
            return {Fault::bad_bound,
                    "The bound of " + quoted(variable_of(original, i).name) + " is " + number_text(bounds[i]) +
                        "; it must be above zero.",
                    std::string(variable_of(original, i).name),
                    {}};
    return {};
}

Status check_same_variable(const VariableView& wanted, const Mesh& reduced, std::size_t number) {
    const std::string name(wanted.name);
    if (number >= variable_count(reduced) || variable_of(reduced, number).name != wanted.name)
        return {Fault::unknown_variable,
                "The reduced surface has no variable " + quoted(name) + " as its variable " +
                    std::to_string(number - 1) + " (counted from 0), as the original has.",
                name,
                {}};
    if (const int components = variable_of(reduced, number).components; components != wanted.components)
        return {Fault::bad_components,
                "In the reduced surface " + quoted(name) + " has " + std::to_string(components) +
                    " components, in the original " + std::to_string(wanted.components) + ".",
                name,
                {}};
    return {};
}

/// Whether a variable is a number wherever the surface is, and not too far from that of the vertex `centre` of the original.
Status check_values(const VariableView& variable, const std::vector<char>& used, const VariableView& original,
                    std::size_t centre, double bound) {
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        if (!used[vertex]) continue;
        if (!is_finite_at(variable, vertex)) return non_finite_at(Fault::non_finite_value, variable, vertex);
        for (int c = 0; c < variable.components; ++c) {
            const double aside = std::abs(value_at(variable, vertex, c) - value_at(original, centre, c));
            if (!(aside / bound <= widest))
                return {Fault::bound_too_fine,
                        "The bound of " + quoted(variable.name) + " is " + number_text(bound) +
                            ", too fine to be verified: it is " + number_text(aside) +
                            " away from the first vertex at vertex " + std::to_string(vertex) + ".",
                        std::string(variable.name), vertex};
        }
    }
    return {};
}

Status check_multipliers(const std::vector<double>& multipliers, const std::vector<char>& used) {
    if (multipliers.empty()) return {};
    if (multipliers.size() != used.size())
        return {Fault::bad_option,
                "There are " + std::to_string(multipliers.size()) + " multipliers for " + std::to_string(used.size()) +
                    " vertices of the original; there must be one for each.",
                "",
                {}};
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex)
        if (used[vertex] && !(multipliers[vertex] > 0 && std::isfinite(multipliers[vertex])))
            return {Fault::bad_option,
                    "The multiplier at vertex " + std::to_string(vertex) + " is " + number_text(multipliers[vertex]) +
                        "; it must be a number above zero.",
                    "", vertex};
    return {};
}

std::size_t first_used(const std::vector<char>& used) {
    std::size_t vertex = 0;
    while (!used[vertex]) ++vertex;
    return vertex;
}

} // namespace

Status check_comparable(const Mesh& original, const Mesh& reduced, const std::vector<double>& bounds,
                        const VerifyOptions& options) {
    std::vector<char> used, used_of_reduced;
    if (Status status = check_arrays(original, used); !status.ok()) return of("original", status);
    if (Status status = check_arrays(reduced, used_of_reduced); !status.ok()) return of("reduced", status);
    if (Status status = check_bounds(original, bounds); !status.ok()) return status;
    const std::size_t centre = first_used(used);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (std::isinf(bounds[i])) continue;
        const VariableView wanted = variable_of(original, i);
        if (Status status = check_same_variable(wanted, reduced, i); !status.ok()) return status;
        if (Status status = check_values(wanted, used, wanted, centre, bounds[i]); !status.ok())
            return of("original", status);
        if (Status status = check_values(variable_of(reduced, i), used_of_reduced, wanted, centre, bounds[i]);
            !status.ok())
            return of("reduced", status);
    }
    return check_multipliers(options.multipliers, used);
}

} // namespace meshbound::verification
