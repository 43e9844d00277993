#include "mesh/used_vertices.hpp"

#include "mesh/repeats_vertex.hpp"

namespace meshbound {

std::vector<char> find_used_vertices(const Mesh& mesh) {
    std::vector<char> used(vertex_count(mesh), 0);
    for (const glm::uvec3& triangle : mesh.triangles) {
        if (repeats_vertex(triangle)) continue;
        for (int corner = 0; corner < 3; ++corner) used[triangle[corner]] = 1;
    }
    return used;
}

} // namespace meshbound
