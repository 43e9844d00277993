#pragma once

#include "meshbound/meshbound.hpp"

/// What a reduction must keep: locks, labels, seams, and parts of the surface unless they are small and may go.
namespace fuzz {

/// The surface that the result stands for: without triangles that are none, and without parts that were dropped. Requires
/// that these were allowed to go, and counted.
meshbound::Mesh without_dropped(const meshbound::Mesh& mesh, const meshbound::Options& options,
                                const meshbound::Reduction& reduction);

/// Locked vertices are still there, triangles in locked boxes and regions as they were.
void check_locks(const meshbound::Mesh& mesh, const meshbound::Options& options, const meshbound::Reduction& reduction);

/// Vertices have the labels around them that they had. `mesh` is without dropped parts, as of check_seams.
void check_labels(const meshbound::Mesh& mesh, const meshbound::Reduction& reduction);

/// Of vertices that face each other along a seam all or none are still there.
void check_seams(const meshbound::Mesh& mesh, const meshbound::Reduction& reduction);

} // namespace fuzz
