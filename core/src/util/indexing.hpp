#pragma once

#include <cstddef>

namespace meshbound {

/// An int that is not negative, such as a ring index, as an index into a container.
inline std::size_t to_index(int i) { return static_cast<std::size_t>(i); }

} // namespace meshbound
