#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "surface/hole.hpp"
#include "meshbound/mesh.hpp"
#include "surface/surface.hpp"
#include "geometry/triangle_contact.hpp"
#include "geometry/triangle_tree.hpp"

namespace meshbound {

/// Keeps lobes that pass near each other from piercing (§3.2.3, figure 4): no new triangle may meet another triangle of the
/// surface beyond the corners and edges that they have in common. So two triangles of the result meet there only if both are
/// triangles of the original, which met there already.
///
/// Looks at exact positions, and at places instead of vertices: what is joined in space but not by vertices, as along a seam,
/// counts as joined.
///
/// Threads may ask and change at once as long as the triangles that each of them changes lie in a box of space of its own
/// (see Sweeper, and Patches), as its new triangles then do: none of the others' can meet these.
class Piercing {
public:
    /// The surface is that of the mesh, or a reduction of it. Outlives this.
    Piercing(const Mesh& mesh, const Surface& surface);

    /// A hole and what is to fill it.
    struct Filling {
        const Hole* hole;
        const Retriangulation* retriangulation;
    };
    /// Whether one of the new triangles of holes that are filled together, which are not retriangulated yet, would meet
    /// another one or a triangle outside the holes.
    bool pierces(const std::vector<Filling>& fillings) const;

    /// Takes in that the hole was retriangulated.
    void change(const Hole& hole, const Retriangulation& retriangulation);

    /// Makes looking fast again where much has vanished. No other thread may ask or change meanwhile.
    void tidy();

private:
    struct Boxed {
        PlacedTriangle triangle;
        BoundingBox box;
    };
    static bool pierces(const std::vector<Boxed>& fresh, const PlacedTriangle& other);
    PlacedTriangle placed(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    PlacedTriangle placed(std::uint32_t slot) const;
    PlacedTriangle placed(const Hole& hole, const NewTriangle& triangle) const;
    void build();

    const Surface& surface_;
    std::vector<glm::dvec3> points_;    // by vertex, scaled
    std::vector<std::uint32_t> places_; // by vertex
    TriangleTree tree_;
    std::size_t built_over_ = 0;           // so many triangles
    std::atomic<std::size_t> vanished_{0}; // since then
};

} // namespace meshbound
