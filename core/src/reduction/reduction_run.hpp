#pragma once

#include <memory>
#include <vector>

#include "errors/error_model.hpp"
#include "errors/tracked/linked_tracking.hpp"
#include "meshbound/checkpoint.hpp"
#include "meshbound/level_map.hpp"
#include "meshbound/reduction.hpp"
#include "metric/rows.hpp"
#include "retriangulation/original_normals.hpp"
#include "self_intersection/self_intersection_check.hpp"
#include "surface/one_sided.hpp"
#include "surface/small_components.hpp"
#include "surface/surface.hpp"
#include "util/progress_reporter.hpp"
#include "util/thread_pool.hpp"

namespace meshbound {

/// An interval of the progress of a call.
struct ProgressSpan {
    double start = 0, end = 1;
};

/// A reduction under way: the surface as far as it got, and all that is known of its errors. It can go on with coarser
/// bounds (§4): the next result continues from the one before, with errors against the original still.
class ReductionRun {
public:
    /// The mesh is valid, the options are checked; both outlive the run, as the reporter does.
    ReductionRun(const Mesh& mesh, const Options& options, const MeshDefects& defects, ProgressReporter& reporter);

    /// Removes what these bounds allow, and returns what is left. No bound may be lower than in the call before. Where
    /// the caller cancels, the result is marked as cancelled. `link`, with tracked errors only, is filled with the map
    /// from the surface as it was before the call, unless the caller cancels.
    Reduction reduce_within(const std::vector<ResolvedBound>& bounds, const ProgressSpan& span,
                            LevelMap* link = nullptr);

    /// The same as the last call of a run: what only a further call would need is released as soon as possible, which
    /// keeps the peak memory low. `checkpoint`, where given, is filled with the surface before the last sweep; there are
    /// two sweeps at least.
    Reduction finish_within(const std::vector<ResolvedBound>& bounds, Checkpoint* checkpoint = nullptr);

    /// The same without a map and without errors of vertices.
    Reduction finish_without_map(const std::vector<ResolvedBound>& bounds);

private:
    void orient_surface();
    void make_one_sided();
    void drop_small_components(double bound);
    std::size_t dropped_backs() const;
    std::size_t count_flipped_normals() const;
    Mesh oriented_shape() const;
    void record_original_normals();
    void set_bounds(const std::vector<ResolvedBound>& bounds);
    std::unique_ptr<LinkedTracking> link_from_here(std::vector<ResolvedBound> bounds) const;
    std::vector<double> limits_of_sweeps(const std::vector<ResolvedBound>& bounds) const;
    bool sweep(const std::vector<ResolvedBound>& bounds, ErrorModel& error_model, const ProgressSpan& span,
               Report& report);
    Checkpoint checkpoint_here(const std::vector<ResolvedBound>& bounds);
    void sweep_and_report(const std::vector<ResolvedBound>& bounds, Reduction& reduction, const ProgressSpan& span,
                          LevelMap* link);
    Report begin_report_within(const std::vector<ResolvedBound>& bounds) const;
    void restore_sides(Reduction& reduction, LevelMap* link) const;
    void report_what_is_left(Reduction& reduction) const;
    void report_everything(Reduction& reduction, const LinkedTracking* linked, LevelMap* link);
    void count_folds(Reduction& reduction);
    void report_cancelled(Reduction& reduction) const;

    const Mesh& mesh_;
    const Options& options_;
    MeshDefects defects_;
    ProgressReporter& reporter_;
    ThreadPool pool_;
    std::vector<std::size_t> unmet_boxes_;
    Surface surface_;
    SideLabels side_labels_;
    std::unique_ptr<OneSided> one_sided_; // where triangles coincide: what the surface is made from
    std::vector<glm::uvec3> oriented_;    // the input's triangles where some were flipped; else empty
    DroppedComponents dropped_;
    std::unique_ptr<Rows> rows_;
    std::unique_ptr<ErrorModel> error_model_;
    std::unique_ptr<OriginalNormals> normals_;
    std::size_t flipped_before_ = 0, candidates_ = 0;
    std::unique_ptr<SelfIntersectionCheck> self_intersection_check_; // where self-intersection is refused
    std::vector<ResolvedBound> reached_; // the bounds of the last call; empty before the first
    bool is_last_call_ = false;          // no further call
    bool reports_map_ = true;
    Checkpoint* checkpoint_ = nullptr; // to be filled on the way
};

} // namespace meshbound
