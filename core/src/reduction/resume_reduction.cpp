#include "meshbound/resume_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "geometry/round_up_to_float.hpp"
#include "meshbound/validate.hpp"
#include "metric/measured_bounds.hpp"
#include "metric/rounding_margin.hpp"
#include "reduction/check_checkpoint.hpp"
#include "reduction/check_options.hpp"
#include "reduction/reduction_run.hpp"
#include "util/number_text.hpp"
#include "util/out_of_memory.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {
namespace {

/// The early, tighter sweeps led to the checkpoint; another one would not reduce further.
const std::vector<double> sweeps_onward = {1};

Status refuse_option(const std::string& option) {
    return {Fault::bad_option, option + " is judged by the original, which a checkpoint is not.", "", {}};
}

Status refuse_what_needs_original(const Options& options) {
    if (!options.bound_multiplier.empty()) return refuse_option("A variable that multiplies the bounds");
    if (options.limit_to_feature_size) return refuse_option("The feature size");
    if (options.drop_small_components) return refuse_option("Which parts are small enough to be dropped");
    return {};
}

/// The options of the reduction of the checkpoint: vertices by their number in it.
Status translate_locked(const Checkpoint& checkpoint, Options& options) {
    const std::vector<std::uint32_t>& vertices = checkpoint.vertices;
    for (std::uint32_t& locked : options.locked) {
        const auto found = std::lower_bound(vertices.begin(), vertices.end(), locked);
        if (found == vertices.end() || *found != locked)
            return {Fault::bad_checkpoint,
                    "The checkpoint lacks vertex " + std::to_string(locked) + ", which is locked.", "", locked};
        locked = static_cast<std::uint32_t>(found - vertices.begin());
    }
    return {};
}

std::vector<ResolvedBound> bounds_of_original(const Report& report) {
    std::vector<ResolvedBound> bounds;
    for (const VariableReport& variable : report.variables) bounds.push_back(variable.bound);
    return bounds;
}

/// What is left of each bound after the checkpoint, less the margin for rounding.
Status subtract_spent(const Checkpoint& checkpoint, std::vector<ResolvedBound>& bounds) {
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const VariableReport& variable = checkpoint.report.variables[i];
        if (std::isinf(bounds[i].absolute)) continue;
        ResolvedBound rest = bounds[i];
        rest.absolute -= variable.error + rounding_margin(bounds[i]) * bounds[i].absolute;
        if (!(rest.absolute > 0) || !can_be_carried(rest))
            return {Fault::bad_checkpoint,
                    "The bound of “" + variable.name + "” is " + number_text(bounds[i].absolute) +
                        "; the checkpoint has spent " + number_text(variable.error) + " of it.",
                    variable.name,
                    {}};
        bounds[i] = rest;
    }
    return {};
}

/// Never above 1: that the whole stays within the bound is certain, whichever way its parts were rounded.
double ratio_of(double error, const ResolvedBound& bound) {
    return std::isinf(bound.absolute) ? 0 : std::min(error / bound.absolute, 1.0);
}

void add_spent(double spent, const ResolvedBound& bound, TriangleErrors& errors) {
    for (std::size_t t = 0; t < errors.largest.size(); ++t) {
        const double largest = errors.largest[t] + spent;
        errors.largest[t] = round_up_to_float(largest);
        errors.ratio[t] = round_up_to_float(ratio_of(largest, bound));
    }
    for (float& lowest : errors.lowest) lowest = -round_up_to_float(spent - lowest);
    for (float& highest : errors.highest) highest = round_up_to_float(spent + highest);
}

/// Each region as it was in the original and as it is left: nothing where the checkpoint has none of it. Both lists are
/// in the order of labels.
std::vector<RegionReport> join_regions(std::vector<RegionReport> regions, const std::vector<RegionReport>& onward) {
    for (RegionReport& region : regions) {
        const auto found =
            std::lower_bound(onward.begin(), onward.end(), region.label,
                             [](const RegionReport& other, std::int32_t label) { return other.label < label; });
        const bool is_left = found != onward.end() && found->label == region.label;
        region.triangles_after = is_left ? found->triangles_after : 0;
        region.area_after = is_left ? found->area_after : 0;
    }
    return regions;
}

/// Turns the report on the reduction of the checkpoint into one on that of the original.
void join_reports(const Report& before, const std::vector<ResolvedBound>& bounds, Report& report) {
    report.triangles_before = before.triangles_before;
    report.vertices_before = before.vertices_before;
    report.defects = before.defects;
    report.dropped = before.dropped;
    report.candidates = before.candidates;
    report.non_manifold_vertices = before.non_manifold_vertices;
    report.flipped_normals_before = report.flipped_normals_after = 0;
    report.regions = join_regions(before.regions, report.regions);
    report.errors_are_upper_bounds = true;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        VariableReport& variable = report.variables[i];
        variable.error += before.variables[i].error;
        variable.bound = bounds[i];
        variable.ratio = ratio_of(variable.error, bounds[i]);
    }
}

/// Expresses a reduction of the checkpoint in terms of the original.
void refer_to_original(const Checkpoint& checkpoint, const std::vector<ResolvedBound>& bounds, Reduction& reduction) {
    for (std::uint32_t& vertex : reduction.vertices) vertex = checkpoint.vertices[vertex];
    for (std::size_t i = 0; i < reduction.triangle_errors.size(); ++i)
        add_spent(checkpoint.report.variables[i].error, bounds[i], reduction.triangle_errors[i]);
    join_reports(checkpoint.report, bounds, reduction.report);
}

} // namespace

Status resume_reduction(const Checkpoint& checkpoint, const Bounds& bounds, const Options& options,
                        Reduction& reduction, const Progress& progress) {
    try {
        ProgressReporter reporter(progress);
        MeshDefects defects;
        if (Status status = validate(checkpoint.mesh, &defects); !status.ok()) return status;
        if (Status status = check_checkpoint(checkpoint); !status.ok()) return status;
        std::vector<ResolvedBound> whole = bounds_of_original(checkpoint.report);
        if (Status status = resolve_measured_bounds(checkpoint.mesh, bounds, whole); !status.ok()) return status;
        std::vector<ResolvedBound> rest = whole;
        if (Status status = subtract_spent(checkpoint, rest); !status.ok()) return status;
        if (Status status = refuse_what_needs_original(options); !status.ok()) return status;
        Options onward = options;
        onward.sweeps = sweeps_onward;
        if (Status status = translate_locked(checkpoint, onward); !status.ok()) return status;
        if (Status status = check_options(checkpoint.mesh, onward); !status.ok()) return status;
        reduction = ReductionRun(checkpoint.mesh, onward, defects, reporter).finish_without_map(rest);
        refer_to_original(checkpoint, whole, reduction);
        reporter.finish();
        return {};
    } catch (const std::bad_alloc&) {
        return out_of_memory("reducing", checkpoint.mesh.triangles.size(), " further");
    }
}

} // namespace meshbound
