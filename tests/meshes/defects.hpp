#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "meshbound/mesh.hpp"

/// Meshes that are unusual but no error: not manifold, or degenerate. Double precision.
namespace meshes {

using meshbound::Mesh;

/// Three half-planes that meet in one line of `cells` non-manifold edges, each `cells` cells wide.
Mesh three_sheets(int cells);
/// Two squares of cells × cells that share one corner.
Mesh bow_tie(int cells);
/// Two cubes that share one edge: four triangles on each edge of a line.
Mesh cubes_on_one_edge(int cells);
/// A square with one triangle turned round: edges that two triangles run along in the same direction.
Mesh one_triangle_reversed(int cells);

/// Puts a new vertex into a triangle (of a mesh in double precision) and joins it to the corners; its values are those of
/// the given place. A place on an edge gives a triangle of zero area, a place at a corner two vertices in one place.
Mesh with_vertex_in_triangle(const Mesh& mesh, std::size_t triangle, std::array<double, 3> barycentric);
/// Puts such vertices into many triangles: on edges, at corners, and so close to them that needles arise.
Mesh with_degenerate_triangles(const Mesh& mesh);

/// One of each kind, small, with the usual fields; among them an open sphere whose boundary is ragged.
std::vector<Mesh> odd_surfaces();

/// A Möbius band: the last column joins the first upside down, so that some edges run the same way in two triangles.
Mesh moebius_band(int around, int across);

} // namespace meshes
