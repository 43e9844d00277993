#include "errors/tracked/closing_shares.hpp"

#include <algorithm>
#include <tuple>

#include "metric/joint_space.hpp"
#include "metric/worst_error.hpp"

namespace meshbound {
namespace {

/// The closing edge, as the first part has it.
JointSegment closing_edge(const MeasuredRows& rows, const Hole& hole, bool forward) {
    const double *front = rows[hole.ring.front()], *back = rows[hole.ring.back()];
    return forward ? JointSegment{front, back} : JointSegment{back, front};
}

} // namespace

void ClosingShares::agree(const std::vector<Part>& parts, double squared_content) {
    struct OfSite {
        std::uint32_t site;
        std::size_t part;
        Copy copy;
    };
    std::vector<OfSite> all;
    for (std::size_t n = 0; n < parts.size(); ++n) {
        const std::vector<InnerVertex>& inner = parts[n].content->vertices();
        const bool forward = surface_.site(parts[n].hole->ring.front()) == surface_.site(parts[0].hole->ring.front());
        for (std::size_t i = 0; i < inner.size(); ++i)
            if (inner[i].host == InnerVertex::Host::closing)
                all.push_back({surface_.site(inner[i].vertex), n, {&parts[n], i, forward}});
    }
    std::sort(all.begin(), all.end(),
              [](const OfSite& a, const OfSite& b) { return std::tie(a.site, a.part) < std::tie(b.site, b.part); });
    std::vector<Copy> copies;
    for (auto first = all.begin(); first != all.end();) {
        copies.clear();
        const std::uint32_t site = first->site;
        for (; first != all.end() && first->site == site; ++first) copies.push_back(first->copy);
        const double share = share_of(copies, squared_content);
        for (const Copy& copy : copies)
            copy.part->content->settle_on_closing(copy.inner, copy.forward ? share : 1 - share, *copy.part->hole);
    }
}

/// Along the closing edge of the first part: as laid out there, or where the errors of all copies are smallest.
double ClosingShares::share_of(const std::vector<Copy>& copies, double squared_content) const {
    const Copy& first = copies.front();
    const double laid_out = first.part->content->vertices()[first.inner].share;
    const double share = first.forward ? laid_out : 1 - laid_out;
    const double here = error(copies, share);
    if (!choose_ || !(here > squared_content)) return share;
    PlaneProducts sum;
    for (const Copy& copy : copies) {
        const double* row = rows_[copy.part->content->vertices()[copy.inner].vertex];
        const PlaneProducts one = products_of(rows_, {row, row}, closing_edge(rows_, *copy.part->hole, copy.forward));
        sum.vv += one.vv;
        sum.vw += one.vw;
    }
    const double chosen = nearest_parameters(sum, 0, 0).y;
    return error(copies, chosen) < here ? chosen : share;
}

double ClosingShares::error(const std::vector<Copy>& copies, double share) const {
    double worst = 0;
    for (const Copy& copy : copies) {
        const std::uint32_t vertex = copy.part->content->vertices()[copy.inner].vertex;
        const JointSegment edge = closing_edge(rows_, *copy.part->hole, copy.forward);
        const double ratio = rows_.squared_ratio(
            MeasuredRows::segment_difference(rows_[vertex], rows_[vertex], 0, edge.start, edge.end, share));
        worst = std::max(worst, rows_.multipliers().scale_at(vertex, ratio));
    }
    return worst;
}

} // namespace meshbound
