#include "errors/tracked/map_output.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "util/parallel_for.hpp"

namespace meshbound {
namespace {

/// The point at `share` along half-edge h, in the triangle of h.
SurfacePoint point_on_edge(std::uint32_t h, double share, const std::vector<std::uint32_t>& reduced_triangle) {
    SurfacePoint point{reduced_triangle[Surface::triangle_of(h)], glm::dvec3(0)};
    point.barycentric[static_cast<int>(h % 3)] = 1 - share;
    point.barycentric[static_cast<int>(Surface::next(h) % 3)] = share;
    return point;
}

/// The least weight of either end for a vertex mapped onto an edge; it vanishes beside 1. So exactly one weight is 0,
/// that of the corner opposite to the edge, even where the share was rounded to 0 or 1.
constexpr double least_weight = 1e-300;

/// The image of a vertex that is mapped onto the edge of half-edge h.
SurfacePoint point_inside_edge(std::uint32_t h, double share, const std::vector<std::uint32_t>& reduced_triangle) {
    SurfacePoint point = point_on_edge(h, share, reduced_triangle);
    for (const std::uint32_t end : {h, Surface::next(h)}) {
        double& weight = point.barycentric[static_cast<int>(end % 3)];
        weight = std::max(weight, least_weight);
    }
    return point;
}

void write_mapped_vertices(const Surface& surface, const MappedVertices& mapped_vertices, std::uint32_t slot,
                           const std::vector<std::uint32_t>& reduced_triangle, SurfaceMap& map) {
    for (std::uint32_t v = mapped_vertices.in_triangle(slot); v != no_index; v = mapped_vertices.next(v))
        map.images[surface.input(v)] = {reduced_triangle[slot], mapped_vertices.barycentric(v)};
    for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h) {
        map.images[surface.input(surface.origin(h))] = point_on_edge(h, 0, reduced_triangle);
        const bool canonical = surface.origin(h) < surface.target(h);
        for (std::uint32_t v = mapped_vertices.on_edge(surface.edge(h)); v != no_index; v = mapped_vertices.next(v))
            map.images[surface.input(v)] = point_inside_edge(
                h, canonical ? mapped_vertices.share(v) : 1 - mapped_vertices.share(v), reduced_triangle);
    }
}

/// The ends of the current edges, which are few among the numbers of the original edges.
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

std::size_t count_crossings(const OriginalEdges& edges, const Crossings& crossings) {
    std::size_t count = 0;
    for (std::uint32_t edge = 0; edge < edges.size(); ++edge)
        for (std::uint32_t id = crossings.first(edge); id != no_index; id = crossings[id].next) ++count;
    return count;
}

/// Compares input vertices with their images, one after the other.
class VertexComparison {
public:
    VertexComparison(const Rows& rows, const Surface& surface, const Reduction& reduction)
        : rows_(rows), surface_(surface), reduction_(reduction), difference_(static_cast<std::size_t>(rows.width())) {}

    /// Writes down the errors of a vertex; nothing where it is in no triangle.
    void compare(std::size_t vertex, std::vector<VertexErrors>& errors) {
        const SurfacePoint& point = reduction_.map.images[vertex];
        if (point.triangle == nowhere) return;
        const glm::dvec3 normal = subtract(surface_.first_vertex_of(static_cast<std::uint32_t>(vertex)), point);
        for (const RowGroup& group : rows_.groups()) write(group, normal, vertex, errors[group.variable]);
    }

private:
    /// The row of a vertex less that of its image; returns the normal of the triangle there.
    glm::dvec3 subtract(std::uint32_t vertex, const SurfacePoint& point) {
        const glm::uvec3& triangle = reduction_.mesh.triangles[point.triangle];
        const auto input = [&](int corner) { return surface_.first_vertex_of(reduction_.vertices[triangle[corner]]); };
        const double *row = rows_[vertex], *p = rows_[input(0)], *q = rows_[input(1)], *r = rows_[input(2)];
        const glm::dvec3 w = point.barycentric;
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

/// So many vertices take a fraction of a millisecond.
constexpr std::size_t vertices_per_chunk = 1024;

} // namespace

void extract_map(const Surface& surface, const Tracking& tracking, const std::vector<std::uint32_t>& reduced_vertex,
                 const std::vector<std::uint32_t>& reduced_triangle, SurfaceMap& map, ProgressReporter& reporter) {
    map.images.assign(surface.input_count(), {});
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!reporter.advance(1)) return;
        if (surface.alive(slot))
            write_mapped_vertices(surface, tracking.map().mapped_vertices, slot, reduced_triangle, map);
    }
    const CurrentEdges current(surface);
    const OriginalEdges& edges = tracking.map().edges;
    const Crossings& crossings = tracking.map().crossings;
    map.crossings.reserve(count_crossings(edges, crossings));
    for (std::uint32_t edge = 0; edge < edges.size() && reporter.advance(1); ++edge)
        for (std::uint32_t id = crossings.first(edge); id != no_index; id = crossings[id].next) {
            const Crossing& crossing = crossings[id];
            const auto& [lower, upper] = current.ends(crossing.current);
            map.crossings.push_back({{surface.input(edges.lower(edge)), surface.input(edges.upper(edge))},
                                     crossing.s,
                                     {reduced_vertex[lower], reduced_vertex[upper]},
                                     crossing.t,
                                     crossing.rightward});
        }
}

void extract_vertex_errors(const Rows& rows, const Surface& surface, const Reduction& reduction,
                           std::vector<VertexErrors>& errors, ThreadPool& pool, ProgressReporter& reporter) {
    const std::size_t vertices = reduction.map.images.size();
    errors.assign(rows.groups().size(), {});
    for (const RowGroup& group : rows.groups()) {
        errors[group.variable].error.resize(vertices, 0);
        if (group.count == 1 || group.variable == 0) errors[group.variable].signed_error.resize(vertices, 0);
    }
    pool.start();
    std::vector<VertexComparison> comparisons(pool.size(), VertexComparison(rows, surface, reduction));
    parallel_for(pool, reporter, vertices, vertices_per_chunk,
                 [&](std::size_t worker, std::size_t vertex) { comparisons[worker].compare(vertex, errors); });
}

} // namespace meshbound
