// Feeds the core meshes, bounds and options that nobody would make on purpose. Whatever comes in, a reduction ends with a
// fault that has a message, or with a surface of the same topology that keeps what it guarantees under its options, as its own
// map proves; levels of detail nest besides, and morphs between them hang together. What is resumed from a checkpoint keeps
// the same guarantee, as the judge finds.
//
//     build/fuzz/tests/reduce_fuzz -max_total_time=60

#include <cstddef>
#include <cstdint>

#include "fuzz/checks.hpp"
#include "fuzz/inputs.hpp"
#include "meshbound/meshbound.hpp"

using namespace meshbound;

namespace {

/// Whether it went well; a fault has a message.
bool succeeds(const Status& status) {
    fuzz::require(status.ok() || !status.message.empty(), "faults have a message");
    return status.ok();
}

/// Bounds that are looser by a factor; a bound that makes no sense stays as it is.
Bounds looser(Bounds bounds, double factor) {
    for (NamedBound& entry : bounds) entry.bound.value *= factor;
    return bounds;
}

void try_levels(const Mesh& mesh, const Bounds& bounds, const Options& options, double factor) {
    Levels levels;
    const LevelOptions all{options, true, true};
    if (succeeds(reduce_levels(mesh, {bounds, looser(bounds, factor)}, all, levels)))
        fuzz::check_levels(mesh, options, levels);
}

/// From what a reduction passed on its way, and from its result.
void try_resuming(const Mesh& mesh, const Bounds& bounds, const Options& options, double factor) {
    Reduction reduction;
    Checkpoint passed;
    if (!succeeds(reduce(mesh, bounds, options, reduction, {}, &passed))) return;
    Options without_map = options;
    without_map.errors = ErrorAccounting::propagated;
    for (const Checkpoint& from : {passed, Checkpoint{reduction.mesh, reduction.vertices, reduction.report}}) {
        Reduction onward;
        if (succeeds(resume_reduction(from, looser(bounds, factor), options, onward)))
            fuzz::check_reduction(mesh, without_map, onward);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes bytes(data, size);
    const Mesh mesh = fuzz::make_mesh(bytes);
    const Bounds bounds = fuzz::make_bounds(bytes);
    const Options options = fuzz::make_options(bytes, mesh);
    Reduction reduction;
    if (!succeeds(reduce(mesh, bounds, options, reduction))) return 0;
    fuzz::check_reduction(mesh, options, reduction);
    if (const std::uint8_t coarser = bytes.byte()) try_levels(mesh, bounds, options, 1 + coarser / 16.0);
    if (const std::uint8_t looser_by = bytes.byte()) try_resuming(mesh, bounds, options, 1 + looser_by / 16.0);
    return 0;
}
