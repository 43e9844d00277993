#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace meshbound {

/// One number for all vertices at the same point: the lowest of them. By vertex.
std::vector<std::uint32_t> number_places(const std::vector<glm::dvec3>& points);

} // namespace meshbound
