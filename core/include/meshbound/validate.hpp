#pragma once

#include <cstddef>
#include <optional>

#include "meshbound/api.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// What is unusual about a valid mesh. None of it is an error; all of it is reported.
struct Oddities {
    std::size_t repeated_vertex_triangles = 0; ///< triangles with a vertex twice: no surface, left out of the result
    std::size_t zero_area_triangles = 0; ///< three distinct vertices on a line: part of the surface, reduced as usual
    std::size_t unused_vertices = 0;     ///< vertices of no triangle: left out of the result
    std::size_t turned_triangles = 0;    ///< triangles that face the other side than most around them: turned round
    std::size_t unorientable_parts = 0;  ///< parts without two sides (a Möbius band): oriented up to a line
    std::optional<std::size_t> unorientable_triangle; ///< the first triangle of the first of them
};

/// Whether a mesh can be reduced: shapes of all arrays, indices, names, finite numbers. The first fault found is returned,
/// with its place. `oddities`, where given, is filled for a valid mesh.
MESHBOUND_API Status validate(const Mesh& mesh, Oddities* oddities = nullptr);

/// Fills in what `validate` does not look at, because `reduce` finds it out anyway: which triangles of a valid mesh face the
/// wrong side.
MESHBOUND_API void find_turned(const Mesh& mesh, Oddities& oddities);

} // namespace meshbound
