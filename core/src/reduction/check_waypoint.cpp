#include "reduction/check_waypoint.hpp"

#include <cmath>
#include <string>

#include "mesh/kept_vertices.hpp"

namespace meshbound {
namespace {

Status inconsistent(const std::string& message, const std::string& variable = "") {
    return {Fault::bad_waypoint, message, variable, {}};
}

Status check_vertices(const Waypoint& waypoint) {
    const auto& vertices = waypoint.vertices;
    if (vertices.size() != vertex_count(waypoint.mesh))
        return inconsistent("The waypoint has " + std::to_string(vertex_count(waypoint.mesh)) +
                            " vertices and says of " + std::to_string(vertices.size()) + " where they come from.");
    return check_kept_vertices("the waypoint", vertices, waypoint.report.vertices_before, Fault::bad_waypoint);
}

/// NaN fails.
bool is_length(double value) { return value >= 0 && std::isfinite(value); }

/// What is spent of a variable that can have no bound need not be known (see VariableReport::error); NaN is no extent.
bool says_what_it_spent(const VariableReport& report, bool is_position) {
    const ResolvedBound& bound = report.bound;
    if (is_position || (bound.non_finite == 0 && std::isfinite(bound.extent)))
        return is_length(bound.extent) && is_length(report.error);
    return bound.extent >= 0 && (std::isnan(report.error) || report.error >= 0);
}

Status check_variables(const Waypoint& waypoint) {
    const auto& reports = waypoint.report.variables;
    const std::size_t count = variable_count(waypoint.mesh);
    if (reports.size() != count)
        return inconsistent("The waypoint has " + std::to_string(count) +
                            " variables, position among them, and reports on " + std::to_string(reports.size()) + ".");
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name(variable_of(waypoint.mesh, i).name);
        if (reports[i].name != name)
            return inconsistent("The waypoint reports on “" + reports[i].name + "” in place of “" + name + "”.", name);
        if (!is_length(reports[i].bound.magnitude) || !says_what_it_spent(reports[i], i == 0))
            return inconsistent("What the waypoint reports on “" + name + "” is not in numbers from zero on.", name);
    }
    return {};
}

} // namespace

Status check_waypoint(const Waypoint& waypoint) {
    if (Status status = check_vertices(waypoint); !status.ok()) return status;
    return check_variables(waypoint);
}

} // namespace meshbound
