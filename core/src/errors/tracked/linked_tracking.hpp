#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "errors/error_model.hpp"
#include "errors/tracked/tracking.hpp"
#include "meshbound/level_map.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {

/// Two tracked maps at once, for a level that can be morphed to (§4): the map from the original, which is continued,
/// and one that begins at the current surface, the finer level. The second has bounds of its own, so that nothing moves
/// far in a morph.
class LinkedTracking final : public ErrorModel {
public:
    /// `rows`: in the bounds of the map from the finer level.
    LinkedTracking(Tracking& from_original, Rows rows, const Surface& surface, const Options& options);

    std::unique_ptr<RemovalErrorModel> make_removal_model() override;
    void set_bounds(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

    /// The map from the finer level, and its largest errors. `reduced_vertex` and `reduced_triangle` lead to the
    /// coarser level, of `coarser_vertices`. Stops where the caller cancels, incomplete.
    void extract(const std::vector<std::uint32_t>& reduced_vertex, const std::vector<std::uint32_t>& reduced_triangle,
                 const std::vector<std::uint32_t>& coarser_vertices, LevelMap& link, ProgressReporter& reporter) const;

private:
    void extract_errors(LevelMap& link, ProgressReporter& reporter) const;

    Tracking& from_original_;
    Rows rows_;
    Tracking from_finer_;
    const Surface* surface_;
    std::vector<std::uint32_t> finer_vertices_; // the finer level's, rising
};

} // namespace meshbound
