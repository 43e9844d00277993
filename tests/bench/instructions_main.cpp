/// The fixed small run whose instructions are counted (tests/bench/instructions.ts):
///
///     instructions_run tracked|propagated|compiler
///
/// Prints how many triangles are left; with `compiler`, what the count depends on beside the sources.

#include <cstdint>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "meshbound/meshbound.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"

namespace {

using namespace meshbound;

std::string compiler() {
#ifdef __clang__
    std::string name = "Clang ";
#else
    std::string name = "GCC ";
#endif
#ifdef NDEBUG
    const std::string build = "release";
#else
    const std::string build = "with assertions";
#endif
    return name + __VERSION__ + ", " MESHBOUND_PROCESSOR ", " + build;
}

std::size_t triangles_left(Mesh mesh, ErrorAccounting errors) {
    meshes::add_usual_fields(mesh);
    Options options;
    options.errors = errors;
    options.threads = 1; // where several wait for each other is chance
    Reduction reduction;
    const Bounds bounds = {{"position", relative(0.01)}, {"*", relative(0.03)}};
    if (const Status status = reduce(mesh, bounds, options, reduction); !status.ok())
        throw std::runtime_error(status.message);
    return reduction.report.triangles_after;
}

} // namespace

int main(int, char** argv) {
    const std::string what = argv[1];
    if (what == "compiler") {
        std::cout << compiler() << '\n';
        return 0;
    }
    try {
        const ErrorAccounting errors = what == "tracked" ? ErrorAccounting::tracked : ErrorAccounting::propagated;
        std::cout << triangles_left(meshes::torus(48, 24), errors) + triangles_left(meshes::terrain(5, 8), errors)
                  << '\n';
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
