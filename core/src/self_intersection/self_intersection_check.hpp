#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/aabb_tree.hpp"
#include "geometry/triangle_intersection.hpp"
#include "meshbound/mesh.hpp"
#include "surface/hole.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Keeps lobes that pass near each other from intersecting (§3.2.3, figure 4): no new triangle may intersect another
/// triangle of the surface beyond the corners and edges that they share. So two triangles of the result do so only if
/// both are triangles of the original, which did so already.
///
/// It uses exact positions, and ids of points instead of vertices: what coincides without sharing vertices, as along a
/// seam, counts as joined.
///
/// Threads may query and update at once as long as the triangles that each of them replaces lie in a box of space of
/// its own (see Sweeper and Patches). Its new triangles lie there, too, so that none of the other threads' can
/// intersect them.
class SelfIntersectionCheck {
public:
    /// The surface is that of the mesh, or a reduction of it. Outlives this.
    SelfIntersectionCheck(const Mesh& mesh, const Surface& surface);

    /// A hole and the retriangulation that is to fill it.
    struct Filling {
        const Hole* hole;
        const Retriangulation* retriangulation;
    };
    /// Whether a new triangle of holes that are to be filled together would intersect another one, or a triangle
    /// outside the holes. The surface is not retriangulated yet.
    bool self_intersects(const std::vector<Filling>& fillings) const;

    /// Updates the tree after the hole was retriangulated.
    void update(const Hole& hole, const Retriangulation& retriangulation);

    /// Rebuilds the tree where more than half of its triangles are gone, to keep queries fast. Not thread-safe.
    void rebuild_if_sparse();

private:
    struct Boxed {
        SpatialTriangle triangle;
        BoundingBox box;
    };
    static bool self_intersects(const std::vector<Boxed>& fresh, const SpatialTriangle& other);
    SpatialTriangle spatial_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
    SpatialTriangle spatial_triangle(std::uint32_t slot) const;
    SpatialTriangle spatial_triangle(const Hole& hole, const NewTriangle& triangle) const;
    void build();

    const Surface& surface_;
    std::vector<glm::dvec3> points_; // by vertex, scaled
    std::vector<std::uint32_t> ids_; // by vertex
    AabbTree tree_;
    std::size_t built_over_ = 0;          // number of triangles when the tree was built
    std::atomic<std::size_t> removed_{0}; // triangles removed since
};

} // namespace meshbound
