#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "judge/judge.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/topology.hpp"

/// What is guaranteed of every reduction, as checks that any test can make.
namespace guarantee {

using meshbound::Mesh;
using meshbound::Reduction;

/// The judge is exact to 1e-6 of a bound.
inline constexpr double hair = 1e-6;

/// The same bounds for geometry and for all variables, as fractions of their extents.
inline meshbound::Bounds percent(double geometry, double variables) {
    return {{"position", meshbound::relative(geometry / 100)}, {"*", meshbound::relative(variables / 100)}};
}

/// Reduces, expecting no fault.
inline Reduction reduced(const Mesh& mesh, const meshbound::Bounds& bounds, const meshbound::Options& options = {}) {
    Reduction reduction;
    const meshbound::Status status = meshbound::reduce(mesh, bounds, options, reduction);
    EXPECT_TRUE(status.ok()) << status.message;
    return reduction;
}

inline std::vector<double> absolute_bounds(const Reduction& reduction) {
    std::vector<double> bounds;
    for (const meshbound::VariableReport& variable : reduction.report.variables)
        bounds.push_back(variable.bound.absolute);
    return bounds;
}

inline double largest_ratio(const Reduction& reduction) {
    double largest = 0;
    for (const meshbound::VariableReport& variable : reduction.report.variables)
        largest = std::max(largest, variable.ratio);
    return largest;
}

/// The two surfaces lie within the bounds of each other in the joint space, their boundaries too, and the report does not
/// claim less than the judge sees.
inline void expect_judge_agrees(const Mesh& mesh, const Reduction& reduction, std::size_t samples = 20'000) {
    const std::vector<double> bounds = absolute_bounds(reduction);
    const auto [surface, boundary, cancelled] =
        judge::verdict_of(mesh, reduction.mesh, bounds, {samples, samples / 10, {}});
    EXPECT_LE(surface.ratio(), 1 + hair) << surface;
    EXPECT_LE(surface.ratio(), largest_ratio(reduction) + hair) << "the report claims less; " << surface;
    EXPECT_LE(boundary.ratio(), largest_ratio(reduction) + hair) << "boundary; " << boundary;
}

/// Same precision, same bits (a negative zero is not a zero).
inline bool same_bits(const meshbound::VariableView& one, const meshbound::VariableView& other) {
    return one.name == other.name && one.components == other.components && one.values.index() == other.values.index() &&
           std::visit(
               [&other](const auto& values) {
                   const auto& others = std::get<std::decay_t<decltype(values)>>(other.values);
                   return values.size() == others.size() &&
                          std::memcmp(values.data(), others.data(), values.size() * sizeof(values[0])) == 0;
               },
               one.values);
}

inline bool same_bits(const Mesh& one, const Mesh& other) {
    return one.triangles == other.triangles && same_bits(one.position, other.position) &&
           std::equal(one.variables.begin(), one.variables.end(), other.variables.begin(), other.variables.end(),
                      [](const meshbound::Variable& a, const meshbound::Variable& b) { return same_bits(a, b); });
}

/// The vertices are some of the original's, in rising order, with all their values.
inline void expect_vertex_subset(const Mesh& mesh, const Reduction& reduction) {
    const std::vector<std::uint32_t>& vertices = reduction.vertices;
    ASSERT_EQ(vertices.size(), vertex_count(reduction.mesh));
    EXPECT_EQ(std::adjacent_find(vertices.begin(), vertices.end(), std::greater_equal<>()), vertices.end());
    ASSERT_TRUE(vertices.empty() || vertices.back() < vertex_count(mesh));
    EXPECT_TRUE(same_bits(reduction.mesh.position, gather(mesh.position, vertices)));
    ASSERT_EQ(reduction.mesh.variables.size(), mesh.variables.size());
    for (std::size_t i = 0; i < mesh.variables.size(); ++i)
        EXPECT_TRUE(same_bits(reduction.mesh.variables[i], gather(mesh.variables[i], vertices)))
            << mesh.variables[i].name;
    std::vector<bool> used(vertices.size(), false);
    for (const glm::uvec3& t : reduction.mesh.triangles)
        for (int i = 0; i < 3; ++i) used.at(t[i]) = true;
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "vertices of no triangle";
}

/// Each loop of the reduced boundary passes through the vertices of one loop of the original's, in its direction, once
/// round; no two pass through the same. For manifolds.
inline void expect_boundary_order(const Mesh& mesh, const Reduction& reduction) {
    std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> places; // by original vertex: loop, place in it
    const auto original_loops = meshes::boundary_loops(mesh);
    for (std::size_t l = 0; l < original_loops.size(); ++l)
        for (std::size_t i = 0; i < original_loops[l].size(); ++i) places[original_loops[l][i]] = {l, i};
    std::map<std::size_t, int> visits;
    for (const auto& loop : meshes::boundary_loops(reduction.mesh)) {
        EXPECT_GE(loop.size(), 3U);
        std::size_t turns = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto here = places.find(reduction.vertices[loop[i]]);
            const auto next = places.find(reduction.vertices[loop[(i + 1) % loop.size()]]);
            ASSERT_TRUE(here != places.end() && next != places.end()) << "an inner vertex on the boundary";
            EXPECT_EQ(here->second.first, next->second.first) << "two loops have become one";
            turns += next->second.second <= here->second.second;
        }
        EXPECT_EQ(turns, 1U) << "not once round in the same direction";
        EXPECT_EQ(++visits[places[reduction.vertices[loop[0]]].first], 1);
    }
    EXPECT_EQ(visits.size(), original_loops.size());
}

/// How many triangles the edges have that have not just two, by the original's vertices on them.
inline std::map<std::uint32_t, std::set<std::size_t>> odd_edges(const Mesh& mesh,
                                                                const std::vector<std::uint32_t>& names) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> triangles;
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            if (t[i] != t[(i + 1) % 3]) ++triangles[std::minmax(t[i], t[(i + 1) % 3])];
    std::map<std::uint32_t, std::set<std::size_t>> found;
    for (const auto& [ends, count] : triangles)
        if (count > 2)
            for (const std::uint32_t end : {ends.first, ends.second})
                found[names.empty() ? end : names[end]].insert(count);
    return found;
}

/// Euler number, components and boundary loops are those of the original; edges of three or more triangles and of two that
/// disagree may be fewer, but are nowhere where the original has none alike.
inline void expect_same_topology(const Mesh& mesh, const Reduction& reduction) {
    const meshes::Topology before = meshes::topology(mesh), after = meshes::topology(reduction.mesh);
    EXPECT_EQ(after.euler, before.euler);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.boundary_loops, before.boundary_loops);
    EXPECT_EQ(after.non_manifold_edges > 0, before.non_manifold_edges > 0);
    EXPECT_EQ(after.discordant_edges > 0, before.discordant_edges > 0);
    const auto odd_before = odd_edges(mesh, {});
    for (const auto& [vertex, counts] : odd_edges(reduction.mesh, reduction.vertices)) {
        const auto found = odd_before.find(vertex);
        ASSERT_TRUE(found != odd_before.end()) << "vertex " << vertex << " was not on an edge of so many triangles";
        for (const std::size_t count : counts) EXPECT_TRUE(found->second.count(count)) << vertex << ", " << count;
    }
    if (before.non_manifold_edges == 0 && before.discordant_edges == 0) expect_boundary_order(mesh, reduction);
}

inline void expect_everything(const Mesh& mesh, const Reduction& reduction, std::size_t samples = 20'000) {
    expect_vertex_subset(mesh, reduction);
    expect_same_topology(mesh, reduction);
    expect_judge_agrees(mesh, reduction, samples);
}

} // namespace guarantee
