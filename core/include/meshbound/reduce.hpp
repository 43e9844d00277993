#pragma once

#include "meshbound/api.hpp"
#include "meshbound/bounds.hpp"
#include "meshbound/checkpoint.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/progress.hpp"
#include "meshbound/reduction.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Reduces a mesh so that every bound holds at every point of its surface:
///
/// > There is a continuous map from the original surface onto the reduced one that moves no point by more than the bound
/// > of `position` and changes no variable by more than its bound.
///
/// With Options::bound_multiplier it changes none by more than the bound times the multiplier at the original point.
///
/// Boundaries map to boundaries; genus, components and boundary loops are kept. The vertices of the result are a subset of
/// the input's, with their values bit for bit. The same input gives the same bytes on every machine.
///
/// Source: Bajaj & Schikore 1996, §3. Faults: those of validate and resolve_bounds, bad_option, too_large, out_of_memory;
/// `reduction` is then untouched. A cancelled call returns an ok status and a valid mesh, marked as cancelled; so that it
/// answers at once, its report gives the bounds for errors, and map, triangle and vertex errors are empty.
///
/// `checkpoint`, where given, is filled with the surface before the last sweep, which lies within the share of the bounds of the
/// sweep before that; Options::sweeps must have two sweeps at least. It changes nothing else, and takes a few percent of the
/// time, for its errors are measured. A call that is cancelled before leaves it untouched.
MESHBOUND_API Status reduce(const Mesh& mesh, const Bounds& bounds, const Options& options, Reduction& reduction,
                            const Progress& progress = {}, Checkpoint* checkpoint = nullptr);

} // namespace meshbound
