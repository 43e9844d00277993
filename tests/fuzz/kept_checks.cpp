#include "fuzz/kept_checks.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fuzz/checks.hpp"
#include "meshes/shapes.hpp"

namespace fuzz {
namespace {

using namespace meshbound;
using Corners = std::multiset<std::uint32_t>;
using Place = std::vector<double>;

bool is_proper(const glm::uvec3& t) { return t.x != t.y && t.y != t.z && t.z != t.x; }

Place place_of(const Mesh& mesh, std::uint32_t vertex) {
    return {value_at(mesh.position, vertex, 0), value_at(mesh.position, vertex, 1), value_at(mesh.position, vertex, 2)};
}

std::set<std::uint32_t> used_vertices(const Mesh& mesh) {
    std::set<std::uint32_t> used;
    for (const glm::uvec3& t : mesh.triangles)
        if (is_proper(t)) used.insert({t.x, t.y, t.z});
    return used;
}

/// By vertex a number that all have that hang together over triangles and places.
std::vector<std::uint32_t> find_parts(const Mesh& mesh) {
    std::vector<std::uint32_t> parts(vertex_count(mesh));
    std::iota(parts.begin(), parts.end(), 0U);
    std::map<Place, std::uint32_t> first_there;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const std::uint32_t v : used_vertices(mesh))
        pairs.emplace_back(v, first_there.try_emplace(place_of(mesh, v), v).first->second);
    for (const glm::uvec3& t : mesh.triangles)
        if (is_proper(t)) pairs.insert(pairs.end(), {{t.x, t.y}, {t.y, t.z}});
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& [a, b] : pairs) {
            const std::uint32_t lower = std::min(parts[a], parts[b]);
            changed = changed || parts[a] != parts[b];
            parts[a] = parts[b] = lower;
        }
    }
    return parts;
}

/// A part may go if its box is within the bound of position times the least multiplier in it, and nothing in it is locked.
bool may_go(const Mesh& mesh, const Options& options, double bound, const std::vector<std::uint32_t>& vertices) {
    glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest = -lowest;
    double multiplier = options.bound_multiplier.empty() ? 1 : std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : vertices) {
        if (std::find(options.locked.begin(), options.locked.end(), v) != options.locked.end()) return false;
        lowest = glm::min(lowest, meshes::point(mesh, v));
        highest = glm::max(highest, meshes::point(mesh, v));
        if (!options.bound_multiplier.empty()) multiplier = std::min(multiplier, value_at(mesh.variables.back(), v, 0));
    }
    return glm::distance(lowest, highest) <= multiplier * bound;
}

bool is_in(const Mesh& mesh, const glm::uvec3& t, const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const double a = value_at(mesh.position, t.x, axis), b = value_at(mesh.position, t.y, axis),
                     c = value_at(mesh.position, t.z, axis);
        if (std::max({a, b, c}) < box.lowest[axis] || box.highest[axis] < std::min({a, b, c})) return false;
    }
    return true;
}

bool is_locked(const Mesh& mesh, const Options& options, std::size_t t) {
    const auto meets = [&](const Box& box) { return is_in(mesh, mesh.triangles[t], box); };
    if (std::any_of(options.locked_boxes.begin(), options.locked_boxes.end(), meets)) return true;
    const std::vector<std::int32_t>& regions = options.locked_regions;
    return !mesh.regions.empty() && std::find(regions.begin(), regions.end(), mesh.regions[t]) != regions.end();
}

std::map<std::uint32_t, std::set<std::int32_t>> labels_at_vertices(const Mesh& mesh) {
    std::map<std::uint32_t, std::set<std::int32_t>> labels;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (is_proper(mesh.triangles[t]))
            for (int i = 0; i < 3; ++i) labels[mesh.triangles[t][i]].insert(mesh.regions[t]);
    return labels;
}

/// Edges of one triangle each.
std::vector<std::pair<std::uint32_t, std::uint32_t>> boundary_edges(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles;
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) ++triangles[std::minmax(t[i], t[(i + 1) % 3])];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const auto& [edge, count] : triangles)
        if (count == 1) found.push_back(edge);
    return found;
}

} // namespace

Mesh without_dropped(const Mesh& mesh, const Options& options, const Reduction& reduction) {
    const std::vector<std::uint32_t> part = find_parts(mesh);
    std::set<std::uint32_t> left;
    for (const std::uint32_t vertex : reduction.vertices) left.insert(part[vertex]);
    std::map<std::uint32_t, std::vector<std::uint32_t>> dropped;
    for (const std::uint32_t vertex : used_vertices(mesh))
        if (!left.count(part[vertex])) dropped[part[vertex]].push_back(vertex);
    require(dropped.empty() || options.drop_small_components, "parts go only when asked for");
    require(dropped.size() == reduction.report.dropped.components, "dropped parts are counted");
    for (const auto& [name, vertices] : dropped)
        require(may_go(mesh, options, reduction.report.variables[0].bound.absolute, vertices), "only small parts go");
    Mesh rest = mesh;
    rest.triangles.clear();
    rest.regions.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!is_proper(mesh.triangles[t]) || !left.count(part[mesh.triangles[t].x])) continue;
        rest.triangles.push_back(mesh.triangles[t]);
        if (!mesh.regions.empty()) rest.regions.push_back(mesh.regions[t]);
    }
    return rest;
}

void check_locks(const Mesh& mesh, const Options& options, const Reduction& reduction) {
    const std::set<std::uint32_t> used = used_vertices(mesh);
    for (const std::uint32_t vertex : options.locked)
        require(!used.count(vertex) || std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), vertex),
                "locked vertices stay");
    std::multiset<Corners> left;
    const std::vector<std::uint32_t>& v = reduction.vertices;
    for (const glm::uvec3& t : reduction.mesh.triangles) left.insert({v[t.x], v[t.y], v[t.z]});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& corners = mesh.triangles[t];
        if (!is_proper(corners) || !is_locked(mesh, options, t)) continue;
        const auto found = left.find({corners.x, corners.y, corners.z});
        require(found != left.end(), "locked triangles stay");
        left.erase(found);
    }
}

void check_labels(const Mesh& mesh, const Reduction& reduction) {
    if (mesh.regions.empty()) return;
    require(reduction.mesh.regions.size() == reduction.mesh.triangles.size(), "every triangle has a label");
    const auto before = labels_at_vertices(mesh);
    for (const auto& [vertex, labels] : labels_at_vertices(reduction.mesh))
        require(labels == before.at(reduction.vertices[vertex]), "vertices keep their labels");
}

void check_seams(const Mesh& mesh, const Reduction& reduction) {
    const auto stays = [&](std::uint32_t vertex) {
        return std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), vertex);
    };
    std::map<std::set<Place>, std::map<Place, std::uint32_t>> sides;
    for (const auto& [a, b] : boundary_edges(mesh)) {
        const Place from = place_of(mesh, a), to = place_of(mesh, b);
        if (from == to) continue;
        const auto& one =
            sides.try_emplace({from, to}, std::map<Place, std::uint32_t>{{from, a}, {to, b}}).first->second;
        require(stays(a) == stays(one.at(from)) && stays(b) == stays(one.at(to)), "seams stay together");
    }
}

} // namespace fuzz
