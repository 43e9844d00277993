#pragma once

#include "meshbound/mapped_surfaces.hpp"
#include "meshbound/segmentation.hpp"
#include "surface/one_sided.hpp"

namespace meshbound {

/// Two surfaces with a map between them, some of whose triangles have two sides, as sheets with one side.
class OneSidedPair {
public:
    /// The map passed check_map.
    explicit OneSidedPair(const MappedSurfaces& both);
    OneSidedPair(const OneSidedPair&) = delete;
    OneSidedPair& operator=(const OneSidedPair&) = delete;

    const OneSided& original() const { return original_; }
    const OneSided& reduced() const { return reduced_; }
    const MappedSurfaces& surfaces() const { return surfaces_; }

    /// What was segmented as sheets with one side, on both: backs have the cells of their fronts, mirrored.
    Segmentation on_both_sides(const Segmentation& one_sided) const;

private:
    struct Cells {
        std::size_t first, last; // one past it
    };
    void add(const Segmentation& one_sided, const Cells& cells, std::uint32_t triangle, Segmentation& both) const;

    SideLabels labels_;
    OneSided original_, reduced_;
    SurfaceMap map_; // into the triangles of the reduced sheet
    MappedSurfaces surfaces_;
};

} // namespace meshbound
