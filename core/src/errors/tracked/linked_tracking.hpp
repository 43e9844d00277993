#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "errors/accounting.hpp"
#include "meshbound/level_link.hpp"
#include "util/ticker.hpp"
#include "errors/tracked/tracking.hpp"

namespace meshbound {

/// Two tracked maps at once, for a level that one can morph to (§4): the one from the original, which goes on, and one that
/// begins at the surface as it is now, the finer level. The one keeps the bounds; the other keeps bounds of its own, so that
/// nothing travels far in a morph.
class LinkedTracking final : public Accounting {
public:
    /// `rows`: in the bounds of the map from the finer level.
    LinkedTracking(Tracking& from_original, Rows rows, const Surface& surface, const Options& options);

    std::unique_ptr<RemovalAccounting> removals() override;
    void measure_in(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

    /// The map from the finer level, and its largest errors. `renamed_vertex` and `renamed_triangle` lead to the coarser
    /// level, of `coarser_vertices`. Stops where the ticker cancels, incomplete.
    void extract(const std::vector<std::uint32_t>& renamed_vertex, const std::vector<std::uint32_t>& renamed_triangle,
                 const std::vector<std::uint32_t>& coarser_vertices, LevelLink& link, Ticker& ticker) const;

private:
    void extract_errors(LevelLink& link, Ticker& ticker) const;

    Tracking& from_original_;
    Rows rows_;
    Tracking from_finer_;
    const Surface* surface_;
    std::vector<std::uint32_t> finer_vertices_; // the finer level's, rising
};

} // namespace meshbound
