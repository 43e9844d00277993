#include "metric/focus.hpp"

#include <algorithm>
#include <string>

#include "mesh/non_finite.hpp"
#include "mesh/used_vertices.hpp"
#include "metric/multipliers.hpp"
#include "metric/rows.hpp"

namespace meshbound {

const Variable* find_focus(const Mesh& mesh, const Options& options) {
    if (options.focus.empty()) return nullptr;
    const auto found = std::find_if(mesh.variables.begin(), mesh.variables.end(),
                                    [&](const Variable& variable) { return variable.name == options.focus; });
    return found == mesh.variables.end() ? nullptr : &*found;
}

namespace {

/// On the surface, that is where triangles are.
Status check_multipliers(const Mesh& mesh, const Variable& focus) {
    const std::vector<char> used = find_used_vertices(mesh);
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        if (!used[vertex]) continue;
        if (!is_finite_at(focus, vertex)) return non_finite_at(Fault::non_finite_value, focus, vertex);
        if (!(value_at(focus, vertex, 0) > 0))
            return {Fault::bad_option,
                    "The variable “" + focus.name + "”, which multiplies the bounds, is not above zero at vertex " +
                        std::to_string(vertex) + ".",
                    focus.name, vertex};
    }
    return {};
}

} // namespace

Status check_focus(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Options& options) {
    const std::string& name = options.focus;
    if (name.empty()) return {};
    const Variable* focus = find_focus(mesh, options);
    if (!focus)
        return {Fault::unknown_variable,
                "The bounds are to be multiplied by “" + name + "”, but there is no such variable.",
                name,
                {}};
    if (focus->components != 1)
        return {Fault::bad_option,
                "The bounds are to be multiplied by “" + name + "”, which has " + std::to_string(focus->components) +
                    " components; it must have one.",
                name,
                {}};
    if (Status status = check_multipliers(mesh, *focus); !status.ok()) return status;
    const double least = Multipliers(mesh, focus).least();
    for (const ResolvedBound& bound : bounds)
        if (!(rounding_margin(bound) < largest_rounding_margin * least))
            return {Fault::bound_too_fine,
                    "The variable “" + name + "” makes a bound finer than double precision can carry.",
                    name,
                    {}};
    return {};
}

} // namespace meshbound
