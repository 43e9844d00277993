#pragma once

#include <optional>
#include <vector>

#include "meshbound/bounds.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/status.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {

/// Where the options ask for it: limits the bound of position of every level to half the feature size, since both of
/// two lobes may move towards each other, and fills `size` where that limits one of them. None of them is free (see
/// check_feature_limit). Where the caller cancels, nothing is limited. Fault: bound_too_fine.
Status limit_to_feature_size(const Mesh& mesh, const Options& options, std::vector<std::vector<ResolvedBound>>& levels,
                             std::optional<double>& size, ProgressReporter& reporter);

} // namespace meshbound
