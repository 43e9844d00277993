#include "verify/joint_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace meshbound::verification {
namespace {

bool has_vertex_twice(const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; }

std::array<std::uint32_t, 3> sorted_corners(const glm::uvec3& t) {
    std::array<std::uint32_t, 3> corners = {t.x, t.y, t.z};
    std::sort(corners.begin(), corners.end());
    return corners;
}

std::vector<double> joint_rows(const Mesh& mesh, const JointSpace& space) {
    const std::size_t vertices = vertex_count(mesh);
    const std::size_t dimensions = space.origin.size();
    if (!space.variables.empty() && mesh.variables.size() < space.variables.back())
        throw std::invalid_argument("one of the two surfaces lacks a variable");
    std::vector<double> rows(vertices * dimensions);
    std::size_t column = 0;
    for (std::size_t i = 0; i < space.variables.size(); ++i) {
        const VariableView variable = variable_of(mesh, space.variables[i]);
        if (variable.components != space.components[i] || value_count(variable) != vertices * variable.components)
            throw std::invalid_argument("the two surfaces do not carry the same variables: " +
                                        std::string(variable.name));
        for (int c = 0; c < variable.components; ++c, ++column)
            for (std::size_t v = 0; v < vertices; ++v)
                rows[v * dimensions + column] = (value_at(variable, v, c) - space.origin[column]) / space.bounds[i];
    }
    return rows;
}

} // namespace

JointSpace joint_space(const Mesh& mesh, const std::vector<double>& bounds) {
    if (bounds.size() != mesh.variables.size() + 1)
        throw std::invalid_argument("one bound for position, one a variable");
    // A vertex of the surface: any other may hold no numbers.
    const auto first = std::find_if_not(mesh.triangles.begin(), mesh.triangles.end(), has_vertex_twice);
    const bool has_surface = first != mesh.triangles.end();
    JointSpace space;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (!(bounds[i] > 0)) throw std::invalid_argument("a bound must be positive");
        if (std::isinf(bounds[i])) continue;
        const VariableView variable = variable_of(mesh, i);
        space.variables.push_back(i);
        space.components.push_back(variable.components);
        space.bounds.push_back(bounds[i]);
        for (int c = 0; c < variable.components; ++c)
            space.origin.push_back(has_surface ? value_at(variable, first->x, c) : 0);
    }
    return space;
}

JointSurface joint_surface(const Mesh& mesh, const JointSpace& space) {
    JointSurface surface{space.dimensions(), joint_rows(mesh, space), {}};
    for (const glm::uvec3& t : mesh.triangles)
        if (!has_vertex_twice(t)) surface.triangles.push_back({t.x, t.y, t.z});
    return surface;
}

JointSurface joint_boundary(const Mesh& mesh, const JointSpace& space) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    std::set<std::array<std::uint32_t, 3>> met;
    for (const glm::uvec3& t : mesh.triangles) {
        if (has_vertex_twice(t) || !met.insert(sorted_corners(t)).second) continue;
        for (int i = 0; i < 3; ++i) ++uses[std::minmax({t[i], t[(i + 1) % 3]})];
    }
    JointSurface curve{space.dimensions(), joint_rows(mesh, space), {}};
    for (const auto& [edge, count] : uses)
        if (count == 1) curve.triangles.push_back({edge.first, edge.second, edge.second});
    return curve;
}

} // namespace meshbound::verification
