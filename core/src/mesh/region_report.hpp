#pragma once

#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/report.hpp"

namespace meshbound {

/// How much of each region there is before and after, by rising labels; nothing where the meshes have no labels. Labels of
/// `after` are labels of `before`. `copies`: triangles of `before` that lie on others, rising, which have no area of their own.
std::vector<RegionReport> report_regions(const Mesh& before, const std::vector<std::uint32_t>& copies,
                                         const Mesh& after);

} // namespace meshbound
