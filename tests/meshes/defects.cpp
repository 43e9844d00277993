#include "meshes/defects.hpp"

#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"

namespace meshes {
namespace {

/// Makes vertices in exactly the same place one, whatever their other values.
Mesh welded(const Mesh& mesh) {
    std::vector<std::uint32_t> first(vertex_count(mesh));
    for (std::uint32_t v = 0; v < first.size(); ++v) {
        first[v] = 0;
        while (point(mesh, first[v]) != point(mesh, v)) ++first[v];
    }
    Mesh result = mesh;
    for (glm::uvec3& t : result.triangles) t = {first[t.x], first[t.y], first[t.z]};
    return result;
}

/// Of a variable, the geometry or another one.
template <class Kind>
void add_between(Kind& variable, const glm::uvec3& t, const std::array<double, 3>& barycentric) {
    auto& values = std::get<std::vector<double>>(variable.values);
    for (int c = 0; c < meshbound::VariableView(variable).components; ++c) {
        double value = 0;
        for (int i = 0; i < 3; ++i) value += barycentric[i] * value_at(variable, t[i], c);
        values.push_back(value);
    }
}

} // namespace

Mesh three_sheets(int cells) {
    const auto sheet = [cells](glm::dvec3 out) {
        return grid(cells, cells, [out](double u, double v) { return v * out + glm::dvec3(u, 0, 0); });
    };
    return welded(joined(joined(sheet({0, 1, 0}), sheet({0, -0.5, 0.75})), sheet({0, -0.5, -0.75})));
}

Mesh bow_tie(int cells) {
    const Mesh square = plane(cells, cells);
    return welded(joined(square, mapped(square, [](glm::dvec3 p) { return p + glm::dvec3(1, 1, 0); })));
}

Mesh cubes_on_one_edge(int cells) {
    return voxel_surface(glm::ivec3(2 * cells, 2 * cells, cells),
                         [cells](glm::ivec3 p) { return (p.x < cells) == (p.y < cells); });
}

Mesh one_triangle_reversed(int cells) {
    Mesh mesh = plane(cells, cells);
    std::swap(mesh.triangles[mesh.triangles.size() / 2].y, mesh.triangles[mesh.triangles.size() / 2].z);
    return mesh;
}

Mesh with_vertex_in_triangle(const Mesh& mesh, std::size_t triangle, std::array<double, 3> barycentric) {
    Mesh result = mesh;
    const glm::uvec3 t = mesh.triangles[triangle];
    const auto added = static_cast<std::uint32_t>(vertex_count(mesh));
    add_between(result.position, t, barycentric);
    for (meshbound::Variable& variable : result.variables) add_between(variable, t, barycentric);
    result.triangles[triangle] = {t.x, t.y, added};
    result.triangles.push_back({t.y, t.z, added});
    result.triangles.push_back({t.z, t.x, added});
    return result;
}

Mesh with_degenerate_triangles(const Mesh& mesh) {
    const std::vector<std::array<double, 3>> places = {{0.5, 0.5, 0},          {1, 0, 0},       {0.5, 0.5 - 1e-9, 1e-9},
                                                       {1 - 2e-9, 1e-9, 1e-9}, {0.25, 0, 0.75}, {0, 0, 1}};
    Mesh result = mesh;
    const std::size_t triangles = mesh.triangles.size();
    for (std::size_t t = 0; t < triangles; t += 5)
        result = with_vertex_in_triangle(result, t, places[t / 5 % places.size()]);
    return result;
}

std::vector<Mesh> odd_surfaces() {
    std::vector<Mesh> odd = {three_sheets(8),
                             cubes_on_one_edge(4),
                             bow_tie(8),
                             one_triangle_reversed(8),
                             with_degenerate_triangles(sphere(8)),
                             with_degenerate_triangles(plane(12, 12)),
                             cut(sphere(8), [](glm::dvec3 p) { return p.z < 0.3; })};
    for (Mesh& mesh : odd) add_usual_fields(mesh);
    return odd;
}

Mesh moebius_band(int around, int across) {
    Mesh band = grid(around, across, [](double u, double v) {
        const double angle = 2 * 3.141592653589793 * u, half = 0.4 * (2 * v - 1);
        const double radius = 1 + half * std::cos(angle / 2);
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), half * std::sin(angle / 2));
    });
    const auto last = static_cast<std::uint32_t>(around), rows = static_cast<std::uint32_t>(across);
    for (glm::uvec3& t : band.triangles)
        for (int i = 0; i < 3; ++i)
            if (t[i] % (last + 1) == last) t[i] = (rows - t[i] / (last + 1)) * (last + 1);
    return band;
}

} // namespace meshes
