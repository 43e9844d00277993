#pragma once

#include <exception>
#include <new>

#include <emscripten/val.h>

#include "from_js.hpp"
#include "meshbound/progress.hpp"
#include "meshbound/status.hpp"

namespace meshbound::js {

/// An `Outcome` of wasm/tasks.ts: a value …
emscripten::val success(const emscripten::val& value);

/// … or a fault with its place.
emscripten::val failure(const Status& status);

/// What no documented fault explains: a mistake of this library, not of its caller.
emscripten::val internal_failure(const char* message);

/// Runs a call so that no C++ exception ever reaches JavaScript, where it would be a number without a meaning.
template <class Call>
emscripten::val guarded(Call call) {
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

/// `on_progress(progress)` returns whether to go on; it must outlive what is returned.
Progress progress_from(const emscripten::val& on_progress);

/// How much memory the module has taken, in bytes; a number of JavaScript, which a size of 4 GB does not overflow.
double memory_size();

} // namespace meshbound::js
