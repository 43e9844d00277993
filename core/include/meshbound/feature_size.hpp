#pragma once

#include <optional>

#include "meshbound/api.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"

namespace meshbound {

/// The feature size of a mesh (§3.2.3): the smallest distance between two separate lobes of its surface.
///
/// Two points p and q of the surface lie on separate lobes, and face each other, where the distance between them is a local
/// minimum above zero: no p' near p and q' near q, both on the surface, are nearer to each other. So the walls of a sheet and
/// of a shell, two turns of a spiral and two components have a distance, be it through the material or outside. The sides of
/// a groove have none: the distance falls, down to zero, towards its bottom; nor has a height field any two lobes. Points that
/// round a tunnel or a neck are on one lobe, which curves; what holds these open is Options::refuse_piercing. Where the
/// surface meets itself already it has no distance. Points count as joined where vertices coincide, as along a seam.
///
/// Only sizes below `within` are looked for; nothing where there is none. The mesh is valid (see validate). A cancelled call
/// finds nothing.
MESHBOUND_API std::optional<double> feature_size(const Mesh& mesh, double within, const Progress& progress = {});

} // namespace meshbound
