#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "meshbound/map.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/reduction.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The labels of the regions on the front of a triangle of a sheet, and on its back where it has one, as one number.
/// Numbers are given from 0 in the order of first use; meshes that share a SideLabels have comparable ones.
class SideLabels {
public:
    std::int32_t number(std::int32_t front, std::optional<std::int32_t> back);
    bool two_sided(std::int32_t number) const { return known_[static_cast<std::size_t>(number)].back.has_value(); }
    std::int32_t front(std::int32_t number) const { return known_[static_cast<std::size_t>(number)].front; }
    std::int32_t back(std::int32_t number) const { return *known_[static_cast<std::size_t>(number)].back; }

private:
    struct Sides {
        std::int32_t front;
        std::optional<std::int32_t> back;
    };
    std::vector<Sides> known_;
    std::map<std::tuple<std::int32_t, bool, std::int32_t>, std::int32_t> numbers_;
};

/// A mesh some of whose triangles are on the same three vertices, as one sheet. Two of them with opposite winding are the
/// two sides of one triangle of it; every further one is a copy of the first with its winding, and is left out.
///
///     {0,1,2}, {1,2,0}, {0,2,1}:  one triangle {0,1,2}, whose other side is triangle 2; triangle 1 is a copy
///
/// Where the surface has two sides beside one, and where the labels of either side change, the sheet has a border, as between
/// regions: there both sides end together.
class OneSided {
public:
    enum class Orienting {
        as_reduced, ///< sides are chosen, and triangles flipped, so that neighbours agree, as `reduce` does (see orient)
        none,       ///< the first triangle is the front
    };
    OneSided(const Mesh& mesh, Orienting orienting, SideLabels& labels);

    /// Position and triangles, whose regions are numbers of SideLabels. Triangles that name a vertex twice are left out.
    const Mesh& shape() const { return shape_; }
    /// For each triangle of the shape the one of the mesh that faces its way (or did, before it was flipped) …
    const std::vector<std::uint32_t>& fronts() const { return fronts_; }
    /// … and the one that faces the other way, or no_index.
    const std::vector<std::uint32_t>& backs() const { return backs_; }
    /// For each triangle of the mesh the one of the shape that it is a side or a copy of, or no_index.
    const std::vector<std::uint32_t>& triangles_in_shape() const { return in_shape_; }
    /// For each triangle of the shape 2 where it has a back, 1 else.
    std::vector<std::uint8_t> sides() const;
    /// The triangles of the mesh that are copies, rising.
    const std::vector<std::uint32_t>& copies() const { return copies_; }
    /// Fills in what is reported of it.
    void note(MeshDefects& defects) const;

private:
    void find_sides(const Mesh& mesh);
    void orient_sides();

    Mesh shape_;
    std::vector<std::uint32_t> fronts_, backs_, in_shape_, copies_;
    std::size_t flipped_ = 0, unorientable_parts_ = 0;
    std::optional<std::size_t> unorientable_triangle_;
};

/// Whether any two triangles of a mesh are on the same three vertices.
bool has_coincident_triangles(const Mesh& mesh);

/// Expands a reduced sheet to both its sides: the front of each triangle, after it its back. `link`, where given, is a
/// map onto the same mesh.
void restore_both_sides(const SideLabels& labels, bool with_regions, Reduction& reduction, SurfaceMap* link);

} // namespace meshbound
