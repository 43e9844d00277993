/// Reduces a PLY file natively and writes the bytes of the result, for the comparison with the WebAssembly module:
///
///     native_reduction IN.ply OUT propagated|tracked maximum|introduced
///
/// OUT holds the positions, the triangles, the kept vertices, and then the values and the largest errors of each variable.

#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "meshbound/meshbound.hpp"
#include "meshes/ply.hpp"

namespace {

using namespace meshbound;

Options options_from(const std::string& errors, const std::string& cost) {
    Options options;
    options.errors = errors == "tracked" ? Errors::tracked : Errors::propagated;
    options.cost = cost == "maximum" ? Cost::maximum : Cost::introduced;
    return options;
}

template <class T>
void write(std::ofstream& file, const std::vector<T>& values) {
    file.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

void write_reduction(const std::string& path, const Reduction& reduction) {
    std::ofstream file(path, std::ios::binary);
    const auto write_values = [&](const auto& values) { write(file, values); };
    std::visit(write_values, reduction.mesh.position.values);
    write(file, reduction.mesh.triangles);
    write(file, reduction.vertices);
    for (const Variable& variable : reduction.mesh.variables) std::visit(write_values, variable.values);
    for (const TriangleErrors& errors : reduction.triangle_errors) write(file, errors.largest);
}

void run(const std::vector<std::string>& arguments) {
    const Bounds bounds = {{"position", relative(0.01)}, {"*", relative(0.03)}};
    Reduction reduction;
    const Status status =
        reduce(meshes::read_ply(arguments.at(0)), bounds, options_from(arguments.at(2), arguments.at(3)), reduction);
    if (!status.ok()) throw std::runtime_error(status.message);
    write_reduction(arguments.at(1), reduction);
}

} // namespace

int main(int argc, char** argv) {
    try {
        run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
