#pragma once

#include <vector>

#include "meshbound/bounds.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Whether the options are within their documented ranges for this mesh. Fault: bad_option.
Status check_options(const Mesh& mesh, const Options& options);

/// Whether position is bounded where the options limit its bound to the feature size. Fault: bad_option.
Status check_feature_limit(const std::vector<ResolvedBound>& bounds, const Options& options);

/// Whether position is bounded where the options have parts smaller than its bound left out. Fault: bad_option.
Status check_small_parts(const std::vector<ResolvedBound>& bounds, const Options& options);

} // namespace meshbound
