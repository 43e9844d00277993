#include "check_options.hpp"

#include <algorithm>
#include <string>

namespace meshbound {

Status check_options(const Mesh& mesh, const Options& options) {
    const std::vector<double>& sweeps = options.sweeps;
    const bool rising = std::adjacent_find(sweeps.begin(), sweeps.end(), [](double a, double b) { return !(a < b); }) ==
                        sweeps.end(); // NaN fails
    if (sweeps.empty() || !(sweeps.front() > 0) || sweeps.back() != 1 || !rising)
        return {Fault::bad_option, "The sweeps must be rising fractions above 0, the last one 1.", "", {}};
    for (std::size_t i = 0; i < options.locked.size(); ++i)
        if (options.locked[i] >= vertex_count(mesh))
            return {Fault::bad_option,
                    "Locked vertex " + std::to_string(options.locked[i]) + " does not exist; the mesh has " +
                        std::to_string(vertex_count(mesh)) + " vertices (counted from 0).",
                    "", i};
    return {};
}

} // namespace meshbound
