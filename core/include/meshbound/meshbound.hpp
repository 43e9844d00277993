#pragma once

/// Meshbound: error-bounded reduction of triangle meshes that carry data. Include this, or the one header that you need.

#include "meshbound/bounds.hpp"
#include "meshbound/checkpoint.hpp"
#include "meshbound/feature_size.hpp"
#include "meshbound/level_map.hpp"
#include "meshbound/levels.hpp"
#include "meshbound/map.hpp"
#include "meshbound/mapped_surfaces.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/morph.hpp"
#include "meshbound/options.hpp"
#include "meshbound/progress.hpp"
#include "meshbound/reduce.hpp"
#include "meshbound/report.hpp"
#include "meshbound/resume_reduction.hpp"
#include "meshbound/segmentation.hpp"
#include "meshbound/status.hpp"
#include "meshbound/validate.hpp"
#include "meshbound/verify.hpp"
#include "meshbound/version.hpp"
