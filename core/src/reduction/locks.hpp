#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"

namespace meshbound {

/// The vertices that the user locked, possibly with repetitions. A triangle whose vertices are all locked stays as it
/// is: a triangle changes only when one of its vertices is removed.
std::vector<std::uint32_t> locked_vertices(const Mesh& mesh, const Options& options);

/// Which of the locked boxes meet no triangle, so that nothing stays because of them: rising indices in Options::locked_boxes.
std::vector<std::size_t> unused_locked_boxes(const Mesh& mesh, const Options& options);

} // namespace meshbound
