// The judge and Meshbound behind standard input and output, for compare.ts. One request a line, one answer a line:
//
//     surface PATH                the original from here on               -> surface TRIANGLES VARIABLES
//     bounds GEOMETRY VARIABLES   in percent, as Meshbound reads them     -> bounds ABSOLUTE... (position first)
//     beyond PATH                 the variable at fault (0 is position)   -> beyond VARIABLE, or beyond -1: it passes
//     ratio PATH                  what does it measure?                   -> ratio SURFACE BOUNDARY
//     reduce tracked|propagated   Meshbound, judged                       -> reduced TRIANGLES SECONDS SURFACE BOUNDARY
//
// Anything that goes wrong is answered with "error MESSAGE".

#include <chrono>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshbound/meshbound.hpp"
#include "meshes/ply.hpp"
#include "verdict.hpp"

namespace {

class Server {
public:
    std::string answer(const std::string& line) {
        std::istringstream words(line);
        std::string command;
        words >> command >> std::ws;
        if (command == "surface") return surface(rest(words));
        if (command == "bounds") return set_bounds(words);
        if (command == "beyond") return beyond(rest(words));
        if (command == "ratio") return "ratio " + judged(meshes::read_ply(rest(words)));
        if (command == "reduce") return reduce(rest(words));
        throw std::invalid_argument("no such request: " + command);
    }

private:
    static std::string rest(std::istringstream& words) {
        std::string text;
        std::getline(words, text);
        return text;
    }

    static void check(const meshbound::Status& status) {
        if (!status.ok()) throw std::runtime_error(status.message);
    }

    std::string surface(const std::string& path) {
        original = meshes::read_ply(path);
        verdict.reset();
        std::ostringstream out;
        out << "surface " << original.triangles.size() << ' ' << original.variables.size();
        return out.str();
    }

    std::string set_bounds(std::istringstream& words) {
        double geometry = 0, variables = 0;
        if (!(words >> geometry >> variables)) throw std::invalid_argument("bounds are two numbers");
        bounds = {{"position", meshbound::relative(geometry / 100)}, {"*", meshbound::relative(variables / 100)}};
        std::vector<meshbound::ResolvedBound> resolved;
        check(meshbound::resolve_bounds(original, bounds, resolved));
        std::ostringstream out;
        out.precision(std::numeric_limits<double>::max_digits10);
        out << "bounds";
        absolute.clear();
        for (const meshbound::ResolvedBound& bound : resolved) {
            absolute.push_back(bound.absolute);
            out << ' ' << bound.absolute;
        }
        verdict.reset();
        return out.str();
    }

    std::string beyond(const std::string& path) {
        if (!verdict) verdict = std::make_unique<peers::Verdict>(original, absolute);
        const std::optional<std::size_t> variable = verdict->beyond(meshes::read_ply(path));
        return variable ? "beyond " + std::to_string(*variable) : "beyond -1";
    }

    std::string judged(const meshbound::Mesh& reduced) const {
        meshbound::Verdict found;
        check(meshbound::verify(original, reduced, absolute, {}, found));
        std::ostringstream out;
        out << found.surface.ratio() << ' ' << found.boundary.ratio();
        return out.str();
    }

    std::string reduce(const std::string& errors) const {
        meshbound::Options options;
        options.errors =
            errors == "propagated" ? meshbound::ErrorAccounting::propagated : meshbound::ErrorAccounting::tracked;
        meshbound::Reduction reduction;
        const auto start = std::chrono::steady_clock::now();
        check(meshbound::reduce(original, bounds, options, reduction));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::ostringstream out;
        out << "reduced " << reduction.mesh.triangles.size() << ' ' << seconds.count() << ' ' << judged(reduction.mesh);
        return out.str();
    }

    meshbound::Mesh original;
    meshbound::Bounds bounds;
    std::vector<double> absolute;
    std::unique_ptr<peers::Verdict> verdict;
};

} // namespace

int main() {
    Server server;
    for (std::string line; std::getline(std::cin, line);) {
        try {
            std::cout << server.answer(line) << std::endl;
        } catch (const std::exception& fault) {
            std::cout << "error " << fault.what() << std::endl;
        }
    }
}
