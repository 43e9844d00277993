#include "segmentation/check_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/kept_vertices.hpp"
#include "mesh/repeats_vertex.hpp"
#include "meshbound/validate.hpp"
#include "segmentation/face_lookup.hpp"
#include "util/number_text.hpp"

namespace meshbound {
namespace {

Status bad_map(const std::string& message, std::size_t index) { return {Fault::bad_map, message, "", index}; }

std::string text(std::size_t count) { return std::to_string(count); }

std::string text(const glm::uvec2& edge) { return std::to_string(edge.x) + "-" + std::to_string(edge.y); }

Status check_surface(const char* which, const Mesh& mesh) {
    Status status = validate(mesh);
    if (!status.ok()) status.message = std::string("Of the ") + which + ": " + status.message;
    return status;
}

Status check_counts(const MappedSurfaces& surfaces) {
    const std::size_t original = vertex_count(surfaces.original), reduced = vertex_count(surfaces.reduced);
    const std::size_t places = surfaces.map.images.size(), vertices = surfaces.vertices.size();
    if (places != original)
        return {Fault::bad_map,
                "The map has " + text(places) + " images, but the original has " + text(original) +
                    " vertices; there must be one for each.",
                "",
                {}};
    if (vertices != reduced)
        return {Fault::bad_map,
                "The reduced mesh has " + text(reduced) + " vertices, but it is said of " + text(vertices) +
                    " where they come from.",
                "",
                {}};
    return {};
}

Status check_vertices(const MappedSurfaces& surfaces) {
    return check_kept_vertices("the reduced mesh", surfaces.vertices, surfaces.map.images.size(), Fault::bad_map);
}

/// NaN fails.
bool is_share(double value) { return value >= -rounding_of_shares && value <= 1 + rounding_of_shares; }

bool are_shares(const glm::dvec3& w) {
    return is_share(w.x) && is_share(w.y) && is_share(w.z) && std::abs(w.x + w.y + w.z - 1) <= rounding_of_shares;
}

Status check_places(const MappedSurfaces& surfaces) {
    const std::size_t triangles = surfaces.reduced.triangles.size();
    for (std::size_t v = 0; v < surfaces.map.images.size(); ++v) {
        const auto& [triangle, w] = surfaces.map.images[v];
        if (triangle == nowhere) continue;
        if (triangle >= triangles)
            return bad_map("The map puts vertex " + text(v) + " into triangle " + text(triangle) +
                               ", but the reduced mesh has " + text(triangles) + " triangles (counted from 0).",
                           v);
        if (!are_shares(w))
            return bad_map("The map puts vertex " + text(v) + " at the barycentric coordinates " + number_text(w.x) +
                               ", " + number_text(w.y) + ", " + number_text(w.z) +
                               "; they must lie between 0 and 1 and add up to 1.",
                           v);
    }
    return {};
}

bool is_at_corner(const MappedSurfaces& surfaces, const SurfacePoint& place, std::uint32_t reduced_vertex) {
    if (place.triangle == nowhere) return false;
    const glm::uvec3& triangle = surfaces.reduced.triangles[place.triangle];
    for (int i = 0; i < 3; ++i)
        if (triangle[i] == reduced_vertex && place.barycentric[i] == 1) return true;
    return false;
}

/// A kept vertex is mapped to itself.
Status check_kept(const MappedSurfaces& surfaces) {
    for (std::uint32_t v = 0; v < surfaces.vertices.size(); ++v) {
        const std::uint32_t vertex = surfaces.vertices[v];
        if (!is_at_corner(surfaces, surfaces.map.images[vertex], v))
            return bad_map("The map puts vertex " + text(vertex) + " elsewhere than at vertex " + text(v) +
                               " of the reduced mesh, which is said to be the same.",
                           vertex);
    }
    return {};
}

/// A triangle is mapped as a whole, or not at all where its component was dropped.
Status check_triangles(const MappedSurfaces& surfaces) {
    const std::vector<glm::uvec3>& triangles = surfaces.original.triangles;
    const auto is_mapped = [&](std::uint32_t vertex) { return surfaces.map.images[vertex].triangle != nowhere; };
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (repeats_vertex(triangles[t])) continue;
        const bool first = is_mapped(triangles[t].x);
        if (is_mapped(triangles[t].y) != first || is_mapped(triangles[t].z) != first)
            return bad_map("The map has images for some vertices of triangle " + text(t) + " and none for others.", t);
    }
    return {};
}

bool is_inner_edge(const FaceLookup& faces, const glm::uvec2& edge) {
    return faces.left_of(edge.x, edge.y) != nowhere && faces.left_of(edge.y, edge.x) != nowhere;
}

/// What is wrong with a crossing; nothing, if all is well.
std::string fault_of_crossing(const MappedSurfaces& surfaces, const FaceLookup& faces, std::size_t n) {
    const std::vector<MapCrossing>& crossings = surfaces.map.crossings;
    const MapCrossing& here = crossings[n];
    const std::size_t vertices = surfaces.map.images.size();
    if (here.original.x >= here.original.y || here.original.y >= vertices)
        return "on the edge " + text(here.original) + " of the original, which has " + text(vertices) +
               " vertices (counted from 0); the lower one comes first";
    if (!is_inner_edge(faces, here.reduced))
        return "on the edge " + text(here.reduced) + ", which is not one between two triangles of the reduced mesh";
    if (!(here.s >= 0 && here.s <= 1 && here.t >= 0 && here.t <= 1))
        return "at " + number_text(here.s) + " of the original's edge and at " + number_text(here.t) +
               " of the reduced one; both must be 0 to 1";
    if (n > 0 && here.original == crossings[n - 1].original && here.s < crossings[n - 1].s)
        return "at " + number_text(here.s) + " of the edge " + text(here.original) + ", but the one before at " +
               number_text(crossings[n - 1].s) + "; they must rise";
    return "";
}

Status check_crossings(const MappedSurfaces& surfaces) {
    const FaceLookup faces(surfaces.reduced);
    for (std::size_t n = 0; n < surfaces.map.crossings.size(); ++n)
        if (const std::string fault = fault_of_crossing(surfaces, faces, n); !fault.empty())
            return bad_map("Crossing " + text(n) + " of the map lies " + fault + ".", n);
    return {};
}

bool is_same(const VariableView& one, const VariableView& other) {
    return one.name == other.name && one.components == other.components && one.values.index() == other.values.index();
}

Status other_variable(const VariableView& variable) {
    const std::string name(variable.name);
    return {Fault::bad_map,
            "The reduced mesh does not carry “" + name +
                "” as the original does: in the same place, with the same components and in the same precision.",
            name,
            {}};
}

} // namespace

Status check_map(const MappedSurfaces& surfaces) {
    Status status = check_surface("original", surfaces.original);
    if (status.ok()) status = check_surface("reduced mesh", surfaces.reduced);
    for (const auto check : {check_counts, check_vertices, check_places, check_kept, check_triangles, check_crossings})
        if (status.ok()) status = check(surfaces);
    return status;
}

Status check_crossings_met(const MappedSurfaces& surfaces, const Segmentation& segmentation) {
    const std::size_t vertices = surfaces.map.images.size();
    std::vector<bool> met(surfaces.map.crossings.size(), false);
    for (const std::uint32_t corner : segmentation.corners)
        if (corner >= vertices) met[corner - vertices] = true;
    const auto missed = static_cast<std::size_t>(std::find(met.begin(), met.end(), false) - met.begin());
    if (missed == met.size()) return {};
    return bad_map("Crossing " + text(missed) + " of the map lies on the edge " +
                       text(surfaces.map.crossings[missed].original) +
                       ", which no mapped triangle of the original has.",
                   missed);
}

Status check_same_variables(const MappedSurfaces& surfaces) {
    const Mesh &original = surfaces.original, &reduced = surfaces.reduced;
    for (std::size_t i = 0; i < variable_count(original); ++i)
        if (i >= variable_count(reduced) || !is_same(variable_of(original, i), variable_of(reduced, i)))
            return other_variable(variable_of(original, i));
    return {};
}

} // namespace meshbound
