#include "reduction/feature_limit.hpp"

#include <algorithm>
#include <string>

#include "metric/measured_bounds.hpp"
#include "meshbound/feature_size.hpp"
#include "util/number_text.hpp"

namespace meshbound {
namespace {

/// Of the progress of a reduction that looks for the feature size first.
constexpr double share_of_search = 0.1;

/// Each report of the search, after some hundred pairs of triangles, counts as this much work of the ticker.
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
                             std::optional<double>& size, Ticker& ticker) {
    if (!options.limit_to_feature_size) return {};
    double largest = 0;
    for (const std::vector<ResolvedBound>& bounds : levels) largest = std::max(largest, bounds[0].absolute);
    size = feature_size(mesh, 2 * largest,
                        [&](double done) { return ticker.tick(work_a_report, share_of_search * done); });
    ticker.start_from(share_of_search);
    if (!size) return {};
    for (std::vector<ResolvedBound>& bounds : levels) {
        bounds[0].absolute = std::min(bounds[0].absolute, *size / 2);
        if (!can_be_carried(bounds[0])) return too_fine(*size);
    }
    return {};
}

} // namespace meshbound
