#pragma once

#include "meshbound/mesh.hpp"
#include "meshes/gallery.hpp"

/// Surfaces that pass so close to themselves that a careless reduction pierces them. Manifold, free of self-intersections,
/// irregularly triangulated, in double precision, without variables.
namespace meshes {

using meshbound::Mesh;

/// Two wavy sheets of the unit square, one `gap` above the other. Open.
Mesh two_sheets(int cells, double gap);
/// A sheet rolled up, its turns `gap` apart. Open.
Mesh spiral(int along, int across, double gap);
/// The wall, `gap` thick, of a barrel without lids. Closed, genus 1.
Mesh thin_shell(int around, int along, double gap);
/// A unit sphere and another one inside, of radius 1 - gap. Closed, two components.
Mesh nested_spheres(int cells, double gap);
/// A closed tube along a figure of eight, which passes over itself with a distance of `gap`. Closed, genus 1.
Mesh self_passing_tube(int around, int across, double gap);

/// One of each, with gaps of about a hundredth of their extents.
std::vector<Exhibit> near_lobes();

} // namespace meshes
