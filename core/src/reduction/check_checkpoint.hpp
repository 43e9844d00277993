#pragma once

#include "meshbound/checkpoint.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Whether the parts of a checkpoint, whose mesh is valid, agree with each other. Fault: bad_checkpoint.
Status check_checkpoint(const Checkpoint& checkpoint);

} // namespace meshbound
