#pragma once

#include "meshbound/segmentation.hpp"

namespace meshbound {

/// As `segment`, of an original whose triangles agree already which side is the front one.
void segment_oriented(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress = {});

} // namespace meshbound
