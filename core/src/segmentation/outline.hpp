#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "meshbound/mapped_surfaces.hpp"
#include "segmentation/face_lookup.hpp"

namespace meshbound {

/// A step of an original triangle's outline on its path over the reduced surface: a corner of the triangle, removed or
/// kept, or a crossing with a reduced edge. Between two steps the path lies in one reduced triangle.
struct OutlineStep {
    std::uint32_t corner = 0;     ///< by its name in Segmentation::corners
    std::uint32_t kept = nowhere; ///< of a kept vertex: the vertex of the reduced mesh
    glm::uvec2 crossed{nowhere};  ///< of a crossing: the reduced edge
    /// The reduced triangle that it comes from and the one it goes to; nowhere at a kept vertex, around which the path
    /// may turn, and at a vertex on a curve, which is in a triangle of each sheet.
    std::uint32_t before = nowhere, after = nowhere;
    glm::uvec2 curve{nowhere}; ///< of a removed vertex on a curve: the reduced edge where it lies

    bool is_kept() const { return kept != nowhere; }
    bool is_on_curve() const { return curve.x != nowhere; }
    bool is_crossing() const { return crossed.x != nowhere; }
};
using Outline = std::vector<OutlineStep>;

/// Traces the outlines of original triangles.
class Outlines {
public:
    Outlines(const MappedSurfaces& surfaces, const FaceLookup& reduced_faces);

    /// The steps of a triangle's outline, counter-clockwise, from its first corner.
    void trace(std::uint32_t triangle, Outline& outline) const;

private:
    glm::uvec2 curve_at(const SurfacePoint& place) const;
    void add_vertex(std::uint32_t vertex, Outline& outline) const;
    void add_crossings(std::uint32_t from, std::uint32_t to, Outline& outline) const;

    const Mesh* original_;
    const Mesh* reduced_;
    const SurfaceMap* map_;
    const FaceLookup* faces_;
    std::vector<std::uint32_t> kept_as_;                             // by original vertex: the reduced one, or nowhere
    std::vector<std::pair<std::uint64_t, std::uint32_t>> crossings_; // sorted: original edge, index of the crossing
    /// By original vertex: whether an edge from it to a higher one is crossed; far from all are after a strong reduction.
    std::vector<char> has_crossed_edge_;
};

} // namespace meshbound
