#include "reduction/reduction_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/round_up_to_float.hpp"
#include "util/parallel_for.hpp"

namespace meshbound {
namespace {

/// Few, since much of the original may be mapped into one reduced triangle.
constexpr std::size_t triangles_per_chunk = 16;

/// Of two errors; NaN, which is one that is not known, where either is.
double larger(double one, double other) { return std::isnan(one) || one > other ? one : other; }

/// Measures the errors on one triangle after the other, and the largest of them.
class TriangleMeasurement {
public:
    TriangleMeasurement(const Rows& rows, const ErrorModel& error_model)
        : rows_(rows), error_model_(error_model), largest_(rows.groups().size()) {}

    /// Writes the errors on the triangle in `slot` down as those of the reduced triangle `i`.
    void measure(std::uint32_t slot, std::size_t i, std::vector<TriangleErrors>& errors) {
        error_model_.errors(slot, ranges_);
        for (const RowGroup& group : rows_.groups()) {
            const ErrorRange& range = ranges_[group.variable];
            if (range.known) write(group, range, i, errors[group.variable]);
            else write_unknown(group, i, errors[group.variable]);
        }
    }

    void add_to(Report& report) const {
        for (std::size_t i = 0; i < largest_.size(); ++i) {
            VariableReport& variable = report.variables[i];
            variable.error = larger(variable.error, largest_[i].error);
            variable.ratio = std::max(variable.ratio, largest_[i].ratio);
        }
    }

private:
    struct Largest {
        double error = 0, ratio = 0;
    };

    void write(const RowGroup& group, const ErrorRange& range, std::size_t i, TriangleErrors& out) {
        const double unit = rows_.unit(group);
        out.largest[i] = round_up_to_float(range.largest * unit);
        out.ratio[i] = group.bounded ? round_up_to_float(range.ratio) : 0;
        Largest& largest = largest_[group.variable];
        largest.error = larger(largest.error, range.largest * unit);
        if (group.bounded) largest.ratio = std::max(largest.ratio, range.ratio);
        if (out.lowest.empty()) return;
        out.lowest[i] = -round_up_to_float(-range.lowest * unit);
        out.highest[i] = round_up_to_float(range.highest * unit);
    }

    void write_unknown(const RowGroup& group, std::size_t i, TriangleErrors& out) {
        constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
        out.largest[i] = unknown;
        out.ratio[i] = 0; // it is free
        largest_[group.variable].error = std::numeric_limits<double>::quiet_NaN();
        if (!out.lowest.empty()) out.lowest[i] = out.highest[i] = unknown;
    }

    const Rows& rows_;
    const ErrorModel& error_model_;
    std::vector<Largest> largest_;   // by variable
    std::vector<ErrorRange> ranges_; // of the last triangle
};

std::vector<TriangleErrors> room_for(std::size_t triangles, const Rows& rows) {
    std::vector<TriangleErrors> errors(rows.groups().size());
    for (const RowGroup& group : rows.groups()) {
        TriangleErrors& of_variable = errors[group.variable];
        const std::size_t with_sign = group.count == 1 || group.variable == 0 ? triangles : 0;
        of_variable.largest.resize(triangles);
        of_variable.ratio.resize(triangles);
        of_variable.lowest.resize(with_sign);
        of_variable.highest.resize(with_sign);
    }
    return errors;
}

} // namespace

Report begin_report(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const MeshDefects& defects) {
    Report report;
    report.triangles_before = mesh.triangles.size();
    report.vertices_before = vertex_count(mesh);
    report.defects = defects;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const VariableView variable = variable_of(mesh, i);
        report.variables.push_back({std::string(variable.name), variable.components, variable.kind, bounds[i]});
    }
    return report;
}

ReducedIndices extract_mesh(const Mesh& mesh, const Surface& surface, Reduction& reduction) {
    ReducedIndices reduced{std::vector<std::uint32_t>(surface.vertex_count(), no_index),
                           std::vector<std::uint32_t>(surface.slot_count(), no_index)};
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        const std::uint32_t input = surface.input(vertex); // its vertices are consecutive
        if (reduction.vertices.empty() || reduction.vertices.back() != input) reduction.vertices.push_back(input);
        reduced.vertex[vertex] = static_cast<std::uint32_t>(reduction.vertices.size() - 1);
    }
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!surface.alive(slot)) continue;
        reduced.triangle[slot] = static_cast<std::uint32_t>(reduction.mesh.triangles.size());
        const auto corner = [&](std::uint32_t i) { return reduced.vertex[surface.origin(3 * slot + i)]; };
        reduction.mesh.triangles.push_back({corner(0), corner(1), corner(2)});
        if (surface.has_regions()) reduction.mesh.regions.push_back(surface.region(slot));
    }
    reduction.mesh.position = gather(mesh.position, reduction.vertices);
    for (const Variable& variable : mesh.variables)
        reduction.mesh.variables.push_back(gather(variable, reduction.vertices));
    return reduced;
}

void extract_errors(const Surface& surface, const Rows& rows, const ErrorModel& error_model, Reduction& reduction,
                    ThreadPool& pool, ProgressReporter& reporter) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot)
        if (surface.alive(slot)) slots.push_back(slot);
    reduction.triangle_errors = room_for(slots.size(), rows);
    pool.start();
    std::vector<TriangleMeasurement> measurements(pool.size(), TriangleMeasurement(rows, error_model));
    const auto measure = [&](std::size_t worker, std::size_t i) {
        measurements[worker].measure(slots[i], i, reduction.triangle_errors);
    };
    if (parallel_for(pool, reporter, slots.size(), triangles_per_chunk, measure))
        for (const TriangleMeasurement& measurement : measurements) measurement.add_to(reduction.report);
    else reduction.triangle_errors.clear();
}

void count_refusals(const Surface& surface, const Sweeper& sweeper, Report& report) {
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent || surface.first_vertex_of(surface.input(vertex)) != vertex)
            continue;
        const std::uint32_t representative = surface.representative(vertex);
        if (!sweeper.is_candidate(representative)) {
            ++(surface.is_removable(representative) ? report.refused.locked : report.refused.non_manifold);
            continue;
        }
        const RemovalOutcome& outcome = sweeper.outcome(representative);
        if (outcome.refusal == Refusal::ring) ++report.refused.ring;
        if (outcome.refusal == Refusal::topology) ++report.refused.topology;
        if (outcome.refusal == Refusal::fold) ++report.refused.fold;
        if (outcome.refusal == Refusal::self_intersection) ++report.refused.piercing;
        if (outcome.refusal == Refusal::bound) ++report.variables[outcome.variable].refused;
    }
}

std::size_t count_vertices(const Surface& surface) {
    std::size_t count = 0;
    std::uint32_t last = no_index; // the vertices of one input vertex are consecutive
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent || surface.input(vertex) == last) continue;
        last = surface.input(vertex);
        ++count;
    }
    return count;
}

void report_limits(const Multipliers& multipliers, Report& report) {
    for (VariableReport& variable : report.variables) {
        variable.error = multipliers.most() * variable.bound.absolute;
        variable.ratio = std::isfinite(variable.bound.absolute) ? 1 : 0;
    }
}

} // namespace meshbound
