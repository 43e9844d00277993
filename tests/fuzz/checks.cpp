#include "fuzz/checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <set>
#include <vector>

#include "core/map_certificate.hpp"
#include "fuzz/kept_checks.hpp"
#include "judge/judge.hpp"
#include "meshes/sheet.hpp"
#include "meshes/topology.hpp"
#include "self_intersection/self_intersections.hpp"

namespace fuzz {
namespace {

using namespace meshbound;

/// A measured error may exceed its bound by so much of the bound, and by so much of the values, which is rounding.
constexpr double hair = 1e-6, rounding = 1e-14;
/// Errors of values beyond this, squared, are beyond any double.
constexpr double largest_measured = 1e150;

void check_subset(const Mesh& mesh, const Reduction& reduction) {
    for (std::size_t i = 1; i < reduction.vertices.size(); ++i)
        require(reduction.vertices[i - 1] < reduction.vertices[i], "vertices rise");
    require(gather(mesh.position, reduction.vertices).values == reduction.mesh.position.values,
            "positions bit for bit");
    for (std::size_t i = 0; i < mesh.variables.size(); ++i)
        require(gather(mesh.variables[i], reduction.vertices).values == reduction.mesh.variables[i].values,
                "values bit for bit");
}

/// Several sheets shorten a common curve at once, and triangles on the wrong side are turned: odd edges may become fewer.
void check_topology(const meshes::Topology& before, const meshes::Topology& after) {
    require(after.euler == before.euler, "the Euler number is kept");
    require(after.components == before.components, "components are kept");
    require(after.boundary_loops == before.boundary_loops, "boundary loops are kept");
    require(after.non_manifold_edges <= before.non_manifold_edges, "no edge of three triangles comes about");
    require(after.discordant_edges <= before.discordant_edges, "no triangle turns to the wrong side");
}

const Variable* bound_multiplier_of(const Mesh& mesh, const Options& options) {
    for (const Variable& variable : mesh.variables)
        if (variable.name == options.bound_multiplier) return &variable;
    return nullptr;
}

/// The map is continuous, and no error at its corners exceeds the bound as it is there.
void check_map(const Mesh& mesh, const Options& options, const Reduction& reduction) {
    const certificate::Certificate certificate(mesh, reduction);
    for (const std::string& fault : certificate.faults()) require(false, fault.c_str());
    const Variable* focus = bound_multiplier_of(mesh, options);
    const auto multiplier = [&](std::uint32_t vertex) { return focus ? value_at(*focus, vertex, 0) : 1; };
    for (std::size_t i = 0; i < reduction.report.variables.size(); ++i) {
        const ResolvedBound& bound = reduction.report.variables[i].bound;
        if (bound.magnitude > largest_measured) continue;
        const auto holds = [&](double error, double factor) {
            return error <= factor * bound.absolute * (1 + hair) + rounding * bound.magnitude;
        };
        for (std::uint32_t v = 0; v < reduction.map.images.size(); ++v)
            require(reduction.map.images[v].triangle == nowhere ||
                        holds(certificate.error_at_vertex(i, v), multiplier(v)),
                    "bounds hold at vertices");
        for (const MapCrossing& x : reduction.map.crossings) {
            const double p = multiplier(x.original.x), q = multiplier(x.original.y);
            require(holds(certificate.error_at_crossing(i, x), p + x.s * (q - p)), "bounds hold at crossings");
        }
    }
}

/// Where there is no map the judge looks, if bounds are coarse enough beside the values for its accuracy.
void check_judgement(const Mesh& mesh, const Options& options, const Reduction& reduction) {
    constexpr std::size_t fewest_samples = 1;
    constexpr double accurate = 1e6;
    std::vector<double> bounds, multipliers;
    for (const VariableReport& variable : reduction.report.variables) {
        const ResolvedBound& bound = variable.bound;
        if (bound.magnitude > std::min(accurate * bound.absolute, largest_measured)) return;
        bounds.push_back(bound.absolute);
    }
    if (const Variable* focus = bound_multiplier_of(mesh, options))
        for (std::size_t v = 0; v < vertex_count(mesh); ++v) multipliers.push_back(value_at(*focus, v, 0));
    const Verdict verdict =
        judge::verdict_of(mesh, reduction.mesh, bounds, {fewest_samples, fewest_samples, multipliers});
    require(verdict.within_bounds(), "the judge agrees");
}

/// Whether coordinates are within the range in which meeting is decided exactly (Options::refuse_piercing).
bool is_decided_exactly(const Mesh& mesh) {
    constexpr double least_share = 1e-150;
    double largest = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < vertex_count(mesh); ++v)
        for (int axis = 0; axis < 3; ++axis) {
            const double size = std::abs(value_at(mesh.position, v, axis));
            largest = std::max(largest, size);
            if (size > 0) least = std::min(least, size);
        }
    return least > least_share * largest;
}

/// Triangles of the result meet only if both are triangles of the input.
void check_piercing(const Mesh& mesh, const Reduction& reduction) {
    std::set<std::set<std::uint32_t>> before;
    for (const glm::uvec3& t : mesh.triangles) before.insert({t.x, t.y, t.z});
    std::vector<bool> is_new;
    for (const glm::uvec3& t : reduction.mesh.triangles) {
        const std::vector<std::uint32_t>& v = reduction.vertices;
        is_new.push_back(before.count({v[t.x], v[t.y], v[t.z]}) == 0);
    }
    const auto asked = [&](std::size_t one, std::size_t other) { return is_new[one] || is_new[other]; };
    require(judge::soup_intersections(reduction.mesh, asked).empty(), "no new triangle meets another");
}

void check_feature_size(const Options& options, const Report& report) {
    if (!report.feature_size) return;
    require(options.limit_to_feature_size, "the feature size limits only where asked for");
    require(report.variables[0].bound.absolute <= *report.feature_size / 2, "half the feature size is the limit");
}

void check_morph(const Morph& morph) {
    for (const MorphEnd* end : {&morph.finer, &morph.coarser}) {
        require(end->triangles.size() == morph.triangles.size(), "every piece lies in a triangle");
        for (const glm::uvec3& triangle : morph.triangles)
            for (int i = 0; i < 3; ++i) require(triangle[i] < end->points.size(), "corners exist");
        for (const MorphPoint& place : end->points) {
            const glm::dvec3& w = place.weights;
            require(std::abs(w.x + w.y + w.z - 1) < 1e-12, "places are mixtures");
        }
    }
}

} // namespace

void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

void check_reduction(const Mesh& mesh, const Options& options, const Reduction& reduction) {
    for (const VariableReport& variable : reduction.report.variables) require(variable.ratio <= 1, "bounds are kept");
    check_subset(mesh, reduction);
    require(validate(reduction.mesh).ok(), "the result is valid");
    // Triangles on one another are one of a sheet: that is what its topology, its map and what pierces it are about.
    const Mesh rest = meshes::without_copies(without_dropped(mesh, options, reduction));
    const Mesh sheet = meshes::one_sided(rest);
    const Reduction reduced_sheet = meshes::one_sided(reduction);
    check_topology(meshes::topology(sheet), meshes::topology(reduced_sheet.mesh));
    check_locks(meshes::without_copies(mesh), options, reduction);
    check_labels(rest, reduction);
    check_seams(sheet, reduction);
    check_feature_size(options, reduction.report);
    if (options.errors == ErrorAccounting::tracked) check_map(sheet, options, reduced_sheet);
    else if (!rest.triangles.empty()) check_judgement(rest, options, reduction);
    if (options.refuse_piercing && is_decided_exactly(mesh)) check_piercing(sheet, reduced_sheet);
}

void check_levels(const Mesh& mesh, const Options& options, const Levels& levels) {
    for (const Reduction& level : levels.levels) check_reduction(mesh, options, level);
    for (std::size_t i = 1; i < levels.levels.size(); ++i)
        for (const std::uint32_t vertex : levels.levels[i].vertices) {
            const std::vector<std::uint32_t>& finer = levels.levels[i - 1].vertices;
            require(std::binary_search(finer.begin(), finer.end(), vertex), "levels nest");
        }
    for (const Morph& morph : levels.morphs) check_morph(morph);
}

} // namespace fuzz
