#pragma once

#include <vector>

#include "meshbound/bounds.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// The variable that multiplies the bounds (see Options::bound_multiplier), or null.
const Variable* find_bound_multiplier(const Mesh& mesh, const Options& options);

/// Whether there is such a variable, above zero everywhere and nowhere so small that double precision cannot carry the bounds.
/// Everywhere is where triangles are. Faults: unknown_variable, bad_option, non_finite_value, bound_too_fine.
Status check_focus(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Options& options);

} // namespace meshbound
