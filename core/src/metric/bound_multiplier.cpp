#include "metric/bound_multiplier.hpp"

#include <algorithm>
#include <string>

#include "mesh/non_finite.hpp"
#include "mesh/used_vertices.hpp"
#include "metric/multipliers.hpp"
#include "metric/rounding_margin.hpp"

namespace meshbound {

const Variable* find_bound_multiplier(const Mesh& mesh, const Options& options) {
    if (options.bound_multiplier.empty()) return nullptr;
    const auto found = std::find_if(mesh.variables.begin(), mesh.variables.end(), [&](const Variable& variable) {
        return variable.name == options.bound_multiplier;
    });
    return found == mesh.variables.end() ? nullptr : &*found;
}

namespace {

/// On the surface, that is where triangles are.
Status check_multipliers(const Mesh& mesh, const Variable& bound_multiplier) {
    const std::vector<char> used = find_used_vertices(mesh);
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        if (!used[vertex]) continue;
        if (!is_finite_at(bound_multiplier, vertex))
            return non_finite_at(Fault::non_finite_value, bound_multiplier, vertex);
        if (!(value_at(bound_multiplier, vertex, 0) > 0))
            return {Fault::bad_option,
                    "The variable “" + bound_multiplier.name +
                        "”, which multiplies the bounds, is not above zero at vertex " + std::to_string(vertex) + ".",
                    bound_multiplier.name, vertex};
    }
    return {};
}

} // namespace

Status check_focus(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Options& options) {
    const std::string& name = options.bound_multiplier;
    if (name.empty()) return {};
    const Variable* bound_multiplier = find_bound_multiplier(mesh, options);
    if (!bound_multiplier)
        return {Fault::unknown_variable,
                "The bounds are to be multiplied by “" + name + "”, but there is no such variable.",
                name,
                {}};
    if (bound_multiplier->components != 1)
        return {Fault::bad_option,
                "The bounds are to be multiplied by “" + name + "”, which has " +
                    std::to_string(bound_multiplier->components) + " components; it must have one.",
                name,
                {}};
    if (Status status = check_multipliers(mesh, *bound_multiplier); !status.ok()) return status;
    const double least = Multipliers(mesh, bound_multiplier).least();
    for (const ResolvedBound& bound : bounds)
        if (!(rounding_margin(bound) < largest_rounding_margin * least))
            return {Fault::bound_too_fine,
                    "The variable “" + name + "” makes a bound finer than double precision can carry.",
                    name,
                    {}};
    return {};
}

} // namespace meshbound
