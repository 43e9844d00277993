#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// So many variables can be named by 16 bits, in which 0 is position.
inline constexpr std::size_t most_variables = std::numeric_limits<std::uint16_t>::max();

/// Whether a mesh is a surface that carries data: shapes of all arrays, indices, names, finite coordinates where triangles are.
/// The first fault found is returned, with its place. `used`: filled with which vertices triangles use (see
/// find_used_vertices) where nothing is wrong.
Status check_arrays(const Mesh& mesh, std::vector<char>& used);

} // namespace meshbound
