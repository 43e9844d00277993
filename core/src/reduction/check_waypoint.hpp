#pragma once

#include "meshbound/status.hpp"
#include "meshbound/waypoint.hpp"

namespace meshbound {

/// Whether the parts of a waypoint, whose mesh is valid, agree with each other. Fault: bad_waypoint.
Status check_waypoint(const Waypoint& waypoint);

} // namespace meshbound
