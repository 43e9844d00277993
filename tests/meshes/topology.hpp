#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

#include "meshbound/mesh.hpp"

namespace meshes {

/// What a reduction must not change. Triangles with a vertex twice and unused vertices do not count.
struct Topology {
    long euler = 0;                     ///< vertices - edges + triangles
    std::size_t components = 0;         ///< parts that share no vertex
    std::size_t boundary_loops = 0;     ///< connected parts of the boundary
    std::size_t non_manifold_edges = 0; ///< edges of three or more triangles
    std::size_t discordant_edges = 0;   ///< edges that two triangles run along in the same direction
    bool operator==(const Topology&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Topology& topology);

Topology topology(const meshbound::Mesh& mesh);

/// The boundary vertices of a manifold in loops, each in the direction of its triangles' edges; the smallest vertex first,
/// loops in the order of that vertex.
std::vector<std::vector<std::uint32_t>> boundary_loops(const meshbound::Mesh& mesh);

/// The volume that a closed surface encloses; negative where its triangles are seen clockwise from outside.
double enclosed_volume(const meshbound::Mesh& mesh);

/// The sum of the normals of all triangles, each as long as its area.
glm::dvec3 area_vector(const meshbound::Mesh& mesh);

} // namespace meshes
