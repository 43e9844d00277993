#pragma once

#include <glm/vec3.hpp>

namespace meshbound {

/// The axis along which a box with these sides is longest; of equal ones the first.
inline int longest_side(const glm::dvec3& sides) {
    return sides.x >= sides.y && sides.x >= sides.z ? 0 : sides.y >= sides.z ? 1 : 2;
}

} // namespace meshbound
