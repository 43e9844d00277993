#pragma once

#include "meshbound/meshbound.hpp"

/// Triangles on the same three vertices, taken for the one sheet that they are.
namespace meshes {

/// Only the first triangle on each three vertices, without labels.
meshbound::Mesh one_sided(meshbound::Mesh mesh);
/// The same of a result, whose map then names these.
meshbound::Reduction one_sided(meshbound::Reduction reduction);
/// Only the first triangle on each three vertices that faces its way: both sides stay, copies do not.
meshbound::Mesh without_copies(meshbound::Mesh mesh);

} // namespace meshes
