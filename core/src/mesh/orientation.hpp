#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/validate.hpp"

namespace meshbound {

/// Triangles turned so that neighbours agree which side is the front one, as far as they can.
struct Orientation {
    std::vector<glm::uvec3> triangles;  ///< all of them, in their order; a turned one has its last two corners swapped
    std::size_t turned = 0;             ///< how many were turned
    std::size_t unorientable_parts = 0; ///< parts that have no consistent orientation (a Möbius band): as far as can be
    std::size_t unorientable_triangle{}; ///< of the first of them its first triangle
};

/// Orients a mesh part by part; a part is what hangs together over edges of just two triangles. Within a part those
/// triangles are turned that are fewer. Where there is no consistent orientation, neighbours agree but across a line on which
/// the walk over the part closes; unless they agree better as they are given.
/// `two_sided`, where given: which triangles face both ways. They are a part of their own, and of them nothing is counted.
Orientation orient(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                   const std::vector<char>& two_sided = {});

/// What there is to tell of it.
void note_turned(const Orientation& orientation, Oddities& oddities);

} // namespace meshbound
