#pragma once

#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"
#include "meshbound/verify.hpp"

namespace meshbound::verification {

/// Whether two meshes can be compared by these bounds and multipliers; see `verify` for what is wrong where they cannot.
Status check_comparable(const Mesh& original, const Mesh& reduced, const std::vector<double>& bounds,
                        const VerifyOptions& options);

} // namespace meshbound::verification
