#include "reduction/reduction_run.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "metric/focus.hpp"
#include "reduction/locks.hpp"
#include "errors/tracked/map_output.hpp"
#include "mesh/orientation.hpp"
#include "segmentation/oriented_segmentation.hpp"
#include "errors/propagated/propagation.hpp"
#include "reduction/reduction_output.hpp"
#include "mesh/region_report.hpp"
#include "surface/seams.hpp"
#include "reduction/sweep.hpp"
#include "errors/tracked/tracking.hpp"

namespace meshbound {
namespace {

/// Sweeping is this share of the progress; the rest is reporting.
constexpr double sweeping_share = 0.9;

/// More threads than this would wait for each other.
constexpr unsigned most_threads = 64;

/// By vertex, for those that name a site: all sites are candidates but those in which curves meet or end, and those that the
/// user locked (§3.1: all vertices are candidates).
std::vector<char> find_candidates(const Mesh& mesh, const Surface& surface, const Options& options) {
    std::vector<char> candidate(surface.vertex_count(), 0);
    for (std::uint32_t vertex = 0; vertex < candidate.size(); ++vertex)
        candidate[vertex] = surface.site(vertex) == vertex && surface.is_free(vertex);
    for (const std::uint32_t vertex : locked_vertices(mesh, options))
        candidate[surface.site(surface.first_copy(vertex))] = 0;
    return candidate;
}

std::size_t threads_to_use(const Options& options) {
    const unsigned wanted = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    return std::clamp(wanted, 1U, most_threads);
}

std::unique_ptr<Accounting> make_accounting(const Options& options, const Rows& rows, const Surface& surface) {
    if (options.errors == Errors::tracked) return std::make_unique<Tracking>(rows, surface, options);
    return std::make_unique<Propagation>(rows, surface, options.cost);
}

} // namespace

ReductionRun::ReductionRun(const Mesh& mesh, const Options& options, const Oddities& oddities, Ticker& ticker)
    : mesh_(mesh), options_(options), oddities_(oddities), ticker_(ticker), team_(threads_to_use(options)),
      unmet_boxes_(unmet_boxes(mesh, options)), surface_(mesh.triangles, vertex_count(mesh), mesh.regions) {
    if (surface_.has_coincident_triangles()) take_one_side();
    else if (surface_.discordant_edges() > 0) orient_surface();
    surface_.join_sites(find_seams(mesh, surface_));
}

void ReductionRun::orient_surface() {
    Orientation orientation = orient(mesh_.triangles, vertex_count(mesh_));
    note_turned(orientation, oddities_);
    if (orientation.turned == 0) return;
    oriented_ = std::move(orientation.triangles);
    surface_ = Surface(oriented_, vertex_count(mesh_), mesh_.regions);
}

void ReductionRun::take_one_side() {
    one_sided_ = std::make_unique<OneSided>(mesh_, OneSided::Turning::as_reduced, side_labels_);
    one_sided_->note(oddities_);
    const Mesh& shape = one_sided_->shape();
    surface_ = Surface(shape.triangles, vertex_count(mesh_), shape.regions);
}

/// Before anything is removed; later levels keep what the first one kept.
void ReductionRun::drop_small_parts(double bound) {
    if (!options_.drop_small_parts || !reached_.empty()) return;
    const Multipliers multipliers(mesh_, find_focus(mesh_, options_));
    const std::vector<std::uint32_t> kept = locked_vertices(mesh_, options_);
    dropped_ = meshbound::drop_small_parts(mesh_, bound, multipliers, kept, surface_);
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
                                      LevelLink* link) {
    drop_small_parts(bounds[0].absolute);
    if (reached_.empty()) candidates_ = count_vertices(surface_);
    if (options_.refuse_piercing && !piercing_) piercing_ = std::make_unique<Piercing>(mesh_, surface_);
    Reduction reduction;
    reduction.report = begin_report_within(bounds);
    if (ticker_.ask()) sweep_and_report(bounds, reduction, span, link);
    if (ticker_.cancelled()) report_cancelled(reduction);
    give_out(reduction, link);
    report_what_is_left(reduction);
    return reduction;
}

Report ReductionRun::begin_report_within(const std::vector<ResolvedBound>& bounds) const {
    Report report = begin_report(mesh_, bounds, oddities_);
    report.non_manifold_vertices = surface_.non_manifold_vertices();
    report.dropped = dropped_;
    report.candidates = candidates_;
    report.unmet_boxes = unmet_boxes_;
    return report;
}

/// Up to here the reduction was one of the surface, whose sheets have one side each.
void ReductionRun::give_out(Reduction& reduction, LevelLink* link) const {
    if (one_sided_) give_out_both_sides(side_labels_, !mesh_.regions.empty(), reduction, link ? &link->map : nullptr);
}

void ReductionRun::report_what_is_left(Reduction& reduction) const {
    reduction.report.triangles_after = reduction.mesh.triangles.size();
    reduction.report.vertices_after = reduction.vertices.size();
    if (!mesh_.regions.empty()) {
        const std::vector<std::uint32_t> copies = one_sided_ ? one_sided_->copies() : std::vector<std::uint32_t>();
        reduction.report.regions = report_regions(mesh_, copies, reduction.mesh);
    }
}

Reduction ReductionRun::end_within(const std::vector<ResolvedBound>& bounds, Waypoint* waypoint) {
    ends_ = true;
    waypoint_ = waypoint;
    return reduce_within(bounds, {});
}

Reduction ReductionRun::end_without_map(const std::vector<ResolvedBound>& bounds) {
    tells_map_ = false;
    return end_within(bounds);
}

/// What the surface was made from where triangles were turned, without its variables.
Mesh ReductionRun::oriented_shape() const {
    Mesh shape;
    shape.position = mesh_.position;
    shape.triangles = oriented_;
    shape.regions = mesh_.regions;
    return shape;
}

/// Errors are known in bounds, so other bounds mean other numbers.
void ReductionRun::set_bounds(const std::vector<ResolvedBound>& bounds) {
    auto rows = std::make_unique<Rows>(mesh_, bounds, find_focus(mesh_, options_), surface_.inputs());
    if (accounting_) accounting_->measure_in(*rows);
    else accounting_ = make_accounting(options_, *rows, surface_);
    rows_ = std::move(rows);
}

/// A triangle with two sides is two.
std::size_t ReductionRun::count_turned() const {
    return normals_->count_turned(surface_, *rows_, [this](std::uint32_t slot) {
        return one_sided_ && side_labels_.two_sided(surface_.region(slot)) ? 2 : 1;
    });
}

/// Before anything is removed.
void ReductionRun::look_at_original() {
    if (normals_) return;
    normals_ = std::make_unique<OriginalNormals>(surface_, *rows_);
    turned_before_ = count_turned();
}

/// The sweeps, but for those whose limits lie within bounds that were reached before: they would find nothing.
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
                                    const ProgressSpan& span, LevelLink* link) {
    set_bounds(bounds);
    look_at_original();
    if (!ticker_.ask()) return;
    const std::unique_ptr<LinkedTracking> linked = link ? link_from_here(bounds) : nullptr;
    Accounting& accounting = linked ? static_cast<Accounting&>(*linked) : *accounting_;
    if (sweep(bounds, accounting, span, reduction.report)) report_everything(reduction, linked.get(), link);
}

bool ReductionRun::sweep(const std::vector<ResolvedBound>& bounds, Accounting& accounting, const ProgressSpan& span,
                         Report& report) {
    Sweeper sweeper(surface_, *rows_, accounting, find_candidates(mesh_, surface_, options_), team_,
                    {*normals_, piercing_.get()});
    const double swept = span.start + sweeping_share * (span.end - span.start);
    const std::vector<double> limits = limits_of_sweeps(bounds);
    reached_ = bounds;
    const auto pass_waypoint = [&] {
        if (!waypoint_) return;
        Waypoint here = waypoint_here(bounds);
        if (!ticker_.cancelled()) *waypoint_ = std::move(here); // else its errors are not all measured
    };
    if (!sweeper.sweep(limits, ticker_, span.start, swept, pass_waypoint)) return false;
    count_refusals(surface_, sweeper, report);
    report.turned_before = turned_before_;
    report.turned_after = count_turned();
    return true;
}

/// The surface as it is. Its errors are measured, not taken from the limit of the sweep: some variables have spent less.
Waypoint ReductionRun::waypoint_here(const std::vector<ResolvedBound>& bounds) {
    Reduction here;
    here.report = begin_report_within(bounds);
    here.report.stopped = Stopped::on_the_way;
    extract_mesh(mesh_, surface_, here);
    extract_errors(surface_, *rows_, *accounting_, here, team_, ticker_);
    give_out(here, nullptr);
    report_what_is_left(here);
    return {std::move(here.mesh), std::move(here.vertices), std::move(here.report)};
}

/// The finer level lies within its bounds of the original and the coarser one within its own: a map between them that
/// leads by way of the original moves nothing farther than the two together, and that is what is asked of this one.
std::unique_ptr<LinkedTracking> ReductionRun::link_from_here(std::vector<ResolvedBound> bounds) const {
    for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i].absolute += reached_[i].absolute;
    return std::make_unique<LinkedTracking>(dynamic_cast<Tracking&>(*accounting_),
                                            Rows(mesh_, bounds, find_focus(mesh_, options_), surface_.inputs()),
                                            surface_, options_);
}

/// Everything that a finished result tells; incomplete where the ticker cancels. What is not needed any more goes first.
void ReductionRun::report_everything(Reduction& reduction, const LinkedTracking* linked, LevelLink* link) {
    if (ends_) {
        normals_.reset();
        piercing_.reset();
    }
    const Renaming renamed = extract_mesh(mesh_, surface_, reduction);
    extract_errors(surface_, *rows_, *accounting_, reduction, team_, ticker_);
    auto* tracking = dynamic_cast<Tracking*>(accounting_.get());
    if (!tracking || !tells_map_) return;
    if (ends_) tracking->end();
    extract_map(surface_, *tracking, renamed.vertex, renamed.triangle, reduction.map, ticker_);
    if (linked) linked->extract(renamed.vertex, renamed.triangle, reduction.vertices, *link, ticker_);
    if (ends_) accounting_.reset();
    extract_vertex_errors(*rows_, surface_, reduction, reduction.vertex_errors, team_, ticker_);
    if (options_.count_folds && !ticker_.cancelled()) count_folds(reduction);
}

void ReductionRun::count_folds(Reduction& reduction) {
    const Mesh oriented = oriented_.empty() ? Mesh{} : oriented_shape();
    const Mesh& shape = one_sided_ ? one_sided_->shape() : oriented_.empty() ? mesh_ : oriented;
    const Folds folds =
        meshbound::count_folds({shape, reduction}, one_sided_ ? one_sided_->sides() : Sides(), team_, ticker_);
    reduction.report.cells = folds.cells;
    reduction.report.folded_cells = folds.folded_cells;
}

/// What a cancelled call leaves: the surface as far as it got, and the bounds that it keeps.
void ReductionRun::report_cancelled(Reduction& reduction) const {
    Report report = std::move(reduction.report);
    reduction = {};
    extract_mesh(mesh_, surface_, reduction);
    report.stopped = Stopped::cancelled;
    report_limits(Multipliers(mesh_, find_focus(mesh_, options_)), report);
    reduction.report = std::move(report);
}

} // namespace meshbound
