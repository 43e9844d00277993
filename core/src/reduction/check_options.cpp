#include "reduction/check_options.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace meshbound {

namespace {

/// NaN fails.
bool is_box(const Box& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.lowest[axis] <= box.highest[axis])) return false;
    return true;
}

Status check_locks(const Mesh& mesh, const Options& options) {
    for (std::size_t i = 0; i < options.locked.size(); ++i)
        if (options.locked[i] >= vertex_count(mesh))
            return {Fault::bad_option,
                    "Locked vertex " + std::to_string(options.locked[i]) + " does not exist; the mesh has " +
                        std::to_string(vertex_count(mesh)) + " vertices (counted from 0).",
                    "", i};
    for (std::size_t i = 0; i < options.locked_boxes.size(); ++i)
        if (!is_box(options.locked_boxes[i]))
            return {Fault::bad_option,
                    "Locked box " + std::to_string(i) +
                        " (counted from 0) is none: along some axis its lowest place is not below its highest.",
                    "", i};
    for (std::size_t i = 0; i < options.locked_regions.size(); ++i)
        if (std::find(mesh.regions.begin(), mesh.regions.end(), options.locked_regions[i]) == mesh.regions.end())
            return {Fault::bad_option,
                    "Locked region " + std::to_string(options.locked_regions[i]) +
                        " does not exist: no triangle has that label.",
                    "", i};
    return {};
}

bool is_free(const ResolvedBound& bound) { return !std::isfinite(bound.absolute); }

Status position_is_free(const std::string& wish) {
    return {Fault::bad_option, wish + " needs a bound of “position”, which is free.", "position", {}};
}

} // namespace

Status check_options(const Mesh& mesh, const Options& options) {
    const std::vector<double>& sweeps = options.sweeps;
    const bool rising = std::adjacent_find(sweeps.begin(), sweeps.end(), [](double a, double b) { return !(a < b); }) ==
                        sweeps.end(); // NaN fails
    if (sweeps.empty() || !(sweeps.front() > 0) || sweeps.back() != 1 || !rising)
        return {Fault::bad_option, "The sweeps must be rising fractions above 0, the last one 1.", "", {}};
    return check_locks(mesh, options);
}

Status check_feature_limit(const std::vector<ResolvedBound>& bounds, const Options& options) {
    if (!options.limit_to_feature_size || !is_free(bounds[0])) return {};
    return position_is_free("Limiting to the feature size");
}

Status check_small_parts(const std::vector<ResolvedBound>& bounds, const Options& options) {
    if (!options.drop_small_components || !is_free(bounds[0])) return {};
    return position_is_free("Leaving out small parts");
}

} // namespace meshbound
