#pragma once

#include <vector>

#include "meshbound/bounds.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Resolves bounds as resolve_bounds does, for a mesh that stands for another one whose variables are measured already:
/// `resolved` has their extents, magnitudes, whether they are constant and where they are no numbers, position first.
Status resolve_measured_bounds(const Mesh& mesh, const Bounds& bounds, std::vector<ResolvedBound>& resolved);

/// Whether double precision can carry a bound beside the extent of its variable.
bool can_be_carried(const ResolvedBound& bound);

} // namespace meshbound
