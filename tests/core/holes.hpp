#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "meshbound/bounds.hpp"
#include "meshes/shapes.hpp"
#include "metric/rows.hpp"
#include "retriangulation/layout.hpp"
#include "retriangulation/legality.hpp"
#include "retriangulation/original_normals.hpp"
#include "surface/hole.hpp"
#include "surface/surface.hpp"

/// One candidate of a small mesh, with everything that a decision about its hole is made from.
namespace holes {

using namespace meshbound;

/// One unit of length is the bound of position.
inline Rows rows_of(const Mesh& mesh, const Surface& surface) {
    std::vector<ResolvedBound> bounds;
    EXPECT_TRUE(resolve_bounds(mesh, {{"position", absolute(1)}}, bounds).ok());
    return Rows(mesh, bounds, nullptr, surface.inputs());
}

class Star {
public:
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    /// `joined`: vertices that belong together, as those on both sides of a seam.
    Star(const Mesh& mesh, std::uint32_t candidate, bool minds_turns = false, const Pairs& joined = {})
        : surface(mesh.triangles, vertex_count(mesh)), rows(rows_of(mesh, surface)), normals(surface, rows),
          legality(normals, minds_turns) {
        surface.join_coincident(joined);
        gather_star(surface, surface.first_vertex_of(candidate), hole);
        lay_out(rows, hole);
    }
    /// Its parts refer to each other.
    Star(const Star&) = delete;
    Star& operator=(const Star&) = delete;

    bool enter() { return legality.enter(surface, rows, hole); }
    /// Where a vertex stands in the ring; -1: nowhere.
    int position(std::uint32_t vertex) const {
        for (int i = 0; i < hole.size(); ++i)
            if (surface.input(hole.ring[static_cast<std::size_t>(i)]) == vertex) return i;
        return -1;
    }

    Surface surface;
    Rows rows;
    OriginalNormals normals;
    Hole hole;
    Legality legality;
};

/// A candidate, vertex 0, amid (`closed`) or beside its neighbours, vertices 1 … corners, counter-clockwise. `turn`: which of
/// the triangles comes first, so that the ring of a closed one begins elsewhere.
inline std::vector<glm::uvec3> star_triangles(std::uint32_t corners, bool closed, std::uint32_t turn = 0) {
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t i = 1; i < corners; ++i) triangles.push_back({0, i, i + 1});
    if (closed) triangles.push_back({0, corners, 1});
    std::rotate(triangles.begin(), triangles.begin() + turn, triangles.end());
    return triangles;
}

} // namespace holes
