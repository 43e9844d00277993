#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/mesh_defects.hpp"

namespace meshbound {

/// Triangles flipped so that neighbours are oriented consistently, as far as that can be.
struct Orientation {
    std::vector<glm::uvec3> triangles; ///< all of them, in their order; a flipped one has its last two corners swapped
    std::size_t flipped = 0;           ///< how many were flipped
    std::size_t unorientable_components = 0; ///< components without a consistent orientation (a Möbius band)
    std::size_t unorientable_triangle{};     ///< the first triangle of the first of them
};

/// Orients a mesh component by component; components are connected over edges with exactly two triangles. Within a
/// component the minority is flipped. A component that is not orientable is consistent but for a line on which the
/// traversal closes; it stays as given if that is better. `two_sided`, where given: which triangles face both ways.
/// They are components of their own, and are not counted.
Orientation orient(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                   const std::vector<char>& two_sided = {});

/// Fills in what is reported of it.
void note_orientation(const Orientation& orientation, MeshDefects& defects);

} // namespace meshbound
