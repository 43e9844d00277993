// A hill of 32 × 32 cells that carries a temperature, reduced within bounds for both.
#include <iostream>
#include <vector>

#include <meshbound/meshbound.hpp>

namespace {

constexpr std::uint32_t cells = 32;

meshbound::Mesh hill() {
    meshbound::Mesh mesh;
    std::vector<double> position, temperature;
    for (std::uint32_t row = 0; row <= cells; ++row) {
        for (std::uint32_t column = 0; column <= cells; ++column) {
            const double x = 2.0 * column / cells - 1, y = 2.0 * row / cells - 1;
            position.insert(position.end(), {x, y, 0.4 / (1 + 4 * (x * x + y * y))});
            temperature.push_back(300 + 20 * x);
        }
    }
    for (std::uint32_t row = 0; row < cells; ++row) {
        for (std::uint32_t column = 0; column < cells; ++column) {
            const std::uint32_t corner = row * (cells + 1) + column, above = corner + cells + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{corner, corner + 1, above + 1}, {corner, above + 1, above}});
        }
    }
    mesh.position.values = position;
    mesh.variables = {{"temperature", 1, temperature}};
    return mesh;
}

} // namespace

int main() {
    using namespace meshbound;

    // Geometry within 1 % of the diagonal of its box, the temperature within half a degree.
    const Bounds bounds = {{"position", relative(0.01)}, {"temperature", absolute(0.5)}};
    Reduction reduction;
    if (const Status status = reduce(hill(), bounds, {}, reduction); !status.ok()) {
        std::cerr << status.message << '\n';
        return 1;
    }
    const Report& report = reduction.report;
    std::cout << report.triangles_before << " triangles became " << report.triangles_after << '\n';
    for (const VariableReport& variable : report.variables)
        std::cout << variable.name << ": at most " << variable.error << " of " << variable.bound.absolute << '\n';
}
