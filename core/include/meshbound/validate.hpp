#pragma once

#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// What is unusual about a valid mesh. None of it is an error; all of it is reported.
struct Oddities {
    std::size_t repeated_vertex_triangles = 0; ///< triangles with a vertex twice: no surface, left out of the result
    std::size_t zero_area_triangles = 0; ///< three distinct vertices on a line: part of the surface, reduced as usual
    std::size_t unused_vertices = 0;     ///< vertices of no triangle: left out of the result
};

/// Whether a mesh can be reduced: shapes of all arrays, indices, names, finite numbers. The first fault found is returned,
/// with its place. `oddities`, where given, is filled for a valid mesh.
Status validate(const Mesh& mesh, Oddities* oddities = nullptr);

} // namespace meshbound
