#include "meshes/voxel_surface.hpp"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "meshes/shapes.hpp"

namespace meshes {

meshbound::Mesh voxel_surface(glm::ivec3 cells, const std::function<bool(glm::ivec3)>& filled) {
    std::map<std::tuple<int, int, int>, std::uint32_t> vertices;
    std::vector<glm::dvec3> points;
    std::vector<glm::uvec3> triangles;
    const auto vertex = [&](glm::ivec3 p) {
        const auto [entry, is_new] = vertices.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(points.size()));
        if (is_new) points.emplace_back(p);
        return entry->second;
    };
    const auto is_filled = [&](glm::ivec3 p) {
        for (int k = 0; k < 3; ++k)
            if (p[k] < 0 || p[k] >= cells[k]) return false;
        return filled(p);
    };
    const auto add_side = [&](glm::ivec3 cell, int axis, int side) {
        glm::ivec3 neighbour = cell, low = cell, across(0), along(0);
        neighbour[axis] += side == 1 ? 1 : -1;
        if (is_filled(neighbour)) return;
        low[axis] += side;
        across[(axis + (side == 1 ? 1 : 2)) % 3] = 1;
        along[(axis + (side == 1 ? 2 : 1)) % 3] = 1;
        const std::uint32_t a = vertex(low), b = vertex(low + across), c = vertex(low + across + along),
                            d = vertex(low + along);
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i)
                for (int face = 0; is_filled({i, j, k}) && face < 6; ++face) add_side({i, j, k}, face / 2, face % 2);
    return from_points(points, std::move(triangles));
}

meshbound::Mesh pierced_plate(int holes, int cells) {
    return voxel_surface({(2 * holes + 1) * cells, 3 * cells, cells},
                         [cells](glm::ivec3 p) { return (p.x / cells) % 2 == 0 || (p.y / cells) % 2 == 0; });
}

meshbound::Mesh smoothed(const meshbound::Mesh& mesh, int rounds) {
    std::vector<glm::dvec3> points;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) points.push_back(point(mesh, v));
    for (int round = 0; round < rounds; ++round) {
        std::vector<glm::dvec3> sums(points.size(), glm::dvec3(0));
        std::vector<double> counts(points.size(), 0);
        for (const glm::uvec3& t : mesh.triangles)
            for (int i = 0; i < 3; ++i) {
                sums[t[i]] += points[t[(i + 1) % 3]];
                ++counts[t[i]];
            }
        for (std::size_t v = 0; v < points.size(); ++v)
            if (counts[v] > 0) points[v] = sums[v] / counts[v];
    }
    return from_points(points, mesh.triangles);
}

} // namespace meshes
