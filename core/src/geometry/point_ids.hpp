#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace meshbound {

/// By vertex the id of its point: the lowest of the vertices at the same point.
std::vector<std::uint32_t> point_ids(const std::vector<glm::dvec3>& points);

} // namespace meshbound
