#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "surface/hole.hpp"
#include "util/indexing.hpp"

namespace meshbound {

/// The triangle of ring positions a < m < b as it stands in space, in bounds of position.
struct RingTriangle {
    RingTriangle(const Hole& hole, int first, int middle, int last)
        : a(first), m(middle), b(last), u(hole.positions[at(m)] - hole.positions[at(a)]),
          v(hole.positions[at(b)] - hole.positions[at(a)]), w(hole.positions[at(b)] - hole.positions[at(m)]),
          normal(glm::cross(u, v)), length(glm::length(normal)) {}

    int a, m, b;
    glm::dvec3 u, v, w; ///< edges a → m, a → b and m → b
    glm::dvec3 normal;  ///< of length …
    double length;      ///< … twice the area
};

} // namespace meshbound
