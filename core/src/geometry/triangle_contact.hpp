#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace meshbound {

/// A triangle in space. Corners at one place have one number there, whichever vertex they are: along seams, where vertices
/// are doubled, triangles have corners and edges in common all the same.
struct PlacedTriangle {
    std::array<std::uint32_t, 3> places;
    std::array<glm::dvec3, 3> points;
};

/// Whether two triangles meet beyond the corners and edges that they have in common: one pierces or touches the other, or
/// they lie on each other. Exact; where a triangle has no area, it may see a contact that there is not, never miss one of a
/// triangle that has an area with the other's edges.
bool pierce(const PlacedTriangle& one, const PlacedTriangle& other);

} // namespace meshbound
