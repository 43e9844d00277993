#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/api.hpp"
#include "meshbound/glm_layout.hpp"
#include "meshbound/mapped_surfaces.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Where a corner of a morph lies on a level: a mixture of up to three of the level's vertices, all of one triangle. Weights
/// are 0…1 and add up to 1; a vertex with weight 0 may stand for any.
struct MorphPoint {
    glm::uvec3 vertices{0};
    glm::dvec3 weights{1, 0, 0};
};

/// One of the two levels that a morph leads between, as the morph sees it.
struct MorphEnd {
    std::vector<Variable> variables;      ///< at the corners: position first, then the variables of the level
    std::vector<MorphPoint> points;       ///< of the corners
    std::vector<std::uint32_t> triangles; ///< for each triangle of the morph the level's triangle that it lies in
};

/// The way from a finer level of detail to the next coarser one (§4): the pieces of their mutual segmentation, whose corners
/// carry the place and the values of both. Position and every variable, mixed at the corners, lead from the one surface to
/// the other without a jump and without a crack, boundary on boundary: at 0 it is the finer level, at 1 the coarser one.
///
/// The first corners are the vertices of the finer level; then come the crossings of its edges with those of the coarser
/// level. Values are in the precision of the meshes: those of vertices bit for bit, those at crossings rounded once.
struct Morph {
    std::vector<glm::uvec3> triangles; ///< three corners each
    MorphEnd finer, coarser;
    std::size_t folded_triangles = 0; ///< that run clockwise on the coarser level (see Segmentation)
    double folded_share = 0;          ///< and their share of the finer level's area
};

/// Makes the morph between two surfaces. Where there is no map between them, after a reduction with propagated errors, it
/// has no triangles, and so where `progress` cancels.
///
/// Faults: those of segment; bad_map with the variable that the surfaces do not both carry. `morph` is then untouched.
///
///     make_morph({mesh, levels.levels[0]}, morph);                                               // from the original
///     make_morph({levels.levels[0].mesh, levels.levels[1].mesh, levels.maps[0]}, morph);       // to the next level
MESHBOUND_API Status make_morph(const MappedSurfaces& surfaces, Morph& morph, const Progress& progress = {});

/// The surface on its way, `share` 0…1: at 0 the triangles of the morph on the finer level, at 1 on the coarser one.
MESHBOUND_API Mesh morphed(const Morph& morph, double share);

} // namespace meshbound
