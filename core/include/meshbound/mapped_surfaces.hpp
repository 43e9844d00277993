#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/level_map.hpp"
#include "meshbound/map.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/reduce.hpp"

namespace meshbound {

/// Two surfaces and the tracked map from the one onto the other: a mesh and its reduction, or a level of detail and the next
/// coarser one. Only looks at them; all of them outlive it.
struct MappedSurfaces {
    MappedSurfaces(const Mesh& mesh, const Reduction& reduction)
        : original(mesh), reduced(reduction.mesh), vertices(reduction.vertices), map(reduction.map) {}
    MappedSurfaces(const Mesh& finer, const Mesh& coarser, const LevelMap& link)
        : original(finer), reduced(coarser), vertices(link.vertices), map(link.map) {}
    /// The same map from a mesh with the same vertices, whose triangles are the same but for the sides that they face.
    MappedSurfaces(const Mesh& turned, const MappedSurfaces& mapped)
        : original(turned), reduced(mapped.reduced), vertices(mapped.vertices), map(mapped.map) {}
    /// Any two meshes with a map between them.
    MappedSurfaces(const Mesh& from, const Mesh& onto, const std::vector<std::uint32_t>& kept,
                   const SurfaceMap& between)
        : original(from), reduced(onto), vertices(kept), map(between) {}

    const Mesh& original;
    const Mesh& reduced;
    const std::vector<std::uint32_t>& vertices; ///< for each vertex of `reduced` its index in `original`, rising
    const SurfaceMap& map;                      ///< empty where errors were propagated
};

} // namespace meshbound
