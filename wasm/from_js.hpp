#pragma once

#include <string>
#include <vector>

#include <emscripten/val.h>

#include "meshbound/meshbound.hpp"

namespace meshbound::js {

/// A value from JavaScript that has not the shape that wasm/types.ts gives it.
struct ShapeError {
    Status status;
};

/// A `Mesh` of wasm/types.ts. Every array is copied once.
Mesh mesh_from(const emscripten::val& mesh);

/// The bounds of `ReduceOptions`. Throws ShapeError.
Bounds bounds_from(const emscripten::val& bounds);

/// The bounds of every level of `LevelsOptions`. Throws ShapeError.
std::vector<Bounds> level_bounds_from(const emscripten::val& levels);

/// The rest of `LevelsOptions`. Throws ShapeError.
LevelOptions level_options_from(const emscripten::val& options);

/// The rest of `ReduceOptions`; what is left out keeps the core's default. Throws ShapeError.
Options options_from(const emscripten::val& options);

/// Whether `ReduceOptions` ask for the checkpoint. Throws ShapeError.
bool wants_checkpoint(const emscripten::val& options);

/// A `Checkpoint` of wasm/types.ts. Throws ShapeError.
Checkpoint checkpoint_from(const emscripten::val& checkpoint);

/// Of a `Reduction` its mesh, vertices and map: what says where the mesh that was reduced went. Throws ShapeError.
Reduction mapped_reduction_from(const emscripten::val& reduction);

} // namespace meshbound::js
