#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/report.hpp"
#include "metric/multipliers.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Takes parts of the surface away whose box has a diagonal of no more than `bound`, multiplied by the least multiplier in
/// the part; the largest part stays, as do those with a vertex of `kept`. A part is what hangs together over vertices or
/// places of vertices, so that a piece between seams is none.
DroppedParts drop_small_parts(const Mesh& mesh, double bound, const Multipliers& multipliers,
                              const std::vector<std::uint32_t>& kept, Surface& surface);

} // namespace meshbound
