#pragma once

#include "errors/tracked/crossings.hpp"
#include "errors/tracked/original_edges.hpp"
#include "errors/tracked/residents.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The map Φ from the original surface to the current one. It is combinatorial plus parameters: where the removed vertices lie
/// and where original edges cross current ones. Cutting each original triangle along chords between its crossings leaves
/// cells, each of which lands in one current triangle; so any choice of places makes Φ continuous, piecewise linear, with
/// corners exactly at the removed vertices and the crossings, and the largest error over the whole surface stands at one of
/// these. Rounding changes which Φ is chosen, never whether it is a valid one.
struct TrackedMap {
    explicit TrackedMap(const Surface& surface) : edges(surface), crossings(surface.edge_count()), residents(surface) {}

    OriginalEdges edges;
    Crossings crossings;
    Residents residents;
};

} // namespace meshbound
