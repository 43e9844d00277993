#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "util/fetch.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The edges of the original surface, named as its Surface names them at the start (of a link: the surface as it is then). Each runs from its lower vertex (s = 0)
/// to its upper one (s = 1). Only edges between two triangles can cross anything later; boundary and non-manifold edges
/// run along current edges for ever and are not listed at their vertices.
class OriginalEdges {
public:
    explicit OriginalEdges(const Surface& surface);

    std::uint32_t lower(std::uint32_t edge) const { return ends_[2 * std::size_t(edge)]; }
    std::uint32_t upper(std::uint32_t edge) const { return ends_[2 * std::size_t(edge) + 1]; }
    std::size_t size() const { return ends_.size() / 2; }

    /// Gives back the memory of what `at` and fetching need.
    void forget_spokes() {
        std::vector<std::uint32_t>().swap(start_); // assigning {} would keep it
        std::vector<Spoke>().swap(spokes_);
    }

    /// Has the processor fetch, without waiting, where a vertex's edges stand; and, that being there, the edges.
    void fetch_start(std::uint32_t vertex) const { fetch(&start_[vertex]); }
    void fetch_spokes(std::uint32_t vertex) const { fetch(spokes_.data() + start_[vertex]); }

    /// An edge at one of its ends.
    struct Spoke {
        std::uint32_t edge, end; ///< and its other end
    };
    /// The edges between two triangles that end at a vertex.
    std::span<const Spoke> at(std::uint32_t vertex) const {
        return {spokes_.data() + start_[vertex], spokes_.data() + start_[vertex + std::size_t{1}]};
    }

private:
    std::vector<std::uint32_t> ends_;
    std::vector<std::uint32_t> start_; // by vertex: spokes_[start_[v]] … spokes_[start_[v + 1] - 1]
    std::vector<Spoke> spokes_;        // and one more, so that where a vertex's begin there is one
};

} // namespace meshbound
