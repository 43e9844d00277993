#pragma once

#include <memory>
#include <vector>

#include "errors/accounting.hpp"
#include "errors/tracked/linked_tracking.hpp"
#include "meshbound/level_link.hpp"
#include "meshbound/reduce.hpp"
#include "surface/one_sided.hpp"
#include "retriangulation/original_normals.hpp"
#include "self_intersection/piercing.hpp"
#include "metric/rows.hpp"
#include "surface/small_parts.hpp"
#include "surface/surface.hpp"
#include "util/team.hpp"
#include "util/ticker.hpp"

namespace meshbound {

/// A part of the progress of a call.
struct ProgressSpan {
    double start = 0, end = 1;
};

/// A reduction under way: the surface as far as it got, and all that is known of its errors. It can go on with coarser
/// bounds (§4): the next result continues from the one before, with errors against the original still.
class ReductionRun {
public:
    /// The mesh is valid, the options are checked; both outlive the run, as the ticker does.
    ReductionRun(const Mesh& mesh, const Options& options, const Oddities& oddities, Ticker& ticker);

    /// Removes what these bounds allow, and tells of what is left. Each bound is no lower than in the call before. Where
    /// the ticker cancels, the result is marked so. `link`, with tracked errors only: is filled with the map from the
    /// surface as it was before the call, unless the ticker cancels.
    Reduction reduce_within(const std::vector<ResolvedBound>& bounds, const ProgressSpan& span,
                            LevelLink* link = nullptr);

    /// The same for a run that ends with it: what only a further call would need goes as soon as it can, which keeps the peak
    /// of the memory low. Nothing may be asked of the run afterwards.
    /// `waypoint`, where given, is filled with the surface before the last sweep; there are two sweeps at least.
    Reduction end_within(const std::vector<ResolvedBound>& bounds, Waypoint* waypoint = nullptr);

    /// The same without a map and without errors of vertices.
    Reduction end_without_map(const std::vector<ResolvedBound>& bounds);

private:
    void orient_surface();
    void take_one_side();
    void drop_small_parts(double bound);
    std::size_t dropped_backs() const;
    std::size_t count_turned() const;
    Mesh oriented_shape() const;
    void look_at_original();
    void set_bounds(const std::vector<ResolvedBound>& bounds);
    std::unique_ptr<LinkedTracking> link_from_here(std::vector<ResolvedBound> bounds) const;
    std::vector<double> limits_of_sweeps(const std::vector<ResolvedBound>& bounds) const;
    bool sweep(const std::vector<ResolvedBound>& bounds, Accounting& accounting, const ProgressSpan& span,
               Report& report);
    Waypoint waypoint_here(const std::vector<ResolvedBound>& bounds);
    void sweep_and_report(const std::vector<ResolvedBound>& bounds, Reduction& reduction, const ProgressSpan& span,
                          LevelLink* link);
    Report begin_report_within(const std::vector<ResolvedBound>& bounds) const;
    void give_out(Reduction& reduction, LevelLink* link) const;
    void report_what_is_left(Reduction& reduction) const;
    void report_everything(Reduction& reduction, const LinkedTracking* linked, LevelLink* link);
    void count_folds(Reduction& reduction);
    void report_cancelled(Reduction& reduction) const;

    const Mesh& mesh_;
    const Options& options_;
    Oddities oddities_;
    Ticker& ticker_;
    Team team_;
    std::vector<std::size_t> unmet_boxes_;
    Surface surface_;
    SideLabels side_labels_;
    std::unique_ptr<OneSided>
        one_sided_;                    // where triangles are on the same three vertices: what the surface is made from
    std::vector<glm::uvec3> oriented_; // the input's triangles where some were turned; empty else
    DroppedParts dropped_;
    std::unique_ptr<Rows> rows_;
    std::unique_ptr<Accounting> accounting_;
    std::unique_ptr<OriginalNormals> normals_;
    std::size_t turned_before_ = 0, candidates_ = 0;
    std::unique_ptr<Piercing> piercing_; // where piercing is refused
    std::vector<ResolvedBound> reached_; // the bounds of the last call; empty before the first
    bool ends_ = false;                  // no call follows
    bool tells_map_ = true;
    Waypoint* waypoint_ = nullptr; // to be filled on the way
};

} // namespace meshbound
