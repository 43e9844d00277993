#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meshbound/status.hpp"

namespace meshbound {

/// Whether a list that says of a surface's vertices which of the original's they are names some, in rising order: `whose` is the
/// surface ("the waypoint"), `original` the number of the original's vertices. Returns `fault`, with the surface's vertex.
Status check_kept_vertices(const std::string& whose, const std::vector<std::uint32_t>& vertices, std::size_t original,
                           Fault fault);

} // namespace meshbound
