#pragma once

#include <cstdint>
#include <vector>

#include "errors/error_model.hpp"
#include "errors/tracked/tracked_map.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The errors of a tracked map on the triangles of the current surface.
class TrackedErrors {
public:
    TrackedErrors(const Rows& rows, const Surface& surface, const TrackedMap& map)
        : rows_(rows), surface_(surface), map_(map) {}

    /// On the triangle in `slot`, by row group.
    void on_triangle(std::uint32_t slot, std::vector<ErrorRange>& ranges) const;

private:
    template <class Visit>
    void for_each_corner(std::uint32_t slot, const Visit& visit) const;
    bool has_numbers(std::uint32_t slot, const RowGroup& group) const;

    const Rows& rows_;
    const Surface& surface_;
    const TrackedMap& map_;
};

} // namespace meshbound
