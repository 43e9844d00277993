#pragma once

#include <emscripten/val.h>

#include "meshbound/meshbound.hpp"

namespace meshbound::js {

/// A `Reduction` of wasm/types.ts; map and vertex errors only where there are any (tracked errors), the checkpoint where it is
/// given. Every array is copied once, into memory of JavaScript's own.
emscripten::val reduction_to(const Reduction& reduction, double seconds, const Checkpoint* checkpoint = nullptr);

/// `Levels` of wasm/types.ts. What it hands over it frees, so that nothing large is held twice.
emscripten::val levels_to(Levels levels, double seconds);

/// A `Segmentation` of wasm/types.ts: its pieces, without the cells that they make up.
emscripten::val segmentation_to(const Segmentation& segmentation);

/// An `Inspection` of wasm/inspection.ts. `bounds` has position first, then the mesh's variables.
emscripten::val inspection_to(const Mesh& mesh, const MeshDefects& defects, const std::vector<ResolvedBound>& bounds);

} // namespace meshbound::js
