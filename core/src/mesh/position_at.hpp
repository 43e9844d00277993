#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "meshbound/mesh.hpp"

namespace meshbound {

/// Where a vertex is, in double precision (exact).
inline glm::dvec3 position_at(const Mesh& mesh, std::size_t vertex) {
    return {value_at(mesh.position, vertex, 0), value_at(mesh.position, vertex, 1), value_at(mesh.position, vertex, 2)};
}

} // namespace meshbound
