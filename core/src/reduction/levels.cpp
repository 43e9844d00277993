#include "meshbound/levels.hpp"

#include <new>
#include <optional>
#include <string>
#include <utility>

#include "meshbound/validate.hpp"
#include "metric/bound_multiplier.hpp"
#include "reduction/check_options.hpp"
#include "reduction/feature_limit.hpp"
#include "reduction/reduction_run.hpp"
#include "util/number_text.hpp"
#include "util/out_of_memory.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {
namespace {

using LevelBounds = std::vector<std::vector<ResolvedBound>>;

/// Levels are counted from 1 in messages.
std::string name_of(std::size_t level) { return "level " + std::to_string(level + 1); }

/// A coarser level is a finer one with more removed: it cannot keep tighter bounds, and under the same ones it is the same.
Status check_step(const Mesh& mesh, const LevelBounds& bounds, std::size_t level) {
    bool rises = false;
    for (std::size_t i = 0; i < bounds[level].size(); ++i) {
        const double finer = bounds[level - 1][i].absolute, coarser = bounds[level][i].absolute;
        rises = rises || coarser > finer;
        if (coarser >= finer) continue;
        const std::string name(variable_of(mesh, i).name);
        return {Fault::bad_levels,
                "The bound of “" + name + "” falls from " + number_text(finer) + " in " + name_of(level - 1) + " to " +
                    number_text(coarser) + " in " + name_of(level) +
                    "; levels go from fine to coarse, so no bound may fall.",
                name, level};
    }
    if (rises) return {};
    return {Fault::bad_levels,
            "The bounds of " + name_of(level) + " are those of " + name_of(level - 1) + "; at least one must rise.", "",
            level};
}

/// Names the level in the message of a fault.
Status of_level(std::size_t level, Status status) {
    if (!status.ok()) status.message = "Of " + name_of(level) + ": " + status.message;
    return status;
}

Status resolve_levels(const Mesh& mesh, const std::vector<Bounds>& bounds, LevelBounds& resolved) {
    if (bounds.empty()) return {Fault::bad_levels, "There must be the bounds of at least one level.", "", {}};
    for (std::size_t level = 0; level < bounds.size(); ++level) {
        resolved.emplace_back();
        Status status = of_level(level, resolve_bounds(mesh, bounds[level], resolved.back()));
        if (status.ok() && level > 0) status = check_step(mesh, resolved, level);
        if (!status.ok()) return status;
    }
    return {};
}

/// Whether the options fit the bounds. Small parts are dropped within those of the first level.
Status check_together(const Mesh& mesh, const LevelBounds& bounds, const Options& options) {
    for (std::size_t level = 0; level < bounds.size(); ++level) {
        Status status = check_feature_limit(bounds[level], options);
        if (status.ok() && level == 0) status = check_small_parts(bounds[level], options);
        if (!status.ok()) return of_level(level, status);
        if (status = check_focus(mesh, bounds[level], options); !status.ok()) return status;
    }
    return {};
}

/// The first level starts from the original and takes this many times as long as each further one, more or less.
constexpr double work_of_first = 2;

ProgressSpan span_of(std::size_t level, std::size_t levels) {
    const double all = work_of_first + static_cast<double>(levels - 1);
    const auto reached = [&](std::size_t n) { return n == 0 ? 0 : (work_of_first + static_cast<double>(n - 1)) / all; };
    return {reached(level), reached(level + 1)};
}

MappedSurfaces to_last(const Mesh& mesh, const Levels& levels) {
    const std::size_t last = levels.levels.size() - 1;
    if (last == 0) return {mesh, levels.levels[0]};
    return {levels.levels[last - 1].mesh, levels.levels[last].mesh, levels.maps[last - 1]};
}

Status reduce_all(const Mesh& mesh, const LevelBounds& bounds, const LevelOptions& options, const MeshDefects& defects,
                  Levels& levels, ProgressReporter& reporter) {
    const bool tracked = options.reduction.errors == ErrorAccounting::tracked;
    const bool links = tracked && (options.maps || options.morphs), morphs = tracked && options.morphs;
    ReductionRun run(mesh, options.reduction, defects, reporter);
    for (std::size_t level = 0; level < bounds.size() && !reporter.cancelled(); ++level) {
        const bool linked = links && level > 0;
        LevelMap link;
        levels.levels.push_back(
            run.reduce_within(bounds[level], span_of(level, bounds.size()), linked ? &link : nullptr));
        if (linked && !reporter.cancelled()) levels.maps.push_back(std::move(link));
        if (!morphs || reporter.cancelled()) continue;
        Morph morph;
        Status status = make_morph(to_last(mesh, levels), morph, [&reporter](double) { return reporter.poll(); });
        if (!status.ok()) return of_level(level, status);
        if (!reporter.cancelled()) levels.morphs.push_back(std::move(morph));
        else levels.levels.back().report.termination = Termination::cancelled;
    }
    return {};
}

} // namespace

Status reduce_levels(const Mesh& mesh, const std::vector<Bounds>& bounds, const LevelOptions& options, Levels& levels,
                     const Progress& progress) {
    try {
        ProgressReporter reporter(progress);
        MeshDefects defects;
        if (Status status = validate(mesh, &defects); !status.ok()) return status;
        LevelBounds resolved;
        if (Status status = resolve_levels(mesh, bounds, resolved); !status.ok()) return status;
        if (Status status = check_options(mesh, options.reduction); !status.ok()) return status;
        if (Status status = check_together(mesh, resolved, options.reduction); !status.ok()) return status;
        reporter.poll();
        std::optional<double> feature;
        if (Status status = limit_to_feature_size(mesh, options.reduction, resolved, feature, reporter); !status.ok())
            return status;
        Levels reduced;
        if (Status status = reduce_all(mesh, resolved, options, defects, reduced, reporter); !status.ok())
            return status;
        for (Reduction& level : reduced.levels) level.report.feature_size = feature;
        levels = std::move(reduced);
        reporter.finish();
        return {};
    } catch (const std::bad_alloc&) {
        return out_of_memory("reducing", mesh.triangles.size(), " to " + std::to_string(bounds.size()) + " levels");
    }
}

} // namespace meshbound
