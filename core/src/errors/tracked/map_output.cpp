#include "errors/tracked/map_output.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "util/shared_loop.hpp"

namespace meshbound {
namespace {

/// Barycentric coordinates in the triangle of half-edge h of the place at `share` along h.
MapPlace place_on(std::uint32_t h, double share, const std::vector<std::uint32_t>& renamed_triangle) {
    MapPlace place{renamed_triangle[Surface::triangle_of(h)], glm::dvec3(0)};
    place.barycentric[static_cast<int>(h % 3)] = 1 - share;
    place.barycentric[static_cast<int>(Surface::next(h) % 3)] = share;
    return place;
}

/// Of a vertex on an edge neither end has less than this, which is lost beside 1: so that the only weight of 0 tells which edge
/// of the triangle it lies on, also where its share is 0 or 1 by rounding.
constexpr double least_weight = 1e-300;

/// The place of a vertex that was put on the edge of half-edge h.
MapPlace place_between(std::uint32_t h, double share, const std::vector<std::uint32_t>& renamed_triangle) {
    MapPlace place = place_on(h, share, renamed_triangle);
    for (const std::uint32_t end : {h, Surface::next(h)}) {
        double& weight = place.barycentric[static_cast<int>(end % 3)];
        weight = std::max(weight, least_weight);
    }
    return place;
}

void place_residents(const Surface& surface, const Residents& residents, std::uint32_t slot,
                     const std::vector<std::uint32_t>& renamed_triangle, SurfaceMap& map) {
    for (std::uint32_t v = residents.in_triangle(slot); v != no_index; v = residents.next(v))
        map.places[surface.input(v)] = {renamed_triangle[slot], residents.barycentric(v)};
    for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h) {
        map.places[surface.input(surface.origin(h))] = place_on(h, 0, renamed_triangle);
        const bool canonical = surface.origin(h) < surface.target(h);
        for (std::uint32_t v = residents.on_edge(surface.edge(h)); v != no_index; v = residents.next(v))
            map.places[surface.input(v)] =
                place_between(h, canonical ? residents.share(v) : 1 - residents.share(v), renamed_triangle);
    }
}

/// The current edges, few beside those that were, with their ends.
class CurrentEdges {
public:
    explicit CurrentEdges(const Surface& surface) {
        for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
            if (!surface.alive(slot)) continue;
            for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h)
                if (surface.twin(h) == no_index || h < surface.twin(h))
                    edges_.push_back({surface.edge(h), std::minmax({surface.origin(h), surface.target(h)})});
        }
        std::sort(edges_.begin(), edges_.end());
    }

    /// The lower one first.
    const std::pair<std::uint32_t, std::uint32_t>& ends(std::uint32_t edge) const {
        return std::lower_bound(edges_.begin(), edges_.end(), Edge{edge, {0, 0}})->second;
    }

private:
    using Edge = std::pair<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>>;
    std::vector<Edge> edges_; // by their numbers
};

std::size_t crossings_on(const OriginalEdges& edges, const Crossings& crossings) {
    std::size_t count = 0;
    for (std::uint32_t edge = 0; edge < edges.size(); ++edge)
        for (std::uint32_t id = crossings.first(edge); id != no_index; id = crossings[id].next) ++count;
    return count;
}

/// Compares vertices of the input with their places, one after the other.
class VertexComparison {
public:
    VertexComparison(const Rows& rows, const Surface& surface, const Reduction& reduction)
        : rows_(rows), surface_(surface), reduction_(reduction), difference_(static_cast<std::size_t>(rows.width())) {}

    /// Writes down the errors of a vertex, which may be none's.
    void compare(std::size_t vertex, std::vector<VertexErrors>& errors) {
        const MapPlace& place = reduction_.map.places[vertex];
        if (place.triangle == nowhere) return;
        const glm::dvec3 normal = subtract(surface_.first_copy(static_cast<std::uint32_t>(vertex)), place);
        for (const RowGroup& group : rows_.groups()) write(group, normal, vertex, errors[group.variable]);
    }

private:
    /// The row of a vertex less that of its place; returns the normal of the triangle there.
    glm::dvec3 subtract(std::uint32_t vertex, const MapPlace& place) {
        const glm::uvec3& triangle = reduction_.mesh.triangles[place.triangle];
        const auto input = [&](int corner) { return surface_.first_copy(reduction_.vertices[triangle[corner]]); };
        const double *row = rows_[vertex], *p = rows_[input(0)], *q = rows_[input(1)], *r = rows_[input(2)];
        const glm::dvec3 w = place.barycentric;
        for (std::size_t i = 0; i < difference_.size(); ++i)
            difference_[i] = row[i] - (w.x * p[i] + w.y * q[i] + w.z * r[i]);
        const glm::dvec3 origin = rows_.position(input(0));
        const glm::dvec3 area = glm::cross(rows_.position(input(1)) - origin, rows_.position(input(2)) - origin);
        const double length = glm::length(area);
        return length > 0 ? area / length : glm::dvec3(0);
    }

    void write(const RowGroup& group, const glm::dvec3& normal, std::size_t vertex, VertexErrors& out) const {
        const double unit = rows_.unit(group);
        const double* difference = &difference_[static_cast<std::size_t>(group.first)];
        double square = 0, along_normal = 0;
        for (int i = 0; i < group.count; ++i) {
            square += difference[i] * difference[i];
            if (group.variable == 0) along_normal -= difference[i] * normal[i];
        }
        out.error[vertex] = static_cast<float>(std::sqrt(square) * unit);
        if (group.variable == 0) out.signed_error[vertex] = static_cast<float>(along_normal * unit);
        else if (group.count == 1) out.signed_error[vertex] = static_cast<float>(*difference * unit);
    }

    const Rows& rows_;
    const Surface& surface_;
    const Reduction& reduction_;
    std::vector<double> difference_;
};

/// A run of so many vertices takes a fraction of a millisecond.
constexpr std::size_t vertices_at_once = 1024;

} // namespace

void extract_map(const Surface& surface, const Tracking& tracking, const std::vector<std::uint32_t>& renamed_vertex,
                 const std::vector<std::uint32_t>& renamed_triangle, SurfaceMap& map, Ticker& ticker) {
    map.places.assign(surface.input_count(), {});
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!ticker.tick(1)) return;
        if (surface.alive(slot)) place_residents(surface, tracking.map().residents, slot, renamed_triangle, map);
    }
    const CurrentEdges current(surface);
    const OriginalEdges& edges = tracking.map().edges;
    const Crossings& crossings = tracking.map().crossings;
    map.crossings.reserve(crossings_on(edges, crossings));
    for (std::uint32_t edge = 0; edge < edges.size() && ticker.tick(1); ++edge)
        for (std::uint32_t id = crossings.first(edge); id != no_index; id = crossings[id].next) {
            const Crossing& crossing = crossings[id];
            const auto& [lower, upper] = current.ends(crossing.current);
            map.crossings.push_back({{surface.input(edges.lower(edge)), surface.input(edges.upper(edge))},
                                     crossing.s,
                                     {renamed_vertex[lower], renamed_vertex[upper]},
                                     crossing.t,
                                     crossing.rightward});
        }
}

void extract_vertex_errors(const Rows& rows, const Surface& surface, const Reduction& reduction,
                           std::vector<VertexErrors>& errors, Team& team, Ticker& ticker) {
    const std::size_t vertices = reduction.map.places.size();
    errors.assign(rows.groups().size(), {});
    for (const RowGroup& group : rows.groups()) {
        errors[group.variable].error.resize(vertices, 0);
        if (group.count == 1 || group.variable == 0) errors[group.variable].signed_error.resize(vertices, 0);
    }
    team.gather();
    std::vector<VertexComparison> comparisons(team.size(), VertexComparison(rows, surface, reduction));
    share_out(team, ticker, vertices, vertices_at_once,
              [&](std::size_t member, std::size_t vertex) { comparisons[member].compare(vertex, errors); });
}

} // namespace meshbound
