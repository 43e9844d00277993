#include "meshbound/segmentation.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "orientation.hpp"
#include "oriented_segmentation.hpp"
#include "segmentation_cutting.hpp"
#include "segmentation_faces.hpp"
#include "segmentation_outline.hpp"
#include "segmentation_pieces.hpp"
#include "ticker.hpp"

namespace meshbound {
namespace {

/// Barycentric coordinates of the place at `share` along an edge of a triangle.
glm::dvec3 place_on_edge(const glm::uvec3& triangle, const glm::uvec2& edge, double share) {
    glm::dvec3 place(0);
    for (int i = 0; i < 3; ++i) {
        if (triangle[i] == edge.x) place[i] = 1 - share;
        if (triangle[i] == edge.y) place[i] = share;
    }
    return place;
}

glm::dvec3 place_at_vertex(const glm::uvec3& triangle, std::uint32_t vertex) {
    return place_on_edge(triangle, {vertex, vertex}, 1);
}

double area(const Mesh& mesh, const glm::uvec3& triangle) {
    const auto point = [&](int corner) {
        return glm::dvec3(value_at(mesh.position, triangle[corner], 0), value_at(mesh.position, triangle[corner], 1),
                          value_at(mesh.position, triangle[corner], 2));
    };
    return glm::length(glm::cross(point(1) - point(0), point(2) - point(0))) / 2;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3& triangle : mesh.triangles) sum += area(mesh, triangle);
    return sum;
}

bool repeats_vertex(const glm::uvec3& triangle) {
    return triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x;
}

bool cut_into_cells(const MappedSurfaces& surfaces, Segmentation& segmentation, Ticker& ticker) {
    const std::vector<glm::uvec3>& triangles = surfaces.original.triangles;
    const Faces faces(surfaces.reduced);
    const Outlines outlines(surfaces, faces);
    CellCutter cutter(faces, surfaces.original.regions);
    Outline outline;
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (repeats_vertex(triangles[triangle])) continue;
        if (surfaces.map.places[triangles[triangle].x].triangle == nowhere) continue; // of a part that was left out
        outlines.trace(triangle, outline);
        cutter.cut(triangle, outline, segmentation);
        if (!ticker.tick(1, 0.5 * triangle / static_cast<double>(triangles.size()))) return false;
    }
    return true;
}

/// Triangulates all cells and adds up what is folded.
bool cut_into_pieces(const MappedSurfaces& surfaces, Segmentation& segmentation, Ticker& ticker) {
    CellTriangulation triangulation;
    std::vector<CellPlace> places;
    double folded_original = 0, folded_reduced = 0;
    for (SegmentationCell& cell : segmentation.cells) {
        cell.first_piece = static_cast<std::uint32_t>(segmentation.pieces.size());
        const std::uint32_t* corners = &segmentation.corners[cell.first_corner];
        places.clear();
        for (std::uint32_t i = 0; i < cell.corner_count; ++i)
            places.push_back(
                {place_in_original(surfaces, cell, corners[i]), place_in_reduced(surfaces, cell, corners[i])});
        const std::size_t folded_before = segmentation.folded_pieces;
        triangulation.for_each_piece(places, [&](std::size_t i, std::size_t j, std::size_t k) {
            segmentation.pieces.push_back({corners[i], corners[j], corners[k]});
            const PieceShares shares = piece_shares(places[i], places[j], places[k]);
            if (!shares.folded()) return;
            ++segmentation.folded_pieces;
            folded_original += shares.original * area(surfaces.original, surfaces.original.triangles[cell.original]);
            folded_reduced -= shares.reduced * area(surfaces.reduced, surfaces.reduced.triangles[cell.reduced]);
        });
        if (segmentation.folded_pieces > folded_before) ++segmentation.folded_cells;
        const auto done = static_cast<double>(cell.first_corner) / static_cast<double>(segmentation.corners.size());
        if (!ticker.tick(1, 0.5 + 0.5 * done)) return false;
    }
    if (folded_original > 0) segmentation.folded_original = folded_original / area(surfaces.original);
    if (folded_reduced > 0) segmentation.folded_reduced = folded_reduced / area(surfaces.reduced);
    return true;
}

} // namespace

glm::dvec3 place_in_original(const MappedSurfaces& surfaces, const SegmentationCell& cell, std::uint32_t corner) {
    const glm::uvec3& triangle = surfaces.original.triangles[cell.original];
    const std::size_t vertices = surfaces.map.places.size();
    if (corner < vertices) return place_at_vertex(triangle, corner);
    const MapCrossing& crossing = surfaces.map.crossings[corner - vertices];
    return place_on_edge(triangle, crossing.original, crossing.s);
}

glm::dvec3 place_in_reduced(const MappedSurfaces& surfaces, const SegmentationCell& cell, std::uint32_t corner) {
    const glm::uvec3& triangle = surfaces.reduced.triangles[cell.reduced];
    const std::size_t vertices = surfaces.map.places.size();
    if (corner >= vertices) {
        const MapCrossing& crossing = surfaces.map.crossings[corner - vertices];
        return place_on_edge(triangle, crossing.reduced, crossing.t);
    }
    const auto kept = std::lower_bound(surfaces.vertices.begin(), surfaces.vertices.end(), corner);
    if (kept == surfaces.vertices.end() || *kept != corner) {
        const MapPlace& place = surfaces.map.places[corner];
        if (place.triangle == cell.reduced) return place.barycentric;
        // On a curve, and named in a triangle of another sheet than the cell's.
        glm::dvec3 here(0);
        for (int i = 0; i < 3; ++i)
            here += place.barycentric[i] * place_at_vertex(triangle, surfaces.reduced.triangles[place.triangle][i]);
        return here;
    }
    return place_at_vertex(triangle, static_cast<std::uint32_t>(kept - surfaces.vertices.begin()));
}

void segment_oriented(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress) {
    segmentation = {};
    if (surfaces.map.places.empty()) return;
    Ticker ticker(progress);
    if (cut_into_cells(surfaces, segmentation, ticker) && cut_into_pieces(surfaces, segmentation, ticker)) return;
    segmentation = {};
}

/// The map is of the triangles as `reduce` turned them.
void segment(const MappedSurfaces& surfaces, Segmentation& segmentation, const Progress& progress) {
    Orientation orientation = orient(surfaces.original.triangles, vertex_count(surfaces.original));
    if (orientation.turned == 0) return segment_oriented(surfaces, segmentation, progress);
    Mesh turned;
    turned.position = surfaces.original.position;
    turned.triangles = std::move(orientation.triangles);
    turned.regions = surfaces.original.regions;
    segment_oriented({turned, surfaces}, segmentation, progress);
}

} // namespace meshbound
