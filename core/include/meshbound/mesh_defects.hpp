#pragma once

#include <cstddef>
#include <optional>

namespace meshbound {

/// What is unusual about a valid mesh. None of it is an error; all of it is reported.
struct MeshDefects {
    std::size_t repeated_vertex_triangles = 0; ///< triangles with a vertex twice: no surface, left out of the result
    std::size_t zero_area_triangles = 0; ///< three distinct vertices on a line: part of the surface, reduced as usual
    std::size_t unused_vertices =
        0; ///< vertices of no triangle, those with a vertex twice apart: left out of the result
    std::size_t flipped_triangles = 0;       ///< triangles that face the other side than most around them: turned round
    std::size_t unorientable_components = 0; ///< parts without two sides (a Möbius band): oriented up to a line
    std::optional<std::size_t> unorientable_triangle; ///< the first triangle of the first of them
    std::size_t copied_triangles = 0; ///< on the three vertices of an earlier one, facing the same way: left out
    /// Pairs of triangles on the same three vertices that face opposite ways: the two sides of one sheet, which are reduced
    /// together and are both in the result.
    std::size_t two_sided_triangles = 0;
};

} // namespace meshbound
