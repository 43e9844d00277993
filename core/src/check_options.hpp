#pragma once

#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Whether the options are within their documented ranges for this mesh. Fault: bad_option.
Status check_options(const Mesh& mesh, const Options& options);

} // namespace meshbound
