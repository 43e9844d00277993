#pragma once

#include "meshbound/api.hpp"
#include "meshbound/bounds.hpp"
#include "meshbound/checkpoint.hpp"
#include "meshbound/options.hpp"
#include "meshbound/reduction.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Resumes a reduction from a checkpoint, in a fraction of the time that a reduction from scratch takes, and gives the same guarantee:
/// every bound holds between the ORIGINAL and the result.
///
/// Why: let Φ map the original onto the checkpoint and Ψ the checkpoint onto the result. Ψ∘Φ is continuous and onto, maps boundary
/// to boundary, and for every point p and variable f |f(p) − f″(Ψ(Φ(p)))| ≤ |f(p) − f′(Φ(p))| + |f′(Φ(p)) − f″(Ψ(Φ(p)))|:
/// no more than what the checkpoint has spent of f and what this call spends. It spends no more than the bound less the former.
///
/// `reduction` has the shape that propagated errors give, whatever Options::errors says: vertices are indices into the
/// original, errors of triangles are upper bounds, the sums of what both reductions spent (Report::errors_are_upper_bounds); there is no map
/// and there are no vertex errors. Relative bounds are fractions of the original's extents. The result is seldom quite as
/// small as that from scratch and depends on the checkpoint: something to show until the other one is there.
///
/// It takes one sweep, whatever Options::sweeps says: the early ones led to the checkpoint. What is locked (Options::locked,
/// indices into the original; boxes; regions) stays as the checkpoint has it, which is as the original has it if that was locked
/// on the way there. With Options::refuse_piercing no triangles meet but those that met in
/// the checkpoint. Refused are what can only be judged by the original: bound_multiplier, limit_to_feature_size and drop_small_components.
///
/// Faults: those of reduce; bad_checkpoint, with the variable at fault: parts of the checkpoint contradict each other, it has
/// spent all that the bound of a variable allows, or it lacks a vertex that is to be locked (its index). `reduction` is then
/// untouched. Cancelled calls are as those of reduce.
MESHBOUND_API Status resume_reduction(const Checkpoint& checkpoint, const Bounds& bounds, const Options& options,
                                      Reduction& reduction, const Progress& progress = {});

} // namespace meshbound
