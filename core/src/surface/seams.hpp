#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "meshbound/mesh.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Pairs of vertices that coincide because boundary edges at them run between the same two positions: along seams,
/// where a variable jumps, along borders of regions and edges of three or more triangles. For Surface::join_coincident.
std::vector<std::pair<std::uint32_t, std::uint32_t>> find_seams(const Mesh& mesh, const Surface& surface);

} // namespace meshbound
