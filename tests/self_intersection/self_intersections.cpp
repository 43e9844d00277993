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

/// Apart from what both have in common: nothing, a corner, an edge, or all.
bool meet(const Kernel::Triangle_3& one, const Kernel::Triangle_3& other) {
    std::vector<int> common, alone, alone_there;
    for (int i = 0; i < 3; ++i) {
        bool shared = false;
        for (int j = 0; j < 3; ++j) shared = shared || one[i] == other[j];
        (shared ? common : alone).push_back(i);
    }
    for (int j = 0; j < 3; ++j)
        if (other[j] != one[0] && other[j] != one[1] && other[j] != one[2]) alone_there.push_back(j);
    if (common.empty()) return CGAL::do_intersect(one, other);
    if (common.size() == 1)
        return CGAL::do_intersect(one, Kernel::Segment_3(other[alone_there[0]], other[alone_there[1]])) ||
               CGAL::do_intersect(other, Kernel::Segment_3(one[alone[0]], one[alone[1]]));
    if (common.size() == 3) return true;
    const Kernel::Point_3 &p = one[common[0]], &q = one[common[1]], &r = one[alone[0]], &s = other[alone_there[0]];
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
}

std::vector<Kernel::Triangle_3> placed_triangles(const meshbound::Mesh& mesh) {
    const auto point = [&mesh](std::uint32_t v) {
        const auto coordinate = [&](int axis) { return value_at(mesh.position, v, axis); };
        return Kernel::Point_3(coordinate(0), coordinate(1), coordinate(2));
    };
    std::vector<Kernel::Triangle_3> triangles;
    for (const glm::uvec3& t : mesh.triangles) triangles.emplace_back(point(t.x), point(t.y), point(t.z));
    return triangles;
}

} // namespace

TrianglePairs soup_intersections(const meshbound::Mesh& mesh,
                                 const std::function<bool(std::size_t, std::size_t)>& asked) {
    const std::vector<Kernel::Triangle_3> triangles = placed_triangles(mesh);
    std::vector<bool> has_area;
    for (const Kernel::Triangle_3& triangle : triangles) has_area.push_back(!triangle.is_degenerate());
    TrianglePairs pairs;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size(); ++j)
            if (has_area[i] && has_area[j] && asked(i, j) &&
                CGAL::do_overlap(triangles[i].bbox(), triangles[j].bbox()) && meet(triangles[i], triangles[j]))
                pairs.insert({i, j});
    return pairs;
}

TrianglePairs self_intersections(const meshbound::Mesh& mesh) {
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections(surface_mesh(mesh), std::back_inserter(found));
    TrianglePairs pairs;
    for (const auto& [one, other] : found) pairs.insert(std::minmax(std::size_t{one}, std::size_t{other}));
    return pairs;
}

} // namespace judge
