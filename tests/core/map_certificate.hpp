#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meshbound/meshbound.hpp"

/// Checks a map that a reduction gives out, from the two meshes and the map alone: that it is continuous, and what its
/// largest errors are. The guarantee follows without any trust in how the map came about.
namespace certificate {

using meshbound::MapCrossing;
using meshbound::Mesh;
using meshbound::Reduction;
using meshbound::SurfacePoint;
using meshbound::VariableView;
using Edge = std::pair<std::uint32_t, std::uint32_t>; // lower vertex first

/// Of barycentric coordinates, some units in the last place.
inline constexpr double rounding = 1e-15;

inline Edge edge(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

/// A step on the way of an original triangle's outline through the reduced mesh: over an edge, or to a kept vertex.
struct Step {
    Edge crossed{0, 0};
    std::uint32_t vertex = 0;
    bool is_vertex = false;
    bool touches(const Step& kept) const { return crossed.first == kept.vertex || crossed.second == kept.vertex; }
};

/// Whether the image of an original triangle's outline can be filled so that every cell lies in one reduced triangle. The
/// outline is a cycle of steps. Two steps over the same edge with nothing but kept vertices between them cut off a cell; so
/// do a step over an edge and a kept vertex at its end. What is left when all such cells are cut off must be one cell more.
inline bool can_be_filled(std::vector<Step> steps) {
    const auto cut_off = [&steps](std::size_t i) {
        const std::size_t n = steps.size();
        for (const std::size_t direction : {std::size_t{1}, n - 1}) {
            std::size_t j = (i + direction) % n;
            for (; j != i && steps[j].is_vertex; j = (j + direction) % n)
                if (steps[i].touches(steps[j])) {
                    steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(i));
                    return true;
                }
            if (j == i || steps[j].crossed != steps[i].crossed) continue;
            steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
            steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(std::min(i, j)));
            return true;
        }
        return false;
    };
    for (std::size_t i = 0; i < steps.size();) i = !steps[i].is_vertex && cut_off(i) ? 0 : i + 1;
    return std::all_of(steps.begin(), steps.end(), [](const Step& step) { return step.is_vertex; });
}

class Certificate {
public:
    Certificate(const Mesh& mesh, const Reduction& reduction) : mesh_(mesh), reduction_(reduction) {
        for (const glm::uvec3& t : mesh.triangles)
            for (int i = 0; i < 3; ++i) ++original_edges_[edge(t[i], t[(i + 1) % 3])];
        for (std::uint32_t t = 0; t < reduction.mesh.triangles.size(); ++t) {
            const glm::uvec3& corners = reduction.mesh.triangles[t];
            for (int i = 0; i < 3; ++i) reduced_edges_[edge(corners[i], corners[(i + 1) % 3])].insert(t);
        }
        for (const MapCrossing& crossing : reduction.map.crossings)
            crossings_[edge(crossing.original.x, crossing.original.y)].push_back(crossing);
        for (std::uint32_t v = 0; v < reduction.vertices.size(); ++v) kept_[reduction.vertices[v]] = v;
    }

    /// What speaks against the map being continuous and keeping the boundary: nothing, if all is well.
    std::vector<std::string> faults() const {
        std::vector<std::string> faults;
        check_places(faults);
        check_crossings(faults);
        if (!faults.empty()) return faults; // what follows relies on sound places and crossings
        for (const auto& [original, uses] : original_edges_) check_walk(original, faults);
        for (const glm::uvec3& t : mesh_.triangles) check_filling(t, faults);
        return faults;
    }

    /// The largest error of each variable, position first, over all corners of the map: so over the whole surface.
    std::vector<double> largest_errors() const {
        std::vector<double> errors(1 + mesh_.variables.size(), 0);
        for (std::size_t i = 0; i < errors.size(); ++i) {
            for (std::uint32_t v = 0; v < reduction_.map.images.size(); ++v)
                if (reduction_.map.images[v].triangle != meshbound::nowhere)
                    errors[i] = std::max(errors[i], error_at_vertex(i, v));
            for (const MapCrossing& crossing : reduction_.map.crossings)
                errors[i] = std::max(errors[i], error_at_crossing(i, crossing));
        }
        return errors;
    }

    double error_at_vertex(std::size_t variable, std::uint32_t vertex) const {
        const SurfacePoint& place = reduction_.map.images[vertex];
        const glm::uvec3& t = reduction_.mesh.triangles[place.triangle];
        return length(variable, [&](int c) {
            double mapped = 0;
            for (int i = 0; i < 3; ++i) mapped += place.barycentric[i] * value_at(reduced(variable), t[i], c);
            return value_at(original(variable), vertex, c) - mapped;
        });
    }

    double error_at_crossing(std::size_t variable, const MapCrossing& x) const {
        const auto between = [](const VariableView& of, glm::uvec2 ends, double share, int c) {
            return (1 - share) * value_at(of, ends.x, c) + share * value_at(of, ends.y, c);
        };
        return length(variable, [&](int c) {
            return between(original(variable), x.original, x.s, c) - between(reduced(variable), x.reduced, x.t, c);
        });
    }

private:
    VariableView original(std::size_t i) const { return variable_of(mesh_, i); }
    VariableView reduced(std::size_t i) const { return variable_of(reduction_.mesh, i); }
    template <class Difference>
    double length(std::size_t variable, const Difference& difference) const {
        double square = 0;
        for (int c = 0; c < original(variable).components; ++c) square += difference(c) * difference(c);
        return std::sqrt(square);
    }
    bool is_boundary(const Edge& of_original) const { return original_edges_.at(of_original) == 1; }
    std::vector<MapCrossing> crossings(const Edge& original) const {
        const auto found = crossings_.find(original);
        return found == crossings_.end() ? std::vector<MapCrossing>{} : found->second;
    }

    /// The reduced triangles that contain the image of a vertex: one inside, two on an edge, the star of a kept one.
    std::set<std::uint32_t> triangles_at(std::uint32_t vertex) const {
        const SurfacePoint& place = reduction_.map.images[vertex];
        std::set<std::uint32_t> found = {place.triangle};
        const glm::uvec3& t = reduction_.mesh.triangles[place.triangle];
        if (const auto kept = kept_.find(vertex); kept != kept_.end())
            for (const auto& [ends, triangles] : reduced_edges_)
                if (ends.first == kept->second || ends.second == kept->second)
                    found.insert(triangles.begin(), triangles.end());
        for (int i = 0; i < 3; ++i)
            if (place.barycentric[i] == 0) {
                const auto& both = reduced_edges_.at(edge(t[(i + 1) % 3], t[(i + 2) % 3]));
                found.insert(both.begin(), both.end());
            }
        return found;
    }

    static std::string named(const char* what, std::uint32_t a) { return what + std::to_string(a); }
    static std::string named(const char* what, const Edge& e) {
        return named(what, e.first) + "-" + std::to_string(e.second);
    }

    /// Each used vertex has a place inside a triangle; a kept one in its own corner.
    void check_places(std::vector<std::string>& faults) const {
        std::set<std::uint32_t> used;
        for (const glm::uvec3& t : mesh_.triangles) used.insert({t.x, t.y, t.z});
        if (reduction_.map.images.size() != vertex_count(mesh_)) faults.push_back("not one place a vertex");
        for (std::uint32_t v = 0; v < reduction_.map.images.size(); ++v) {
            const SurfacePoint& place = reduction_.map.images[v];
            if (!used.count(v) && place.triangle == meshbound::nowhere) continue;
            if (!used.count(v) || place.triangle >= reduction_.mesh.triangles.size()) {
                faults.push_back(named("a wrong triangle for vertex ", v));
                continue;
            }
            const glm::dvec3& w = place.barycentric;
            if (std::min({w.x, w.y, w.z}) < -rounding || std::abs(w.x + w.y + w.z - 1) > rounding)
                faults.push_back(named("outside its triangle: vertex ", v));
            if (const auto kept = kept_.find(v); kept != kept_.end() && !is_at_corner(place, kept->second))
                faults.push_back(named("away from itself: kept vertex ", v));
        }
    }

    bool is_at_corner(const SurfacePoint& place, std::uint32_t reduced_vertex) const {
        const glm::uvec3& t = reduction_.mesh.triangles[place.triangle];
        for (int i = 0; i < 3; ++i)
            if (t[i] == reduced_vertex && place.barycentric[i] == 1) return true;
        return false;
    }

    /// Each crossing is one of an inner edge of the input with one of the reduced mesh, in order, inside both.
    void check_crossings(std::vector<std::string>& faults) const {
        for (const auto& [original, list] : crossings_) {
            const auto found = original_edges_.find(original);
            if (found == original_edges_.end() || found->second != 2)
                faults.push_back(named("crossings of what is no inner edge: ", original));
            double last = 0;
            for (const MapCrossing& x : list) {
                const Edge crossed = edge(x.reduced.x, x.reduced.y);
                const auto reduced = reduced_edges_.find(crossed);
                if (reduced == reduced_edges_.end() || reduced->second.size() != 2)
                    faults.push_back(named("crossing of what is no inner edge of the result: ", crossed));
                if (!(last <= x.s && x.s <= 1)) faults.push_back(named("crossings out of order on edge ", original));
                if (!(0 <= x.t && x.t <= 1)) faults.push_back(named("crossing beyond the end of edge ", crossed));
                last = x.s;
            }
        }
    }

    /// From triangle to neighbouring triangle an original edge gets from the place of its one end to that of the other; a
    /// boundary edge stays on a boundary edge.
    void check_walk(const Edge& original, std::vector<std::string>& faults) const {
        std::set<std::uint32_t> here = triangles_at(original.first);
        for (const MapCrossing& x : crossings(original)) {
            const auto& pair = reduced_edges_.at(edge(x.reduced.x, x.reduced.y));
            std::set<std::uint32_t> next;
            for (const std::uint32_t t : pair)
                for (const std::uint32_t other : pair)
                    if (t != other && here.count(t)) next.insert(other);
            if (next.empty()) return faults.push_back(named("a jump of edge ", original));
            here = next;
        }
        const std::set<std::uint32_t> end = triangles_at(original.second);
        if (std::none_of(here.begin(), here.end(), [&end](std::uint32_t t) { return end.count(t) > 0; }))
            faults.push_back(named("no arrival of edge ", original));
        if (is_boundary(original) && !stays_on_boundary(original))
            faults.push_back(named("off the boundary: edge ", original));
    }

    bool stays_on_boundary(const Edge& original) const {
        return std::any_of(reduced_edges_.begin(), reduced_edges_.end(), [&](const auto& reduced) {
            return reduced.second.size() == 1 && lies_on(original.first, reduced.first) &&
                   lies_on(original.second, reduced.first);
        });
    }

    bool lies_on(std::uint32_t vertex, const Edge& reduced) const {
        const SurfacePoint& place = reduction_.map.images[vertex];
        const glm::uvec3& t = reduction_.mesh.triangles[place.triangle];
        double on = 0;
        for (int i = 0; i < 3; ++i)
            if (t[i] == reduced.first || t[i] == reduced.second) on += place.barycentric[i];
        return std::abs(on - 1) <= rounding;
    }

    void check_filling(const glm::uvec3& triangle, std::vector<std::string>& faults) const {
        std::vector<Step> outline;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
            if (const auto kept = kept_.find(from); kept != kept_.end())
                outline.push_back({{0, 0}, kept->second, true});
            std::vector<MapCrossing> along = crossings(edge(from, to));
            if (from > to) std::reverse(along.begin(), along.end());
            for (const MapCrossing& x : along) outline.push_back({edge(x.reduced.x, x.reduced.y), 0, false});
        }
        if (!can_be_filled(std::move(outline)))
            faults.push_back(named("a tear in the triangle of edge ", Edge{triangle.x, triangle.y}));
    }

    const Mesh& mesh_;
    const Reduction& reduction_;
    std::map<Edge, int> original_edges_;                    // how many triangles
    std::map<Edge, std::set<std::uint32_t>> reduced_edges_; // which triangles
    std::map<Edge, std::vector<MapCrossing>> crossings_;    // by original edge
    std::map<std::uint32_t, std::uint32_t> kept_;           // reduced vertex by original vertex
};

} // namespace certificate
