#pragma once

#include <cstdint>
#include <vector>

#include "errors/accounting.hpp"
#include "meshbound/reduce.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"
#include "reduction/sweep.hpp"
#include "util/team.hpp"
#include "util/ticker.hpp"

namespace meshbound {

/// Indices in the reduced mesh by those in the input: vertices in rising order, triangles in the order of their slots.
struct Renaming {
    std::vector<std::uint32_t> vertex, triangle;
};

/// What a report can say before anything is removed.
Report begin_report(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Oddities& oddities);

/// Writes the surface out as the reduced mesh, with the vertices that it keeps.
Renaming extract_mesh(const Mesh& mesh, const Surface& surface, Reduction& reduction);

/// The errors of every triangle and the largest of them all. Stops where the ticker cancels, incomplete.
void extract_errors(const Surface& surface, const Rows& rows, const Accounting& accounting, Reduction& reduction,
                    Team& team, Ticker& ticker);

/// Why each vertex that is still there could not go.
void count_refusals(const Surface& surface, const Sweeper& sweeper, Report& report);

/// How many vertices of the input are still there.
std::size_t count_vertices(const Surface& surface);

/// A cancelled result says of its errors what the sweeps made sure of, without looking at every triangle.
void report_limits(const Multipliers& multipliers, Report& report);

} // namespace meshbound
