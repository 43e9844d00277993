#include "meshbound/reduce.hpp"
#include "meshbound/segmentation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

#include "map_output.hpp"
#include "propagation.hpp"
#include "rows.hpp"
#include "surface.hpp"
#include "sweep.hpp"
#include "ticker.hpp"
#include "tracking.hpp"

namespace meshbound {
namespace {

Status check_options(const Mesh& mesh, const Options& options) {
    const std::vector<double>& sweeps = options.sweeps;
    const bool rising = std::adjacent_find(sweeps.begin(), sweeps.end(), [](double a, double b) { return !(a < b); }) ==
                        sweeps.end(); // NaN fails
    if (sweeps.empty() || !(sweeps.front() > 0) || sweeps.back() != 1 || !rising)
        return {Fault::bad_option, "The sweeps must be rising fractions above 0, the last one 1.", "", {}};
    for (std::size_t i = 0; i < options.locked.size(); ++i)
        if (options.locked[i] >= vertex_count(mesh))
            return {Fault::bad_option,
                    "Locked vertex " + std::to_string(options.locked[i]) + " does not exist; the mesh has " +
                        std::to_string(vertex_count(mesh)) + " vertices (counted from 0).",
                    "", i};
    return {};
}

/// Interior and boundary vertices are candidates unless the user locked them (§3.1: all vertices are candidates).
std::vector<char> find_candidates(const Surface& surface, const std::vector<std::uint32_t>& locked) {
    std::vector<char> candidate(surface.vertex_count(), 0);
    for (std::uint32_t vertex = 0; vertex < candidate.size(); ++vertex)
        candidate[vertex] =
            surface.kind(vertex) == VertexKind::interior || surface.kind(vertex) == VertexKind::boundary;
    for (const std::uint32_t vertex : locked) candidate[vertex] = 0;
    return candidate;
}

/// Indices in the reduced mesh by those in the input: vertices in rising order, triangles in the order of their slots.
struct Renaming {
    std::vector<std::uint32_t> vertex, triangle;
};

Renaming extract_mesh(const Mesh& mesh, const Surface& surface, Reduction& reduction) {
    Renaming renamed{std::vector<std::uint32_t>(surface.vertex_count(), no_index),
                     std::vector<std::uint32_t>(surface.slot_count(), no_index)};
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        renamed.vertex[vertex] = static_cast<std::uint32_t>(reduction.vertices.size());
        reduction.vertices.push_back(vertex);
    }
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!surface.alive(slot)) continue;
        renamed.triangle[slot] = static_cast<std::uint32_t>(reduction.mesh.triangles.size());
        const auto corner = [&](std::uint32_t i) { return renamed.vertex[surface.origin(3 * slot + i)]; };
        reduction.mesh.triangles.push_back({corner(0), corner(1), corner(2)});
    }
    reduction.mesh.position = gather(mesh.position, reduction.vertices);
    for (const Variable& variable : mesh.variables)
        reduction.mesh.variables.push_back(gather(variable, reduction.vertices));
    return renamed;
}

/// Rounded up, so that the single-precision figure is still a bound.
float upper_float(double value) {
    const auto rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

void extract_errors(const Surface& surface, const Rows& rows, const Accounting& accounting, Reduction& reduction,
                    Ticker& ticker) {
    reduction.triangle_errors.resize(rows.groups().size());
    std::vector<ErrorRange> ranges;
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!ticker.tick(1)) return;
        if (!surface.alive(slot)) continue;
        accounting.errors(slot, ranges);
        for (const RowGroup& group : rows.groups()) {
            const ErrorRange& range = ranges[group.variable];
            const double unit = rows.unit(group);
            TriangleErrors& errors = reduction.triangle_errors[group.variable];
            VariableReport& report = reduction.report.variables[group.variable];
            report.error = std::max(report.error, range.largest * unit);
            if (group.bounded) report.ratio = std::max(report.ratio, range.largest);
            errors.largest.push_back(upper_float(range.largest * unit));
            if (group.count > 1 && group.variable != 0) continue;
            errors.lowest.push_back(-upper_float(-range.lowest * unit));
            errors.highest.push_back(upper_float(range.highest * unit));
        }
    }
}

void count_refusals(const Surface& surface, const Sweeper& sweeper, const std::vector<char>& candidate,
                    Report& report) {
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        if (!candidate[vertex]) {
            ++report.refused.fixed;
            continue;
        }
        const Verdict& verdict = sweeper.verdict(vertex);
        if (verdict.refusal == Refusal::topology) ++report.refused.topology;
        if (verdict.refusal == Refusal::fold) ++report.refused.fold;
        if (verdict.refusal == Refusal::bound) ++report.variables[verdict.variable].refused;
    }
}

Report begin_report(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Oddities& oddities) {
    Report report;
    report.triangles_before = mesh.triangles.size();
    report.vertices_before = vertex_count(mesh);
    report.oddities = oddities;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Variable& variable = i == 0 ? mesh.position : mesh.variables[i - 1];
        report.variables.push_back({variable.name, variable.components, bounds[i]});
    }
    return report;
}

std::unique_ptr<Accounting> make_accounting(const Options& options, const Rows& rows, const Surface& surface) {
    if (options.errors == Errors::tracked) return std::make_unique<Tracking>(rows, surface, options);
    return std::make_unique<Propagation>(rows, surface.slot_count(), options.cost);
}

/// A cancelled result says of its errors what the sweeps made sure of, without looking at every triangle.
void report_limits(Report& report) {
    for (VariableReport& variable : report.variables) {
        variable.error = variable.bound.absolute;
        variable.ratio = std::isfinite(variable.bound.absolute) ? 1 : 0;
    }
}

/// Everything that a finished result tells; incomplete where the ticker cancels.
void report_everything(const Mesh& mesh, const Surface& surface, const Rows& rows, const Accounting& accounting,
                       const Options& options, Reduction& reduction, Ticker& ticker) {
    const Renaming renamed = extract_mesh(mesh, surface, reduction);
    extract_errors(surface, rows, accounting, reduction, ticker);
    const auto* tracking = dynamic_cast<const Tracking*>(&accounting);
    if (!tracking) return;
    extract_map(surface, *tracking, renamed.vertex, renamed.triangle, reduction.map, ticker);
    extract_vertex_errors(rows, reduction, reduction.vertex_errors, ticker);
    if (!options.count_folds || ticker.cancelled()) return;
    Segmentation segmentation;
    segment(mesh, reduction, segmentation, [&ticker](double) { return ticker.ask(); });
    reduction.report.cells = segmentation.cells.size();
    reduction.report.folded_cells = segmentation.folded_cells;
}

/// What a cancelled call leaves: the surface as far as it got, and the bounds that it keeps.
void report_cancelled(const Mesh& mesh, const Surface& surface, Reduction& reduction) {
    Report report = std::move(reduction.report);
    reduction = {};
    extract_mesh(mesh, surface, reduction);
    report.stopped = Stopped::cancelled;
    report_limits(report);
    reduction.report = std::move(report);
}

/// Sweeping is this share of the progress; the rest is reporting.
constexpr double sweeping_share = 0.9;

void sweep_and_report(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Options& options,
                      Surface& surface, Reduction& reduction, Ticker& ticker) {
    const Rows rows(mesh, bounds);
    if (!ticker.ask()) return;
    const std::vector<char> candidate = find_candidates(surface, options.locked);
    const std::unique_ptr<Accounting> accounting = make_accounting(options, rows, surface);
    if (!ticker.ask()) return;
    Sweeper sweeper(surface, rows, *accounting, candidate);
    std::vector<double> limits = options.sweeps;
    for (double& limit : limits) limit *= rows.limit();
    if (!sweeper.sweep(limits, ticker, sweeping_share)) return;
    count_refusals(surface, sweeper, candidate, reduction.report);
    report_everything(mesh, surface, rows, *accounting, options, reduction, ticker);
}

Reduction run(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Options& options,
              const Oddities& oddities, Ticker& ticker) {
    Reduction reduction;
    reduction.report = begin_report(mesh, bounds, oddities);
    Surface surface(mesh.triangles, vertex_count(mesh));
    reduction.report.non_manifold_vertices = surface.count(VertexKind::fixed);
    if (ticker.ask()) sweep_and_report(mesh, bounds, options, surface, reduction, ticker);
    if (ticker.cancelled()) report_cancelled(mesh, surface, reduction);
    reduction.report.triangles_after = reduction.mesh.triangles.size();
    reduction.report.vertices_after = reduction.vertices.size();
    ticker.finish();
    return reduction;
}

} // namespace

Status reduce(const Mesh& mesh, const Bounds& bounds, const Options& options, Reduction& reduction,
              const Progress& progress) {
    try {
        Ticker ticker(progress);
        Oddities oddities;
        if (Status status = validate(mesh, &oddities); !status.ok()) return status;
        std::vector<ResolvedBound> resolved;
        if (Status status = resolve_bounds(mesh, bounds, resolved); !status.ok()) return status;
        if (Status status = check_options(mesh, options); !status.ok()) return status;
        ticker.ask();
        reduction = run(mesh, resolved, options, oddities, ticker);
        return {};
    } catch (const std::bad_alloc&) {
        return {Fault::out_of_memory,
                "There is no memory left for reducing " + std::to_string(mesh.triangles.size()) + " triangles.",
                "",
                {}};
    }
}

} // namespace meshbound
