#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meshbound/status.hpp"

namespace meshbound {

/// Whether `vertices`, by vertex of a surface its index in the original, are valid and rising. `whose`: the surface,
/// for the message ("the checkpoint"); `original`: how many vertices the original has. Returns `fault`, with the vertex
/// of the surface.
Status check_kept_vertices(const std::string& whose, const std::vector<std::uint32_t>& vertices, std::size_t original,
                           Fault fault);

} // namespace meshbound
