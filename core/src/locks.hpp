#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"

namespace meshbound {

/// The vertices that the user locked, some perhaps more than once. A triangle whose vertices are all locked stays as it is:
/// triangles change with the star of one of their vertices only.
std::vector<std::uint32_t> locked_vertices(const Mesh& mesh, const Options& options);

} // namespace meshbound
