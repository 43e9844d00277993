#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/mesh.hpp"

/// Surfaces to try things on: oriented outward (or up), in double precision, without variables unless they say so.
/// The same arguments always give the same mesh.
namespace meshes {

using meshbound::Mesh;

/// A mesh of the given points and triangles, in double precision.
Mesh from_points(const std::vector<glm::dvec3>& points, std::vector<glm::uvec3> triangles);
/// Vertex `vertex` in space.
glm::dvec3 point(const Mesh& mesh, std::size_t vertex);

/// Whether the two ends of a direction of a grid are one.
enum class Ends { open, closed };
/// A grid of columns × rows cells, mapped to space by `place`, whose arguments run from 0 to 1. Cells are cut along
/// diagonals that alternate.
Mesh grid(int columns, int rows, const std::function<glm::dvec3(double, double)>& place, Ends across = Ends::open,
          Ends along = Ends::open);

/// The rectangle [0, width] × [0, height] in the plane z = 0.
Mesh plane(int columns, int rows, double width = 1, double height = 1);
/// The unit cube with cells × cells squares a face. Closed.
Mesh cube(int cells);
/// The unit sphere: a cube blown up. Closed.
Mesh sphere(int cells);
/// A sphere whose radius is disturbed by noise of the given size. Closed.
Mesh noisy_sphere(int cells, double noise, std::uint64_t seed);
/// A ring of radius 1 with a tube of radius `tube`. Closed, genus 1.
Mesh torus(int around, int across, double tube = 0.4);
/// A tube of radius 1 and height 2 without lids: two boundary loops.
Mesh cylinder(int around, int along);
/// A strip folded into pleats with sharp creases. Open.
Mesh pleats(int folds, int cells_a_fold);
/// Fractal mountains over the unit square on 2^power cells a side (midpoint displacement). Open.
Mesh terrain(int power, std::uint64_t seed, double roughness = 0.5);
/// A closed band with one full twist: two boundary loops, linked.
Mesh twisted_band(int around, int across);

} // namespace meshes
