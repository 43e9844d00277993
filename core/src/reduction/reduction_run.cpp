#include "reduction/reduction_run.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "errors/propagated/propagation.hpp"
#include "errors/tracked/map_output.hpp"
#include "errors/tracked/tracking.hpp"
#include "mesh/orientation.hpp"
#include "mesh/region_report.hpp"
#include "metric/bound_multiplier.hpp"
#include "reduction/locks.hpp"
#include "reduction/reduction_output.hpp"
#include "reduction/sweep.hpp"
#include "segmentation/fold_count.hpp"
#include "surface/seams.hpp"

namespace meshbound {
namespace {

/// Sweeping is this share of the progress; the rest is reporting.
constexpr double sweeping_share = 0.9;

/// More threads would wait for each other.
constexpr unsigned most_threads = 64;

/// By the lowest vertices of coincidence classes: all classes are candidates but those in which curves meet or end, and
/// those that the user locked (§3.1: all vertices are candidates).
std::vector<char> find_candidates(const Mesh& mesh, const Surface& surface, const Options& options) {
    std::vector<char> candidate(surface.vertex_count(), 0);
    for (std::uint32_t vertex = 0; vertex < candidate.size(); ++vertex)
        candidate[vertex] = surface.representative(vertex) == vertex && surface.is_removable(vertex);
    for (const std::uint32_t vertex : locked_vertices(mesh, options))
        candidate[surface.representative(surface.first_vertex_of(vertex))] = 0;
    return candidate;
}

std::size_t threads_to_use(const Options& options) {
    const unsigned wanted = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    return std::clamp(wanted, 1U, most_threads);
}

std::unique_ptr<ErrorModel> make_error_model(const Options& options, const Rows& rows, const Surface& surface) {
    if (options.errors == ErrorAccounting::tracked) return std::make_unique<Tracking>(rows, surface, options);
    return std::make_unique<Propagation>(rows, surface, options.cost);
}

} // namespace

ReductionRun::ReductionRun(const Mesh& mesh, const Options& options, const MeshDefects& defects,
                           ProgressReporter& reporter)
    : mesh_(mesh), options_(options), defects_(defects), reporter_(reporter), pool_(threads_to_use(options)),
      unmet_boxes_(unused_locked_boxes(mesh, options)), surface_(mesh.triangles, vertex_count(mesh), mesh.regions) {
    if (surface_.has_coincident_triangles()) make_one_sided();
    else if (surface_.inconsistent_edges() > 0) orient_surface();
    surface_.join_coincident(find_seams(mesh, surface_));
}

void ReductionRun::orient_surface() {
    Orientation orientation = orient(mesh_.triangles, vertex_count(mesh_));
    note_orientation(orientation, defects_);
    if (orientation.flipped == 0) return;
    oriented_ = std::move(orientation.triangles);
    surface_ = Surface(oriented_, vertex_count(mesh_), mesh_.regions);
}

void ReductionRun::make_one_sided() {
    one_sided_ = std::make_unique<OneSided>(mesh_, OneSided::Orienting::as_reduced, side_labels_);
    one_sided_->note(defects_);
    const Mesh& shape = one_sided_->shape();
    surface_ = Surface(shape.triangles, vertex_count(mesh_), shape.regions);
}

/// Before anything is removed; later levels keep the components that the first one kept.
void ReductionRun::drop_small_components(double bound) {
    if (!options_.drop_small_components || !reached_.empty()) return;
    const Multipliers multipliers(mesh_, find_bound_multiplier(mesh_, options_));
    const std::vector<std::uint32_t> kept = locked_vertices(mesh_, options_);
    dropped_ = meshbound::drop_small_components(mesh_, bound, multipliers, kept, surface_);
    dropped_.triangles += dropped_backs();
}

/// Of the triangles that were dropped, before any was removed, those with another side.
std::size_t ReductionRun::dropped_backs() const {
    std::size_t count = 0;
    for (std::uint32_t slot = 0; one_sided_ && slot < surface_.slot_count(); ++slot)
        count += !surface_.alive(slot) && side_labels_.two_sided(surface_.region(slot));
    return count;
}

Reduction ReductionRun::reduce_within(const std::vector<ResolvedBound>& bounds, const ProgressSpan& span,
                                      LevelMap* link) {
    drop_small_components(bounds[0].absolute);
    if (reached_.empty()) candidates_ = count_vertices(surface_);
    if (options_.refuse_piercing && !self_intersection_check_)
        self_intersection_check_ = std::make_unique<SelfIntersectionCheck>(mesh_, surface_);
    Reduction reduction;
    reduction.report = begin_report_within(bounds);
    if (reporter_.poll()) sweep_and_report(bounds, reduction, span, link);
    if (reporter_.cancelled()) report_cancelled(reduction);
    restore_sides(reduction, link);
    report_what_is_left(reduction);
    return reduction;
}

Report ReductionRun::begin_report_within(const std::vector<ResolvedBound>& bounds) const {
    Report report = begin_report(mesh_, bounds, defects_);
    report.non_manifold_vertices = surface_.non_manifold_vertices();
    report.dropped = dropped_;
    report.candidates = candidates_;
    report.unused_locked_boxes = unmet_boxes_;
    return report;
}

/// Up to here the reduction was that of one-sided sheets.
void ReductionRun::restore_sides(Reduction& reduction, LevelMap* link) const {
    if (one_sided_) restore_both_sides(side_labels_, !mesh_.regions.empty(), reduction, link ? &link->map : nullptr);
}

void ReductionRun::report_what_is_left(Reduction& reduction) const {
    reduction.report.triangles_after = reduction.mesh.triangles.size();
    reduction.report.vertices_after = reduction.vertices.size();
    if (!mesh_.regions.empty()) {
        const std::vector<std::uint32_t> copies = one_sided_ ? one_sided_->copies() : std::vector<std::uint32_t>();
        reduction.report.regions = report_regions(mesh_, copies, reduction.mesh);
    }
}

Reduction ReductionRun::finish_within(const std::vector<ResolvedBound>& bounds, Checkpoint* checkpoint) {
    is_last_call_ = true;
    checkpoint_ = checkpoint;
    return reduce_within(bounds, {});
}

Reduction ReductionRun::finish_without_map(const std::vector<ResolvedBound>& bounds) {
    reports_map_ = false;
    return finish_within(bounds);
}

/// What the surface was made from where triangles were flipped, without its variables.
Mesh ReductionRun::oriented_shape() const {
    Mesh shape;
    shape.position = mesh_.position;
    shape.triangles = oriented_;
    shape.regions = mesh_.regions;
    return shape;
}

/// Errors are stored in units of the bounds, so other bounds mean other numbers.
void ReductionRun::set_bounds(const std::vector<ResolvedBound>& bounds) {
    auto rows = std::make_unique<Rows>(mesh_, bounds, find_bound_multiplier(mesh_, options_), surface_.inputs());
    if (error_model_) error_model_->set_bounds(*rows);
    else error_model_ = make_error_model(options_, *rows, surface_);
    rows_ = std::move(rows);
}

/// A triangle with two sides counts twice.
std::size_t ReductionRun::count_flipped_normals() const {
    return normals_->count_flipped_normals(surface_, *rows_, [this](std::uint32_t slot) {
        return one_sided_ && side_labels_.two_sided(surface_.region(slot)) ? 2 : 1;
    });
}

/// Before anything is removed.
void ReductionRun::record_original_normals() {
    if (normals_) return;
    normals_ = std::make_unique<OriginalNormals>(surface_, *rows_);
    flipped_before_ = count_flipped_normals();
}

/// The limits of the sweeps, without those that lie within bounds already reached: such sweeps would find nothing.
std::vector<double> ReductionRun::limits_of_sweeps(const std::vector<ResolvedBound>& bounds) const {
    std::vector<double> limits;
    for (const double share : options_.sweeps) {
        bool farther = reached_.empty() || share == options_.sweeps.back();
        for (std::size_t i = 0; !farther && i < bounds.size(); ++i)
            farther = share * bounds[i].absolute > reached_[i].absolute;
        if (farther) limits.push_back(share * rows_->limit());
    }
    return limits;
}

void ReductionRun::sweep_and_report(const std::vector<ResolvedBound>& bounds, Reduction& reduction,
                                    const ProgressSpan& span, LevelMap* link) {
    set_bounds(bounds);
    record_original_normals();
    if (!reporter_.poll()) return;
    const std::unique_ptr<LinkedTracking> linked = link ? link_from_here(bounds) : nullptr;
    ErrorModel& error_model = linked ? static_cast<ErrorModel&>(*linked) : *error_model_;
    if (sweep(bounds, error_model, span, reduction.report)) report_everything(reduction, linked.get(), link);
}

bool ReductionRun::sweep(const std::vector<ResolvedBound>& bounds, ErrorModel& error_model, const ProgressSpan& span,
                         Report& report) {
    Sweeper sweeper(surface_, *rows_, error_model, find_candidates(mesh_, surface_, options_), pool_,
                    {*normals_, self_intersection_check_.get()});
    const double swept = span.start + sweeping_share * (span.end - span.start);
    const std::vector<double> limits = limits_of_sweeps(bounds);
    reached_ = bounds;
    const auto pass_checkpoint = [&] {
        if (!checkpoint_) return;
        Checkpoint here = checkpoint_here(bounds);
        if (!reporter_.cancelled()) *checkpoint_ = std::move(here); // else its errors are not all measured
    };
    if (!sweeper.sweep(limits, reporter_, span.start, swept, pass_checkpoint)) return false;
    count_refusals(surface_, sweeper, report);
    report.flipped_normals_before = flipped_before_;
    report.flipped_normals_after = count_flipped_normals();
    return true;
}

/// The current surface. Its errors are measured, not taken from the limit of the sweep: some variables have spent less.
Checkpoint ReductionRun::checkpoint_here(const std::vector<ResolvedBound>& bounds) {
    Reduction here;
    here.report = begin_report_within(bounds);
    here.report.termination = Termination::intermediate;
    extract_mesh(mesh_, surface_, here);
    extract_errors(surface_, *rows_, *error_model_, here, pool_, reporter_);
    restore_sides(here, nullptr);
    report_what_is_left(here);
    return {std::move(here.mesh), std::move(here.vertices), std::move(here.report)};
}

/// The finer level lies within its bounds of the original, and the coarser one within its own. The map between them by
/// way of the original moves nothing farther than the sum of both; that is the bound of this map.
std::unique_ptr<LinkedTracking> ReductionRun::link_from_here(std::vector<ResolvedBound> bounds) const {
    for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i].absolute += reached_[i].absolute;
    return std::make_unique<LinkedTracking>(
        dynamic_cast<Tracking&>(*error_model_),
        Rows(mesh_, bounds, find_bound_multiplier(mesh_, options_), surface_.inputs()), surface_, options_);
}

/// Fills in all of a finished result; incomplete where the caller cancels. Releases what is no longer needed first.
void ReductionRun::report_everything(Reduction& reduction, const LinkedTracking* linked, LevelMap* link) {
    if (is_last_call_) {
        normals_.reset();
        self_intersection_check_.reset();
    }
    const ReducedIndices reduced = extract_mesh(mesh_, surface_, reduction);
    extract_errors(surface_, *rows_, *error_model_, reduction, pool_, reporter_);
    auto* tracking = dynamic_cast<Tracking*>(error_model_.get());
    if (!tracking || !reports_map_) return;
    if (is_last_call_) tracking->finish();
    extract_map(surface_, *tracking, reduced.vertex, reduced.triangle, reduction.map, reporter_);
    if (linked) linked->extract(reduced.vertex, reduced.triangle, reduction.vertices, *link, reporter_);
    if (is_last_call_) error_model_.reset();
    extract_vertex_errors(*rows_, surface_, reduction, reduction.vertex_errors, pool_, reporter_);
    if (options_.count_folds && !reporter_.cancelled()) count_folds(reduction);
}

void ReductionRun::count_folds(Reduction& reduction) {
    const Mesh oriented = oriented_.empty() ? Mesh{} : oriented_shape();
    const Mesh& shape = one_sided_ ? one_sided_->shape() : oriented_.empty() ? mesh_ : oriented;
    const Folds folds =
        meshbound::count_folds({shape, reduction}, one_sided_ ? one_sided_->sides() : Sides(), pool_, reporter_);
    reduction.report.cells = folds.cells;
    reduction.report.folded_cells = folds.folded_cells;
}

/// The result of a cancelled call: the surface as far as it got, and the bounds that it keeps.
void ReductionRun::report_cancelled(Reduction& reduction) const {
    Report report = std::move(reduction.report);
    reduction = {};
    extract_mesh(mesh_, surface_, reduction);
    report.termination = Termination::cancelled;
    report_limits(Multipliers(mesh_, find_bound_multiplier(mesh_, options_)), report);
    reduction.report = std::move(report);
}

} // namespace meshbound
