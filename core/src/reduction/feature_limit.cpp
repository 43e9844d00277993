#include "reduction/feature_limit.hpp"

#include <algorithm>
#include <string>

#include "meshbound/feature_size.hpp"
#include "metric/measured_bounds.hpp"
#include "util/number_text.hpp"

namespace meshbound {
namespace {

/// The share of the progress that the search for the feature size has.
constexpr double share_of_search = 0.1;

/// Each report of the search, after some hundred pairs of triangles, counts as this much work for the reporter.
constexpr std::size_t work_a_report = 64;

Status too_fine(double size) {
    return {Fault::bound_too_fine,
            "Two lobes of the surface are " + number_text(size) +
                " apart; a bound of “position” that is half of that is finer than double precision can carry.",
            "position",
            {}};
}

} // namespace

Status limit_to_feature_size(const Mesh& mesh, const Options& options, std::vector<std::vector<ResolvedBound>>& levels,
                             std::optional<double>& size, ProgressReporter& reporter) {
    if (!options.limit_to_feature_size) return {};
    double largest = 0;
    for (const std::vector<ResolvedBound>& bounds : levels) largest = std::max(largest, bounds[0].absolute);
    size = feature_size(mesh, 2 * largest,
                        [&](double done) { return reporter.advance(work_a_report, share_of_search * done); });
    reporter.start_from(share_of_search);
    if (!size) return {};
    for (std::vector<ResolvedBound>& bounds : levels) {
        bounds[0].absolute = std::min(bounds[0].absolute, *size / 2);
        if (!can_be_carried(bounds[0])) return too_fine(*size);
    }
    return {};
}

} // namespace meshbound
