#include <chrono>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include <emscripten/bind.h>
#include <emscripten/heap.h>
#include <emscripten/val.h>

#include "from_js.hpp"
#include "to_js.hpp"

namespace meshbound::js {

using emscripten::val;

namespace {

val success(const val& value) {
    val result = val::object();
    result.set("ok", true);
    result.set("value", value);
    return result;
}

val failure(const val& fault) {
    val result = val::object();
    result.set("ok", false);
    result.set("failure", fault);
    return result;
}

val failure(const Status& status) { return failure(failure_to(status)); }

/// What no documented fault explains: a mistake of this library, not of its caller.
val internal_failure(const char* message) {
    val fault = val::object();
    fault.set("code", "internal");
    fault.set("message", message);
    return failure(fault);
}

/// Runs a call so that no C++ exception ever reaches JavaScript, where it would be a number without a meaning.
template <class Call>
val guarded(Call call) {
    try {
        return call();
    } catch (const ShapeError& error) {
        return failure(error.status);
    } catch (const std::bad_alloc&) {
        return failure(
            {Fault::out_of_memory, "There is not enough memory for this mesh (WebAssembly has 4 GB).", {}, {}});
    } catch (const std::exception& error) {
        return internal_failure(error.what());
    } catch (...) {
        return internal_failure("An exception of unknown type was thrown.");
    }
}

/// `on_progress(progress)` returns whether to go on.
Progress progress_from(const val& on_progress) {
    return [&on_progress](double done) { return on_progress(done).as<bool>(); };
}

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

/// In bytes; a number of JavaScript, which a size of 4 GB does not overflow.
double memory_size() { return static_cast<double>(emscripten_get_heap_size()); }

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
