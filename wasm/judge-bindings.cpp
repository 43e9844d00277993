// The judge (meshbound/verify.hpp) as a WebAssembly module of its own, which is loaded where something is verified. Nothing that
// reduces is linked with it, so what it says of a reduction does not rest on what made it. TypeScript enters through
// wasm/load-judge.ts.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "from_js.hpp"
#include "meshbound/verify.hpp"
#include "outcome.hpp"

namespace meshbound::js {

using emscripten::val;

namespace {

val number(std::size_t count) { return val(static_cast<double>(count)); }

template <class Numbers>
val list_of(const Numbers& numbers) {
    val list = val::array();
    for (const double each : numbers) {
        list.call<void>("push", each);
    }
    return list;
}

val deviation_to(const Deviation& deviation) {
    val result = val::object();
    result.set("ratio", deviation.ratio);
    result.set("triangle", number(deviation.triangle));
    result.set("barycentric", list_of(deviation.barycentric));
    result.set("position", list_of(deviation.position));
    result.set("variable", number(deviation.variable));
    result.set("samples", number(deviation.samples));
    return result;
}

val judgement_to(const Judgement& judgement) {
    val result = val::object();
    result.set("fromOriginal", deviation_to(judgement.from_original));
    result.set("fromReduced", deviation_to(judgement.from_reduced));
    return result;
}

/// A `Verdict` of wasm/types.ts.
val verdict_to(const Verdict& verdict) {
    val result = val::object();
    result.set("surface", judgement_to(verdict.surface));
    result.set("boundary", judgement_to(verdict.boundary));
    result.set("ratio", verdict.ratio());
    result.set("withinBounds", verdict.within_bounds());
    return result;
}

/// Reads an option that is a number of samples; left out, it stays as it is.
void read_count(const val& options, const char* option, std::size_t& count) {
    const val given = options[option];
    if (given.isUndefined()) {
        return;
    }
    const double value = given.isNumber() ? given.as<double>() : 0;
    if (!(value >= 1 && value <= std::numeric_limits<std::uint32_t>::max() && std::floor(value) == value)) {
        const std::string text = val::global("String")(given).as<std::string>();
        throw ShapeError{
            {Fault::bad_option,
             "The option " + std::string(option) + " cannot be “" + text + "”: it is a whole number from 1.",
             {},
             {}}};
    }
    count = static_cast<std::size_t>(value);
}

VerifyOptions options_from_js(const val& options) {
    VerifyOptions settings;
    read_count(options, "samples", settings.samples);
    read_count(options, "boundarySamples", settings.boundary_samples);
    if (const val multipliers = options["multipliers"]; !multipliers.isUndefined()) {
        settings.multipliers = emscripten::convertJSArrayToNumberVector<double>(multipliers);
    }
    return settings;
}

val verify_meshes(const val& original, const val& reduced, const val& options, const val& on_progress) {
    return guarded([&] {
        const Mesh one = mesh_from(original);
        const Mesh other = mesh_from(reduced);
        const auto bounds = emscripten::convertJSArrayToNumberVector<double>(options["bounds"]);
        Verdict verdict;
        const Status status = verify(one, other, bounds, options_from_js(options), verdict, progress_from(on_progress));
        return status.ok() ? success(verdict_to(verdict)) : failure(status);
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(meshbound_judge) {
    emscripten::function("verify", &verify_meshes);
    emscripten::function("memorySize", &memory_size);
}

} // namespace meshbound::js
