#pragma once

#include "meshbound/api.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/mesh_defects.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Whether a mesh can be reduced: shapes of all arrays, indices, names, finite coordinates where triangles are. The first fault
/// found is returned, with its place. Other variables may hold NaN and infinity: then they can have no bound (see
/// resolve_bounds). `defects`, where given, is filled for a valid mesh.
MESHBOUND_API Status validate(const Mesh& mesh, MeshDefects* defects = nullptr);

/// Fills in what `validate` does not look at, because `reduce` finds it out anyway: which triangles of a valid mesh face the
/// wrong side, and which are on the same three vertices.
MESHBOUND_API void find_flipped_triangles(const Mesh& mesh, MeshDefects& defects);

} // namespace meshbound
