#pragma once

#include <functional>

namespace meshbound {

/// Called often (every few milliseconds) with the progress so far, 0…1, never falling. Return false to cancel.
using Progress = std::function<bool(double)>;

} // namespace meshbound
