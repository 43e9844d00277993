#include "reduction_output.hpp"

#include <algorithm>
#include <cmath>

#include "shared_loop.hpp"
#include "upper_float.hpp"

namespace meshbound {
namespace {

/// In a reduced triangle there may be much of the original.
constexpr std::size_t triangles_at_once = 16;

/// The error of a variable on the next triangle.
void add_error(const RowGroup& group, double unit, const ErrorRange& range, TriangleErrors& errors,
               VariableReport& report) {
    report.error = std::max(report.error, range.largest * unit);
    if (group.bounded) report.ratio = std::max(report.ratio, range.ratio);
    errors.largest.push_back(upper_float(range.largest * unit));
    errors.ratio.push_back(group.bounded ? upper_float(range.ratio) : 0);
    if (group.count > 1 && group.variable != 0) return;
    errors.lowest.push_back(-upper_float(-range.lowest * unit));
    errors.highest.push_back(upper_float(range.highest * unit));
}

} // namespace

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

Renaming extract_mesh(const Mesh& mesh, const Surface& surface, Reduction& reduction) {
    Renaming renamed{std::vector<std::uint32_t>(surface.vertex_count(), no_index),
                     std::vector<std::uint32_t>(surface.slot_count(), no_index)};
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        const std::uint32_t input = surface.input(vertex); // its copies are neighbours in the numbering
        if (reduction.vertices.empty() || reduction.vertices.back() != input) reduction.vertices.push_back(input);
        renamed.vertex[vertex] = static_cast<std::uint32_t>(reduction.vertices.size() - 1);
    }
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!surface.alive(slot)) continue;
        renamed.triangle[slot] = static_cast<std::uint32_t>(reduction.mesh.triangles.size());
        const auto corner = [&](std::uint32_t i) { return renamed.vertex[surface.origin(3 * slot + i)]; };
        reduction.mesh.triangles.push_back({corner(0), corner(1), corner(2)});
        if (!mesh.regions.empty()) reduction.mesh.regions.push_back(surface.region(slot));
    }
    reduction.mesh.position = gather(mesh.position, reduction.vertices);
    for (const Variable& variable : mesh.variables)
        reduction.mesh.variables.push_back(gather(variable, reduction.vertices));
    return renamed;
}

void extract_errors(const Surface& surface, const Rows& rows, const Accounting& accounting, Reduction& reduction,
                    Team& team, Ticker& ticker) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot)
        if (surface.alive(slot)) slots.push_back(slot);
    std::vector<std::vector<ErrorRange>> ranges(slots.size());
    const auto measure = [&](std::size_t, std::size_t i) { accounting.errors(slots[i], ranges[i]); };
    if (!share_out(team, ticker, slots.size(), triangles_at_once, measure)) return;
    for (const RowGroup& group : rows.groups()) {
        TriangleErrors& errors = reduction.triangle_errors.emplace_back();
        VariableReport& report = reduction.report.variables[group.variable];
        for (const std::vector<ErrorRange>& range : ranges)
            add_error(group, rows.unit(group), range[group.variable], errors, report);
    }
}

void count_refusals(const Surface& surface, const Sweeper& sweeper, const std::vector<char>& candidate,
                    Report& report) {
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent || surface.first_copy(surface.input(vertex)) != vertex) continue;
        const std::uint32_t site = surface.site(vertex);
        if (!candidate[site]) {
            ++report.refused.fixed;
            continue;
        }
        const Verdict& verdict = sweeper.verdict(site);
        if (verdict.refusal == Refusal::topology) ++report.refused.topology;
        if (verdict.refusal == Refusal::fold) ++report.refused.fold;
        if (verdict.refusal == Refusal::piercing) ++report.refused.piercing;
        if (verdict.refusal == Refusal::bound) ++report.variables[verdict.variable].refused;
    }
}

void report_limits(const Multipliers& multipliers, Report& report) {
    for (VariableReport& variable : report.variables) {
        variable.error = multipliers.most() * variable.bound.absolute;
        variable.ratio = std::isfinite(variable.bound.absolute) ? 1 : 0;
    }
}

} // namespace meshbound
