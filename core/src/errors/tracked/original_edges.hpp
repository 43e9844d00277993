#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/surface.hpp"
#include "util/prefetch.hpp"

namespace meshbound {

/// The edges of the original surface, numbered as in its Surface when the map begins (of a link between levels: as in
/// the finer level). Each runs from its lower vertex (s = 0) to its upper one (s = 1). Only edges between two triangles
/// can cross anything later; boundary edges always run along current edges, and are not listed at their vertices.
class OriginalEdges {
public:
    explicit OriginalEdges(const Surface& surface);

    std::uint32_t lower(std::uint32_t edge) const { return ends_[2 * std::size_t(edge)]; }
    std::uint32_t upper(std::uint32_t edge) const { return ends_[2 * std::size_t(edge) + 1]; }
    std::size_t size() const { return ends_.size() / 2; }

    /// Releases the memory of what incident_to needs.
    void release_incidence() {
        std::vector<std::uint32_t>().swap(start_); // assigning {} would keep it
        std::vector<IncidentEdge>().swap(incident_);
    }

    /// Prefetches where a vertex's edges begin; and, once that is in the cache, the edges.
    void prefetch_start(std::uint32_t vertex) const { prefetch(&start_[vertex]); }
    void prefetch_incident(std::uint32_t vertex) const { prefetch(incident_.data() + start_[vertex]); }

    /// An edge at one of its ends.
    struct IncidentEdge {
        std::uint32_t edge, end; ///< and its other end
    };
    /// The edges between two triangles that end at a vertex.
    std::span<const IncidentEdge> incident_to(std::uint32_t vertex) const {
        return {incident_.data() + start_[vertex], incident_.data() + start_[vertex + std::size_t{1}]};
    }

private:
    std::vector<std::uint32_t> ends_;
    std::vector<std::uint32_t> start_;   // by vertex: incident_[start_[v]] … incident_[start_[v + 1] - 1]
    std::vector<IncidentEdge> incident_; // and one more, so that every start_ is a valid index
};

} // namespace meshbound
