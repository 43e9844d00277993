#include "self_intersection/self_intersections.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace judge {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Vertices and faces keep their indices.
SurfaceMesh surface_mesh(const meshbound::Mesh& mesh) {
    SurfaceMesh surface;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
        const auto coordinate = [&](int axis) { return value_at(mesh.position, v, axis); };
        surface.add_vertex(Kernel::Point_3(coordinate(0), coordinate(1), coordinate(2)));
    }
    for (const glm::uvec3& t : mesh.triangles) {
        const auto face = surface.add_face(SurfaceMesh::Vertex_index(t.x), SurfaceMesh::Vertex_index(t.y),
                                           SurfaceMesh::Vertex_index(t.z));
        if (face == SurfaceMesh::null_face()) throw std::invalid_argument("not an oriented manifold");
    }
    return surface;
}

} // namespace

TrianglePairs self_intersections(const meshbound::Mesh& mesh) {
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(surface_mesh(mesh), std::back_inserter(found));
    TrianglePairs pairs;
    for (const auto& [one, other] : found) pairs.insert(std::minmax(std::size_t{one}, std::size_t{other}));
    return pairs;
}

} // namespace judge
