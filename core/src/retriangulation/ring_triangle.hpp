#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "surface/hole.hpp"
#include "util/indexing.hpp"

namespace meshbound {

/// The triangle of ring indices a < m < b as it stands in space, in bounds of position.
struct RingTriangle {
    RingTriangle(const Hole& hole, int first, int middle, int last)
        : a(first), m(middle), b(last), u(hole.positions[to_index(m)] - hole.positions[to_index(a)]),
          v(hole.positions[to_index(b)] - hole.positions[to_index(a)]),
          w(hole.positions[to_index(b)] - hole.positions[to_index(m)]), normal(glm::cross(u, v)),
          length(glm::length(normal)) {}

    int a, m, b;
    glm::dvec3 u, v, w; ///< edges a → m, a → b and m → b
    glm::dvec3 normal;  ///< of length …
    double length;      ///< … twice the area
};

} // namespace meshbound
