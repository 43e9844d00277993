#include "mesh/check_arrays.hpp"

#include <limits>
#include <string>
#include <unordered_set>

#include "mesh/non_finite.hpp"
#include "mesh/used_vertices.hpp"

namespace meshbound {
namespace {

/// More components than any field has in practice (a full stress tensor has 9); a larger number is a mistake in the file.
constexpr int most_components = 64;

/// Vertices and half-edges are named by 32-bit indices, the largest of which means "none".
constexpr std::size_t most_triangles = std::numeric_limits<std::uint32_t>::max() / 3 - 1;
constexpr std::size_t most_vertices = std::numeric_limits<std::uint32_t>::max() - 1;

std::string quoted(const std::string& name) { return "“" + name + "”"; }

Status check_sizes(const Mesh& mesh) {
    if (value_count(mesh.position) % 3 != 0)
        return {Fault::bad_coordinates,
                "The position has " + std::to_string(value_count(mesh.position)) +
                    " numbers; it needs three for each vertex.",
                std::string(position_name),
                {}};
    if (vertex_count(mesh) > most_vertices || mesh.triangles.size() > most_triangles)
        return {Fault::too_large, "The mesh has more vertices or triangles than 32-bit indices can name.", "", {}};
    if (mesh.variables.size() > most_variables)
        return {Fault::too_large,
                "The mesh has " + std::to_string(mesh.variables.size()) + " variables; at most " +
                    std::to_string(most_variables) + " can be carried.",
                "",
                {}};
    return {};
}

Status check_triangles(const Mesh& mesh) {
    const std::size_t vertices = vertex_count(mesh);
    bool any = false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& triangle = mesh.triangles[t];
        for (int corner = 0; corner < 3; ++corner)
            if (triangle[corner] >= vertices)
                return {Fault::bad_index,
                        "Triangle " + std::to_string(t) + " names vertex " + std::to_string(triangle[corner]) +
                            ", but the mesh has " + std::to_string(vertices) + " vertices (counted from 0).",
                        "", t};
        any = any || (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x);
    }
    if (!mesh.regions.empty() && mesh.regions.size() != mesh.triangles.size())
        return {Fault::wrong_value_count,
                "There are " + std::to_string(mesh.regions.size()) + " labels of regions for " +
                    std::to_string(mesh.triangles.size()) + " triangles; there must be one for each.",
                "",
                {}};
    if (!any) return {Fault::no_triangles, "The mesh has no triangle with three distinct vertices.", "", {}};
    return {};
}

/// Positions must be finite at the vertices that triangles use. Other variables need not be: that matters to their
/// bounds (see resolve_bounds).
Status check_positions(const Mesh& mesh, const std::vector<char>& used) {
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex)
        if (used[vertex] && !is_finite_at(mesh.position, vertex))
            return non_finite_at(Fault::non_finite_position, mesh.position, vertex);
    return {};
}

Status check_variable(const Variable& variable, std::size_t index, std::size_t vertices) {
    if (variable.name.empty())
        return {Fault::empty_name, "Variable " + std::to_string(index) + " (counted from 0) has no name.", "", index};
    if (variable.components < 1 || variable.components > most_components)
        return {Fault::bad_components,
                "The variable " + quoted(variable.name) + " has " + std::to_string(variable.components) +
                    " components; 1 to " + std::to_string(most_components) + " can be carried.",
                variable.name, index};
    const std::size_t needed = vertices * static_cast<std::size_t>(variable.components);
    if (value_count(variable) != needed)
        return {Fault::wrong_value_count,
                "The variable " + quoted(variable.name) + " has " + std::to_string(value_count(variable)) +
                    " values; " + std::to_string(vertices) + " vertices with " + std::to_string(variable.components) +
                    " components need " + std::to_string(needed) + ".",
                variable.name, index};
    return {};
}

Status check_names(const Mesh& mesh) {
    std::unordered_set<std::string> names = {std::string(position_name), "*"};
    for (std::size_t i = 0; i < mesh.variables.size(); ++i)
        if (!names.insert(mesh.variables[i].name).second)
            return {Fault::duplicate_name,
                    "Variable " + std::to_string(i) + " (counted from 0) is named " + quoted(mesh.variables[i].name) +
                        ", which is taken.",
                    mesh.variables[i].name, i};
    return {};
}

} // namespace

Status check_arrays(const Mesh& mesh, std::vector<char>& used) {
    if (Status status = check_sizes(mesh); !status.ok()) return status;
    if (Status status = check_triangles(mesh); !status.ok()) return status;
    used = find_used_vertices(mesh);
    if (Status status = check_positions(mesh, used); !status.ok()) return status;
    for (std::size_t i = 0; i < mesh.variables.size(); ++i)
        if (Status status = check_variable(mesh.variables[i], i, vertex_count(mesh)); !status.ok()) return status;
    return check_names(mesh);
}

} // namespace meshbound
