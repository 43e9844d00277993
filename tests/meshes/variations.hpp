#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/mesh.hpp"

/// The same surface, otherwise: other precision, other place, other triangles, other order. Variables come along.
namespace meshes {

using meshbound::Mesh;

/// All values rounded to single precision.
Mesh in_single(const Mesh& mesh);
/// The positions under a map, in the same precision.
Mesh mapped(const Mesh& mesh, const std::function<glm::dvec3(glm::dvec3)>& map);
/// Every component of a variable under a map, in the same precision. "position" is a variable, too.
void map_values(meshbound::Values& numbers, const std::function<double(double)>& map);
/// All triangles the other way round.
Mesh reversed(const Mesh& mesh);
/// Vertices, triangles and the corners of each triangle in random order.
Mesh shuffled(const Mesh& mesh, std::uint64_t seed);
/// The triangulation made irregular: `flips` random edges replaced by the other diagonal of their two triangles, where
/// that neither folds the surface nor joins vertices already joined.
Mesh flipped(const Mesh& mesh, std::size_t flips, std::uint64_t seed);
/// Vertices moved at random by up to `size` along each axis; those of the boundary stay.
Mesh jittered(const Mesh& mesh, double size, std::uint64_t seed);
/// Both as one mesh of two components. They must have the same variables in the same precision.
Mesh joined(const Mesh& one, const Mesh& other);
/// Only the triangles for which `keep` holds of their centroid; unused vertices stay.
Mesh cut(const Mesh& mesh, const std::function<bool(glm::dvec3)>& keep);

} // namespace meshes
