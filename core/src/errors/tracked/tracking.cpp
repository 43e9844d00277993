#include "errors/tracked/tracking.hpp"

#include "errors/tracked/tracked_errors.hpp"
#include "errors/tracked/tracked_removal.hpp"

namespace meshbound {

Tracking::Tracking(const Rows& rows, const Surface& surface, const Options& options, double relocation_threshold)
    : rows_(&rows), bounded_rows_(rows), surface_(surface), options_(options),
      relocation_threshold_(relocation_threshold), map_(surface) {}

std::unique_ptr<RemovalErrorModel> Tracking::make_removal_model() {
    return std::make_unique<TrackedRemoval>(*rows_, bounded_rows_, surface_, map_, options_, relocation_threshold_);
}

/// The map itself does not depend on the bounds.
void Tracking::set_bounds(const Rows& rows) {
    rows_ = &rows;
    bounded_rows_ = BoundedRows(rows);
}

void Tracking::errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    TrackedErrors(*rows_, surface_, map_).on_triangle(slot, ranges);
}

} // namespace meshbound
