#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/level_map.hpp"
#include "meshbound/map.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/reduction.hpp"

namespace meshbound {

/// A reference to something that outlives whatever looks at it; it binds to no temporary.
template <class Value>
class ReferenceTo {
public:
    ReferenceTo(const Value& value) : value_(value) {}
    ReferenceTo(const Value&&) = delete;
    const Value& get() const { return value_; }

private:
    const Value& value_;
};

/// Two surfaces and the tracked map from the one onto the other: a mesh and its reduction, or a level of detail and the next
/// coarser one. Only looks at them; all of them outlive it, so temporaries are refused when a program is compiled.
struct MappedSurfaces {
    MappedSurfaces(ReferenceTo<Mesh> mesh, ReferenceTo<Reduction> reduction)
        : original(mesh.get()), reduced(reduction.get().mesh), vertices(reduction.get().vertices),
          map(reduction.get().map) {}
    MappedSurfaces(ReferenceTo<Mesh> finer, ReferenceTo<Mesh> coarser, ReferenceTo<LevelMap> between)
        : original(finer.get()), reduced(coarser.get()), vertices(between.get().vertices), map(between.get().map) {}
    /// The same map from a mesh with the same vertices, whose triangles are the same but for the sides that they face.
    MappedSurfaces(ReferenceTo<Mesh> turned, const MappedSurfaces& mapped)
        : original(turned.get()), reduced(mapped.reduced), vertices(mapped.vertices), map(mapped.map) {}
    /// Any two meshes with a map between them. `kept`: for each vertex of `onto` its index in `from`, rising.
    MappedSurfaces(ReferenceTo<Mesh> from, ReferenceTo<Mesh> onto, ReferenceTo<std::vector<std::uint32_t>> kept,
                   ReferenceTo<SurfaceMap> between)
        : original(from.get()), reduced(onto.get()), vertices(kept.get()), map(between.get()) {}

    const Mesh& original;
    const Mesh& reduced;
    const std::vector<std::uint32_t>& vertices; ///< for each vertex of `reduced` its index in `original`, rising
    const SurfaceMap& map;                      ///< empty where errors were propagated
};

} // namespace meshbound
