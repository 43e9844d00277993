/// Runs a simulation and writes its last state.
///
///     samples-simulator SCENE NX NY NZ FILE [--end TIME] [--walls|--periodic] [--threads N]
///
/// FILE gets the scene's variables one after the other, each with NX x NY x NZ numbers in single precision,
/// little-endian, x fastest, at the centres of the cells. Standard output gets one line of JSON that describes them.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

struct Arguments {
    Scene scene;
    std::array<int, 3> cells{};
    std::string file;
    int threads = 2;
};

Scene scene_named(const std::string& name) {
    for (Scene (*make)() : {fireballs, impact, shock_tube}) {
        if (make().name == name) {
            return make();
        }
    }
    throw std::runtime_error("There is no scene \"" + name + "\".");
}

int count_of(const std::string& word) {
    const int count = std::atoi(word.c_str());
    if (count < 1) {
        throw std::runtime_error("\"" + word + "\" is not a number of cells or threads.");
    }
    return count;
}

Arguments parse(const std::vector<std::string>& words) {
    if (words.size() < 5) {
        throw std::runtime_error(
            "samples-simulator SCENE NX NY NZ FILE [--end TIME] [--walls|--periodic] [--threads N]");
    }
    Arguments arguments;
    arguments.scene = scene_named(words[0]);
    arguments.cells = {count_of(words[1]), count_of(words[2]), count_of(words[3])};
    arguments.file = words[4];
    for (std::size_t i = 5; i < words.size(); ++i) {
        if (words[i] == "--walls") {
            arguments.scene.boundary = euler::Boundary::wall;
        } else if (words[i] == "--periodic") {
            arguments.scene.boundary = euler::Boundary::periodic;
        } else if (words[i] == "--end" && i + 1 < words.size()) {
            arguments.scene.end = std::stod(words[++i]);
        } else if (words[i] == "--threads" && i + 1 < words.size()) {
            arguments.threads = count_of(words[++i]);
        } else {
            throw std::runtime_error("Unknown argument \"" + words[i] + "\".");
        }
    }
    return arguments;
}

void write_variables(const Scene& scene, const euler::Flow& flow, const std::string& path) {
    std::ofstream out(path, std::ios::binary);
    std::vector<float> values(flow.grid().size());
    for (const auto& variable : scene.variables) {
        for (std::size_t cell = 0; cell < values.size(); ++cell) {
            values[cell] = variable.value(flow.at(cell));
        }
        out.write(reinterpret_cast<const char*>(values.data()), std::streamsize(values.size() * sizeof(float)));
    }
    if (!out) {
        throw std::runtime_error("Cannot write " + path + ".");
    }
}

void print_totals(const char* name, const euler::Totals& totals) {
    std::printf(R"("%s":{"mass":%.17g,"energy":%.17g,"partialMass":[%.17g,%.17g]})", name, totals.mass, totals.energy,
                totals.partial_mass[0], totals.partial_mass[1]);
}

void describe(const Scene& scene, const euler::Flow& flow, int steps, const euler::Totals& before) {
    const auto& grid = flow.grid();
    // The first value stands at the centre of the first cell.
    std::printf(R"({"scene":"%s","lengthUnit":"%s","cells":[%d,%d,%d],"origin":[%.9g,%.9g,%.9g],"spacing":%.9g,)",
                scene.name.c_str(), scene.length_unit.c_str(), grid.cells[0], grid.cells[1], grid.cells[2],
                grid.origin[0] + grid.spacing / 2, grid.origin[1] + grid.spacing / 2, grid.origin[2] + grid.spacing / 2,
                grid.spacing);
    std::printf(R"("end":%.9g,"steps":%d,)", scene.end, steps);
    print_totals("before", before);
    std::printf(",");
    print_totals("after", flow.totals());
    const char* separator = R"(,"variables":[)";
    for (const auto& variable : scene.variables) {
        std::printf(R"(%s{"name":"%s","unit":"%s"})", separator, variable.name.c_str(), variable.unit.c_str());
        separator = ",";
    }
    std::printf("]}\n");
}

} // namespace

int main(int count, char** words) {
    try {
        const Arguments arguments = parse({words + 1, words + count});
        const Scene& scene = arguments.scene;
        const euler::Grid grid{arguments.cells, scene.origin,
                               scene.length / *std::max_element(arguments.cells.begin(), arguments.cells.end())};
        euler::Flow flow(grid, scene.gamma, scene.boundary, scene.initial, arguments.threads);
        const euler::Totals before = flow.totals();
        const int steps = flow.advance(scene.end);
        write_variables(scene, flow, arguments.file);
        describe(scene, flow, steps, before);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
