#pragma once

#include <functional>

#include <glm/vec3.hpp>

#include "meshbound/mesh.hpp"

namespace meshes {

/// The surface between the filled and the empty cells of a box of unit cells, each side of a cell cut into two triangles.
/// Closed, oriented outward; a manifold where no two filled cells touch in an edge or a corner alone.
meshbound::Mesh voxel_surface(glm::ivec3 cells, const std::function<bool(glm::ivec3)>& filled);

/// A plate with `holes` square holes through it: a closed surface of genus `holes` with sharp edges. A bar of the plate is
/// `cells` cells wide.
meshbound::Mesh pierced_plate(int holes, int cells);

/// The same surface with each vertex moved to the mean of its neighbours, `rounds` times: the sharp edges go.
meshbound::Mesh smoothed(const meshbound::Mesh& mesh, int rounds);

} // namespace meshes
