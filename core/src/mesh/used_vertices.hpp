#pragma once

#include <vector>

#include "meshbound/mesh.hpp"

namespace meshbound {

/// By vertex, whether a triangle of three distinct vertices uses it. What stands at the others is no part of the
/// surface, and may be anything, NaN too.
std::vector<char> find_used_vertices(const Mesh& mesh);

} // namespace meshbound
