#pragma once

#include "errors/tracked/crossings.hpp"
#include "errors/tracked/mapped_vertices.hpp"
#include "errors/tracked/original_edges.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The map Φ from the original surface to the current one. It is combinatorial, with parameters: the images of the
/// removed vertices, and the crossings of original edges with current ones. Cutting each original triangle along chords
/// between its crossings leaves cells, each of which is mapped into one current triangle. So any parameters make Φ
/// continuous and piecewise linear, with corners exactly at the removed vertices and the crossings, and the largest
/// error over the whole surface is at one of these. Rounding changes which Φ is chosen, never whether it is a valid
/// one.
struct TrackedMap {
    explicit TrackedMap(const Surface& surface)
        : edges(surface), crossings(surface.edge_count()), mapped_vertices(surface) {}

    OriginalEdges edges;
    Crossings crossings;
    MappedVertices mapped_vertices;
};

} // namespace meshbound
