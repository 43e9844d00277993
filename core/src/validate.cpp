#include "meshbound/validate.hpp"

#include <cmath>
#include <limits>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "orientation.hpp"
#include "removal.hpp"
#include "repeats_vertex.hpp"

namespace meshbound {
namespace {

/// More components than any field has in practice (a full stress tensor has 9); a larger number is a mistake in the file.
constexpr int most_components = 64;

/// Vertices and half-edges are named by 32-bit indices, the largest of which means "none".
constexpr std::size_t most_triangles = std::numeric_limits<std::uint32_t>::max() / 3 - 1;
constexpr std::size_t most_vertices = std::numeric_limits<std::uint32_t>::max() - 1;

/// What keeps a candidate from being removed is noted by the number of the variable; 0 is position.
constexpr std::size_t most_variables = std::numeric_limits<decltype(Verdict::variable)>::max();

std::string quoted(const std::string& name) { return "“" + name + "”"; }

Status check_sizes(const Mesh& mesh) {
    if (mesh.position.components != 3 || value_count(mesh.position) % 3 != 0)
        return {Fault::bad_coordinates,
                "The position has " + std::to_string(value_count(mesh.position)) +
                    " numbers; it needs three for each vertex.",
                "position",
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

/// The index of the first value that is NaN or infinite, or the number of values.
std::size_t first_non_finite(const Variable& variable) {
    return std::visit(
        [](const auto& values) {
            std::size_t i = 0;
            while (i < values.size() && std::isfinite(values[i])) ++i;
            return i;
        },
        variable.values);
}

Status check_finite(const Variable& variable, Fault fault) {
    const std::size_t bad = first_non_finite(variable);
    if (bad == value_count(variable)) return {};
    const std::size_t vertex = bad / static_cast<std::size_t>(variable.components);
    const int component = static_cast<int>(bad % static_cast<std::size_t>(variable.components));
    const char* what = std::isnan(value_at(variable, vertex, component)) ? "not a number" : "infinite";
    return {fault,
            "The variable " + quoted(variable.name) + " is " + what + " at vertex " + std::to_string(vertex) + ".",
            variable.name, vertex};
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
    return check_finite(variable, Fault::non_finite_value);
}

Status check_names(const Mesh& mesh) {
    std::unordered_set<std::string> names = {"position", "*"};
    for (std::size_t i = 0; i < mesh.variables.size(); ++i)
        if (!names.insert(mesh.variables[i].name).second)
            return {Fault::duplicate_name,
                    "Variable " + std::to_string(i) + " (counted from 0) is named " + quoted(mesh.variables[i].name) +
                        ", which is taken.",
                    mesh.variables[i].name, i};
    return {};
}

bool has_zero_area(const Mesh& mesh, const glm::uvec3& triangle) {
    glm::dvec3 p[3];
    for (int corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis) p[corner][axis] = value_at(mesh.position, triangle[corner], axis);
    return glm::cross(p[1] - p[0], p[2] - p[0]) == glm::dvec3(0);
}

Oddities find_oddities(const Mesh& mesh) {
    Oddities odd;
    std::vector<bool> used(vertex_count(mesh), false);
    for (const glm::uvec3& triangle : mesh.triangles) {
        if (repeats_vertex(triangle)) {
            ++odd.repeated_vertex_triangles;
            continue;
        }
        if (has_zero_area(mesh, triangle)) ++odd.zero_area_triangles;
        for (int corner = 0; corner < 3; ++corner) used[triangle[corner]] = true;
    }
    for (const bool is_used : used)
        if (!is_used) ++odd.unused_vertices;
    return odd;
}

} // namespace

Status validate(const Mesh& mesh, Oddities* oddities) {
    Status status = check_sizes(mesh);
    if (status.ok()) status = check_triangles(mesh);
    if (status.ok()) status = check_finite(mesh.position, Fault::non_finite_position);
    for (std::size_t i = 0; status.ok() && i < mesh.variables.size(); ++i)
        status = check_variable(mesh.variables[i], i, vertex_count(mesh));
    if (status.ok()) status = check_names(mesh);
    if (status.ok() && oddities) *oddities = find_oddities(mesh);
    return status;
}

void find_turned(const Mesh& mesh, Oddities& oddities) {
    note_turned(orient(mesh.triangles, vertex_count(mesh)), oddities);
}

} // namespace meshbound
