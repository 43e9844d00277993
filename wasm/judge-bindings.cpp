// The judge of tests/judge as a WebAssembly module of its own. Nothing of the reducer is linked with it, so what it says of
// a reduction does not rest on what made it. TypeScript enters through wasm/judge-module.ts.

#include <array>
#include <cstddef>
#include <exception>
#include <new>
#include <string>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "from_js.hpp"
#include "judge/judge.hpp"

namespace meshbound::js {

using emscripten::val;

namespace {

val number(std::size_t count) { return val(static_cast<double>(count)); }

val triple(const std::array<double, 3>& numbers) {
    val list = val::array();
    for (const double each : numbers) {
        list.call<void>("push", each);
    }
    return list;
}

val deviation_to(const judge::Deviation& deviation) {
    val result = val::object();
    result.set("ratio", deviation.ratio);
    result.set("triangle", number(deviation.triangle));
    result.set("barycentric", triple(deviation.barycentric));
    result.set("position", triple(deviation.position));
    result.set("variable", number(deviation.variable));
    result.set("samples", number(deviation.samples));
    return result;
}

val judgement_to(const judge::Judgement& judgement) {
    val result = val::object();
    result.set("fromOriginal", deviation_to(judgement.from_original));
    result.set("fromReduced", deviation_to(judgement.from_reduced));
    return result;
}

val failure(const std::string& code, const std::string& message) {
    val fault = val::object();
    fault.set("code", code);
    fault.set("message", message);
    val result = val::object();
    result.set("ok", false);
    result.set("failure", fault);
    return result;
}

val judge_meshes(const val& original, const val& reduced, const val& bounds, double samples, const val& multipliers) {
    try {
        const Mesh one = mesh_from(original);
        const Mesh other = mesh_from(reduced);
        const auto limits = emscripten::convertJSArrayToNumberVector<double>(bounds);
        const auto factors = emscripten::convertJSArrayToNumberVector<double>(multipliers);
        const auto budget = static_cast<std::size_t>(samples);
        val verdict = val::object();
        verdict.set("surface", judgement_to(judge::judge(one, other, limits, budget, factors)));
        verdict.set("boundary", judgement_to(judge::judge_boundary(one, other, limits, budget, factors)));
        val result = val::object();
        result.set("ok", true);
        result.set("value", verdict);
        return result;
    } catch (const std::bad_alloc&) {
        return failure("out_of_memory", "There is not enough memory to judge these surfaces (WebAssembly has 4 GB).");
    } catch (const std::exception& error) {
        return failure("internal", error.what());
    }
}

} // namespace

EMSCRIPTEN_BINDINGS(meshbound_judge) { emscripten::function("judge", &judge_meshes); }

} // namespace meshbound::js
