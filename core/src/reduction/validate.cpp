#include "meshbound/validate.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/check_arrays.hpp"
#include "mesh/orientation.hpp"
#include "mesh/position_at.hpp"
#include "mesh/repeats_vertex.hpp"
#include "reduction/removal.hpp"
#include "surface/one_sided.hpp"

namespace meshbound {
namespace {

static_assert(most_variables <= std::numeric_limits<decltype(RemovalOutcome::variable)>::max(),
              "the outcome of a removal names any variable");

bool has_zero_area(const Mesh& mesh, const glm::uvec3& triangle) {
    glm::dvec3 p[3];
    for (int corner = 0; corner < 3; ++corner) p[corner] = position_at(mesh, triangle[corner]);
    return glm::cross(p[1] - p[0], p[2] - p[0]) == glm::dvec3(0);
}

MeshDefects find_defects(const Mesh& mesh, const std::vector<char>& used) {
    MeshDefects defects;
    for (const glm::uvec3& triangle : mesh.triangles)
        if (repeats_vertex(triangle)) ++defects.repeated_vertex_triangles;
        else if (has_zero_area(mesh, triangle)) ++defects.zero_area_triangles;
    defects.unused_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
    return defects;
}

} // namespace

Status validate(const Mesh& mesh, MeshDefects* defects) {
    std::vector<char> used;
    if (Status status = check_arrays(mesh, used); !status.ok()) return status;
    if (defects) *defects = find_defects(mesh, used);
    return {};
}

void find_flipped_triangles(const Mesh& mesh, MeshDefects& defects) {
    if (!has_coincident_triangles(mesh)) return note_orientation(orient(mesh.triangles, vertex_count(mesh)), defects);
    SideLabels labels;
    OneSided(mesh, OneSided::Orienting::as_reduced, labels).note(defects);
}

} // namespace meshbound
