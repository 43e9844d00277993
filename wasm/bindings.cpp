#include <chrono>
#include <utility>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "from_js.hpp"
#include "outcome.hpp"
#include "to_js.hpp"

namespace meshbound::js {

using emscripten::val;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

val reduce_mesh(const val& mesh, const val& options, const val& on_progress) {
    return guarded([&] {
        const Mesh input = mesh_from(mesh);
        const Bounds bounds = bounds_from(options["bounds"]);
        const Options settings = options_from(options);

        const bool wanted = wants_checkpoint(options);
        Reduction reduction;
        Checkpoint checkpoint;
        const auto start = std::chrono::steady_clock::now();
        const Status status =
            reduce(input, bounds, settings, reduction, progress_from(on_progress), wanted ? &checkpoint : nullptr);
        const double seconds = seconds_since(start);
        if (!status.ok()) return failure(status);
        return success(reduction_to(reduction, seconds, wanted ? &checkpoint : nullptr));
    });
}

val resume_reduction(const val& checkpoint, const val& options, const val& on_progress) {
    return guarded([&] {
        const Checkpoint from = checkpoint_from(checkpoint);
        const Bounds bounds = bounds_from(options["bounds"]);
        const Options settings = options_from(options);

        Reduction reduction;
        const auto start = std::chrono::steady_clock::now();
        const Status status = resume_reduction(from, bounds, settings, reduction, progress_from(on_progress));
        const double seconds = seconds_since(start);
        return status.ok() ? success(reduction_to(reduction, seconds)) : failure(status);
    });
}

val reduce_mesh_to_levels(const val& mesh, const val& options, const val& on_progress) {
    return guarded([&] {
        const Mesh input = mesh_from(mesh);
        const std::vector<Bounds> bounds = level_bounds_from(options["levels"]);
        const LevelOptions settings = level_options_from(options);

        Levels levels;
        const auto start = std::chrono::steady_clock::now();
        const Status status = reduce_levels(input, bounds, settings, levels, progress_from(on_progress));
        const double seconds = seconds_since(start);
        return status.ok() ? success(levels_to(std::move(levels), seconds)) : failure(status);
    });
}

val segment_mesh(const val& mesh, const val& reduction, const val& on_progress) {
    return guarded([&] {
        const Mesh input = mesh_from(mesh);
        const Reduction output = mapped_reduction_from(reduction);
        Segmentation segmentation;
        const Status status = segment({input, output}, segmentation, progress_from(on_progress));
        return status.ok() ? success(segmentation_to(segmentation)) : failure(status);
    });
}

val inspect_mesh(const val& mesh) {
    return guarded([&] {
        const Mesh input = mesh_from(mesh);
        MeshDefects defects;
        if (const Status status = validate(input, &defects); !status.ok()) {
            return failure(status);
        }
        std::vector<ResolvedBound> bounds;
        if (const Status status = resolve_bounds(input, {{"*", unbounded()}}, bounds); !status.ok()) {
            return failure(status);
        }
        find_flipped_triangles(input, defects);
        return success(inspection_to(input, defects, bounds));
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(meshbound) {
    emscripten::function("reduce", &reduce_mesh);
    emscripten::function("resumeReduction", &resume_reduction);
    emscripten::function("reduceLevels", &reduce_mesh_to_levels);
    emscripten::function("segment", &segment_mesh);
    emscripten::function("inspect", &inspect_mesh);
    emscripten::function("memorySize", &memory_size);
}

} // namespace meshbound::js
