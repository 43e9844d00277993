#include "errors/tracked/tracking.hpp"

#include "errors/tracked/tracked_errors.hpp"
#include "errors/tracked/tracked_removal.hpp"

namespace meshbound {

Tracking::Tracking(const Rows& rows, const Surface& surface, const Options& options, double content_with)
    : rows_(&rows), measured_rows_(rows), surface_(surface), options_(options), content_with_(content_with),
      map_(surface) {}

std::unique_ptr<RemovalAccounting> Tracking::removals() {
    return std::make_unique<TrackedRemoval>(*rows_, measured_rows_, surface_, map_, options_, content_with_);
}

/// Places are places, whatever errors are measured in.
void Tracking::measure_in(const Rows& rows) {
    rows_ = &rows;
    measured_rows_ = MeasuredRows(rows);
}

void Tracking::errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    TrackedErrors(*rows_, surface_, map_).on_triangle(slot, ranges);
}

} // namespace meshbound
