#include "mesh/scaled_points.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/used_vertices.hpp"

namespace meshbound {

ScaledPoints scaled_points(const Mesh& mesh, int largest_exponent) {
    ScaledPoints scaled{std::vector<glm::dvec3>(vertex_count(mesh))};
    double largest = 0;
    const std::vector<char> used = find_used_vertices(mesh);
    for (std::size_t vertex = 0; vertex < scaled.points.size(); ++vertex)
        for (int axis = 0; axis < 3 && used[vertex]; ++axis) {
            scaled.points[vertex][axis] = value_at(mesh.position, vertex, axis);
            largest = std::max(largest, std::abs(scaled.points[vertex][axis]));
        }
    if (!(largest > 0)) return scaled;
    scaled.exponent = largest_exponent - std::ilogb(largest);
    for (glm::dvec3& point : scaled.points)
        for (int axis = 0; axis < 3; ++axis) point[axis] = std::ldexp(point[axis], scaled.exponent);
    return scaled;
}

} // namespace meshbound
