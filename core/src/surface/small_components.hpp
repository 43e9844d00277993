#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/report.hpp"
#include "metric/multipliers.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Removes connected components whose box has a diagonal of no more than `bound`, times the least multiplier in the
/// component; the largest stays, as do those with a vertex of `kept`. Components are connected over vertices or over
/// their positions, so that seams do not separate them.
DroppedComponents drop_small_components(const Mesh& mesh, double bound, const Multipliers& multipliers,
                                        const std::vector<std::uint32_t>& kept, Surface& surface);

} // namespace meshbound
