#pragma once

#include "meshbound/meshbound.hpp"

/// What holds of every reduction, whatever went in. Whatever does not hold ends the program, as a fuzzer wants it.
namespace fuzz {

void require(bool condition, const char* what);

/// The guarantees of a reduction of a mesh within its bounds, under its options.
void check_reduction(const meshbound::Mesh& mesh, const meshbound::Options& options,
                     const meshbound::Reduction& reduction);

/// The levels of a mesh: each of them, that they nest, and that morphs between them hang together.
void check_levels(const meshbound::Mesh& mesh, const meshbound::Options& options, const meshbound::Levels& levels);

} // namespace fuzz
