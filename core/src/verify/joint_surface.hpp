#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"

namespace meshbound::verification {

/// The variables that a bound limits, in the order in which their components stand in a row. Variable 0 is position,
/// variable i + 1 the mesh's variable i. Free variables (bound infinity) do not appear.
struct JointSpace {
    std::vector<std::size_t> variables; ///< for each bounded variable its number
    std::vector<int> components;        ///< how many numbers it takes in a row
    std::vector<double> bounds;         ///< its bound, in its unit
    std::vector<double> origin; ///< what is subtracted before dividing by the bound; one entry a number of a row
    int dimensions() const { return static_cast<int>(origin.size()); }
};

/// A surface in the joint space of position and variables: each component centred and divided by the bound of its
/// variable, so that a distance of 1 is the limit. A triangle with a vertex twice is a segment: so curves are surfaces too.
struct JointSurface {
    int dimensions = 0;
    std::vector<double> rows; ///< `dimensions` numbers a vertex
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// What multiplies the limit at each vertex, linear between them; empty where nothing does.
    std::vector<double> multipliers{};
    const double* row(std::uint32_t vertex) const { return rows.data() + std::size_t{vertex} * dimensions; }
};

/// The joint space of a mesh. `bounds` holds the bound of position, then one a variable, absolute and positive;
/// infinity is free.
JointSpace joint_space(const Mesh& mesh, const std::vector<double>& bounds);

/// A mesh as a surface in that space; triangles with a vertex twice are no surface and left out. It
/// has the variables of the space, by the same numbers.
JointSurface joint_surface(const Mesh& mesh, const JointSpace& space);

/// The boundary of a mesh, the edges of exactly one triangle, as a curve in that space. Triangles on the same three vertices
/// (copies, the two sides of a sheet) cover each other, so that they count as one: the rim of either is a rim.
JointSurface joint_boundary(const Mesh& mesh, const JointSpace& space);

} // namespace meshbound::verification
