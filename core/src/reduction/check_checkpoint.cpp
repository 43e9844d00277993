#include "reduction/check_checkpoint.hpp"

#include <cmath>
#include <string>

#include "mesh/kept_vertices.hpp"

namespace meshbound {
namespace {

Status inconsistent(const std::string& message, const std::string& variable = "") {
    return {Fault::bad_checkpoint, message, variable, {}};
}

Status check_vertices(const Checkpoint& checkpoint) {
    const auto& vertices = checkpoint.vertices;
    if (vertices.size() != vertex_count(checkpoint.mesh))
        return inconsistent("The checkpoint has " + std::to_string(vertex_count(checkpoint.mesh)) +
                            " vertices and says of " + std::to_string(vertices.size()) + " where they come from.");
    return check_kept_vertices("the checkpoint", vertices, checkpoint.report.vertices_before, Fault::bad_checkpoint);
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

Status check_variables(const Checkpoint& checkpoint) {
    const auto& reports = checkpoint.report.variables;
    const std::size_t count = variable_count(checkpoint.mesh);
    if (reports.size() != count)
        return inconsistent("The checkpoint has " + std::to_string(count) +
                            " variables, position among them, and reports on " + std::to_string(reports.size()) + ".");
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name(variable_of(checkpoint.mesh, i).name);
        if (reports[i].name != name)
            return inconsistent("The checkpoint reports on “" + reports[i].name + "” in place of “" + name + "”.",
                                name);
        if (!is_length(reports[i].bound.magnitude) || !says_what_it_spent(reports[i], i == 0))
            return inconsistent("What the checkpoint reports on “" + name + "” is not in numbers from zero on.", name);
    }
    return {};
}

} // namespace

Status check_checkpoint(const Checkpoint& checkpoint) {
    if (Status status = check_vertices(checkpoint); !status.ok()) return status;
    return check_variables(checkpoint);
}

} // namespace meshbound
