#include "segmentation/outline.hpp"

#include <algorithm>

namespace meshbound {
namespace {

std::uint64_t edge_key(std::uint32_t lower, std::uint32_t upper) { return std::uint64_t{lower} << 32 | upper; }

} // namespace

Outlines::Outlines(const MappedSurfaces& surfaces, const FaceLookup& reduced_faces)
    : original_(&surfaces.original), reduced_(&surfaces.reduced), map_(&surfaces.map), faces_(&reduced_faces),
      kept_as_(surfaces.map.images.size(), nowhere), has_crossed_edge_(surfaces.map.images.size(), 0) {
    for (std::uint32_t v = 0; v < surfaces.vertices.size(); ++v) kept_as_[surfaces.vertices[v]] = v;
    crossings_.reserve(map_->crossings.size());
    for (std::uint32_t n = 0; n < map_->crossings.size(); ++n) {
        const glm::uvec2 edge = map_->crossings[n].original;
        crossings_.emplace_back(edge_key(edge.x, edge.y), n);
        has_crossed_edge_[edge.x] = 1;
    }
    // By edge, and along an edge as in the map: with s rising, and in their order where it does not.
    std::sort(crossings_.begin(), crossings_.end());
}

void Outlines::trace(std::uint32_t triangle, Outline& outline) const {
    outline.clear();
    const glm::uvec3& corners = original_->triangles[triangle];
    for (int i = 0; i < 3; ++i) {
        add_vertex(corners[i], outline);
        add_crossings(corners[i], corners[(i + 1) % 3], outline);
    }
}

void Outlines::add_vertex(std::uint32_t vertex, Outline& outline) const {
    OutlineStep step;
    step.corner = vertex;
    step.kept = kept_as_[vertex];
    if (!step.is_kept()) {
        step.curve = curve_at(map_->images[vertex]);
        if (!step.is_on_curve()) step.before = step.after = map_->images[vertex].triangle;
    }
    outline.push_back(step);
}

/// The edge at which sheets meet and on which a point lies, or nowhere.
glm::uvec2 Outlines::curve_at(const SurfacePoint& place) const {
    const glm::uvec3& triangle = reduced_->triangles[place.triangle];
    for (int i = 0; i < 3; ++i) {
        if (place.barycentric[i] != 0) continue;
        const glm::uvec2 edge(triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
        if (faces_->is_curve(edge.x, edge.y)) return edge;
    }
    return glm::uvec2(nowhere);
}

void Outlines::add_crossings(std::uint32_t from, std::uint32_t to, Outline& outline) const {
    if (!has_crossed_edge_[std::min(from, to)]) return;
    const std::uint64_t key = edge_key(std::min(from, to), std::max(from, to));
    const auto first = std::lower_bound(crossings_.begin(), crossings_.end(), std::pair{key, std::uint32_t{0}});
    const std::size_t start = outline.size();
    for (auto it = first; it != crossings_.end() && it->first == key; ++it) {
        const MapCrossing& crossing = map_->crossings[it->second];
        OutlineStep step;
        step.corner = static_cast<std::uint32_t>(kept_as_.size()) + it->second;
        step.crossed = crossing.reduced;
        step.before = faces_->left_of(crossing.reduced.x, crossing.reduced.y);
        step.after = faces_->left_of(crossing.reduced.y, crossing.reduced.x);
        if (crossing.rightward != (from < to)) std::swap(step.before, step.after);
        outline.push_back(step);
    }
    if (from > to) std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(start), outline.end());
}

} // namespace meshbound
