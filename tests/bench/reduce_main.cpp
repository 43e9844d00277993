/// Times one reduction by Google Benchmark:
///
///     bench_reduce MESH.ply VARIABLE,... tracked|propagated THREADS [options of Google Benchmark]
///
/// with the bounds that every run of the benchmark has (tests/bench/case.ts). Beside its times it reports the triangles left
/// and the memory at the peak.

#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/peak_memory.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/ply.hpp"

namespace {

using namespace meshbound;

/// The mesh with those variables alone whose names the comma-separated list has, in its order.
Mesh with_variables(Mesh mesh, const std::string& names) {
    std::vector<Variable> chosen;
    std::stringstream list(names);
    for (std::string name; std::getline(list, name, ',');)
        for (Variable& variable : mesh.variables)
            if (variable.name == name) chosen.push_back(std::move(variable));
    mesh.variables = std::move(chosen);
    return mesh;
}

/// Options with so many threads, where the core has the option at all.
template <class AnyOptions>
AnyOptions with_threads(AnyOptions options, int threads) {
    if constexpr (requires { options.threads; }) {
        options.threads = static_cast<decltype(options.threads)>(threads);
    } else if (threads != 1) {
        throw std::runtime_error("The core knows one thread only.");
    }
    return options;
}

void reduce_repeatedly(benchmark::State& state, const Mesh& mesh, const Options& options, double bytes_before) {
    const Bounds bounds = {{"position", relative(0.01)}, {"*", relative(0.03)}};
    Report report;
    for (auto _ : state) {
        Reduction reduction;
        if (const Status status = reduce(mesh, bounds, options, reduction); !status.ok())
            throw std::runtime_error(status.message);
        report = reduction.report;
    }
    state.counters["triangles"] = static_cast<double>(report.triangles_before);
    state.counters["left"] = static_cast<double>(report.triangles_after);
    state.counters["peak_bytes"] = bench::peak_bytes() - bytes_before;
}

void run(int count, char** arguments) {
    const double bytes_before = bench::resident_bytes();
    const Mesh mesh = with_variables(meshes::read_ply(arguments[1]), arguments[2]);
    bench::forget_peak();

    Options options = with_threads(Options{}, std::atoi(arguments[4]));
    options.errors = std::string(arguments[3]) == "tracked" ? ErrorAccounting::tracked : ErrorAccounting::propagated;
    benchmark::RegisterBenchmark(
        "reduce", [&](benchmark::State& state) { reduce_repeatedly(state, mesh, options, bytes_before); })
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);

    int rest = count - 4;
    benchmark::Initialize(&rest, arguments + 4);
    benchmark::RunSpecifiedBenchmarks();
}

} // namespace

int main(int count, char** arguments) {
    try {
        run(count, arguments);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
