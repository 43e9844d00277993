#include "verify/joint_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/repeats_vertex.hpp"

namespace meshbound::verification {
namespace {

std::array<std::uint32_t, 3> sorted_corners(const glm::uvec3& t) {
    std::array<std::uint32_t, 3> corners = {t.x, t.y, t.z};
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// The triangles of a mesh by their corners, rising; those on the same three vertices once.
std::vector<std::array<std::uint32_t, 3>> distinct_triangles(const Mesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const glm::uvec3& t : mesh.triangles)
        if (!repeats_vertex(t)) triangles.push_back(sorted_corners(t));
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

std::vector<double> joint_rows(const Mesh& mesh, const JointSpace& space) {
    const std::size_t vertices = vertex_count(mesh);
    const std::size_t dimensions = space.origin.size();
    std::vector<double> rows(vertices * dimensions);
    std::size_t column = 0;
    for (std::size_t i = 0; i < space.variables.size(); ++i) {
        const VariableView variable = variable_of(mesh, space.variables[i]);
        for (int c = 0; c < variable.components; ++c, ++column)
            for (std::size_t v = 0; v < vertices; ++v)
                rows[v * dimensions + column] = (value_at(variable, v, c) - space.origin[column]) / space.bounds[i];
    }
    return rows;
}

} // namespace

JointSpace joint_space(const Mesh& mesh, const std::vector<double>& bounds) {
    // A vertex of the surface: any other may hold no numbers.
    const auto first = std::find_if_not(mesh.triangles.begin(), mesh.triangles.end(), repeats_vertex);
    const bool has_surface = first != mesh.triangles.end();
    JointSpace space;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
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
        if (!repeats_vertex(t)) surface.triangles.push_back({t.x, t.y, t.z});
    return surface;
}

JointSurface joint_boundary(const Mesh& mesh, const JointSpace& space) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const auto& [a, b, c] : distinct_triangles(mesh)) edges.insert(edges.end(), {{a, b}, {b, c}, {a, c}});
    std::sort(edges.begin(), edges.end());
    JointSurface curve{space.dimensions(), joint_rows(mesh, space), {}};
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next = std::find_if(edge, edges.end(), [&](const auto& other) { return other != *edge; });
        if (next - edge == 1) curve.triangles.push_back({(*edge)[0], (*edge)[1], (*edge)[1]});
        edge = next;
    }
    return curve;
}

} // namespace meshbound::verification
