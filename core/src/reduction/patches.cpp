#include "reduction/patches.hpp"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

#include "geometry/longest_side.hpp"

namespace meshbound {
namespace {

/// The cuts are taken from a sample of this size up to twice as much: enough to be even.
constexpr std::size_t sample_size = 2048;

/// The share of the vertices below the first cut, in turn.
constexpr std::array<double, 3> first_shares = {0.5, 0.42, 0.58};

} // namespace

Patches::Patches(const Rows& rows, const std::vector<std::uint32_t>& vertices, int depth, std::uint32_t shift)
    : first_leaf_(std::size_t{1} << depth), cuts_(first_leaf_), extents_(2 * first_leaf_) {
    std::vector<glm::dvec3> sample;
    const std::size_t stride = 1 + vertices.size() / (2 * sample_size);
    for (std::size_t i = 0; i < vertices.size(); i += stride) sample.push_back(rows.position(vertices[i]));
    cut(1, sample.begin(), sample.end(), first_shares[shift % first_shares.size()]);
    find_extents();
}

/// Cuts across the longest side of the sample's box. The sides follow from the coordinate of the cut, not from the
/// order in which std::nth_element leaves the sample: that differs between libraries.
void Patches::cut(std::size_t node, Sample first, Sample last, double share) {
    if (node >= first_leaf_) return;
    Cut& cut = cuts_[node];
    if (first != last) {
        glm::dvec3 lowest = *first, highest = *first;
        for (auto it = first; it != last; ++it) {
            lowest = glm::min(lowest, *it);
            highest = glm::max(highest, *it);
        }
        const glm::dvec3 side = highest - lowest;
        cut.axis = longest_side(side);
        const auto quantile = first + static_cast<std::ptrdiff_t>(share * static_cast<double>(last - first));
        std::nth_element(first, quantile, last,
                         [&](const glm::dvec3& p, const glm::dvec3& q) { return p[cut.axis] < q[cut.axis]; });
        cut.coordinate = (*quantile)[cut.axis];
    }
    const Sample middle =
        std::partition(first, last, [&](const glm::dvec3& p) { return p[cut.axis] < cut.coordinate; });
    this->cut(2 * node, first, middle, 0.5);
    this->cut(2 * node + 1, middle, last, 0.5);
}

void Patches::find_extents() {
    for (std::size_t node = 1; node < first_leaf_; ++node) {
        const Cut& cut = cuts_[node];
        Extent &below = extents_[2 * node], &above = extents_[2 * node + 1];
        below = above = extents_[node];
        below.high[cut.axis] = std::min(below.high[cut.axis], cut.coordinate); // a cut of nothing may lie outside
        above.low[cut.axis] = std::max(above.low[cut.axis], cut.coordinate);
    }
}

} // namespace meshbound
