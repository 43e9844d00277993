#include "outcome.hpp"

#include <string>

#include <emscripten/heap.h>

namespace meshbound::js {

using emscripten::val;

namespace {

val failed(const val& fault) {
    val result = val::object();
    result.set("ok", false);
    result.set("failure", fault);
    return result;
}

} // namespace

val success(const val& value) {
    val result = val::object();
    result.set("ok", true);
    result.set("value", value);
    return result;
}

val failure(const Status& status) {
    val fault = val::object();
    fault.set("code", std::string(fault_name(status.fault)));
    fault.set("message", status.message);
    if (!status.variable.empty()) {
        fault.set("variable", status.variable);
    }
    if (status.index) {
        fault.set("index", static_cast<double>(*status.index));
    }
    return failed(fault);
}

val internal_failure(const char* message) {
    val fault = val::object();
    fault.set("code", "internal");
    fault.set("message", message);
    return failed(fault);
}

Progress progress_from(const val& on_progress) {
    return [&on_progress](double done) { return on_progress(done).as<bool>(); };
}

double memory_size() { return static_cast<double>(emscripten_get_heap_size()); }

} // namespace meshbound::js
