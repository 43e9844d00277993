#include "errors/tracked/closing_shares.hpp"

#include <algorithm>
#include <tuple>

#include "errors/tracked/joint_space.hpp"
#include "errors/tracked/worst_error.hpp"

namespace meshbound {
namespace {

/// The closing edge, in the direction in which the first star has it.
JointSegment closing_edge(const BoundedRows& rows, const Hole& hole, bool forward) {
    const double *front = rows[hole.ring.front()], *back = rows[hole.ring.back()];
    return forward ? JointSegment{front, back} : JointSegment{back, front};
}

} // namespace

void ClosingShares::agree(const std::vector<Star>& stars, double squared_threshold) {
    struct ClassMember {
        std::uint32_t representative;
        std::size_t star;
        CurveVertex curve_vertex;
    };
    std::vector<ClassMember> all;
    for (std::size_t n = 0; n < stars.size(); ++n) {
        const std::vector<InnerVertex>& inner = stars[n].content->vertices();
        const bool forward = surface_.representative(stars[n].hole->ring.front()) ==
                             surface_.representative(stars[0].hole->ring.front());
        for (std::size_t i = 0; i < inner.size(); ++i)
            if (inner[i].container == InnerVertex::Container::closing_edge)
                all.push_back({surface_.representative(inner[i].vertex), n, {&stars[n], i, forward}});
    }
    std::sort(all.begin(), all.end(), [](const ClassMember& a, const ClassMember& b) {
        return std::tie(a.representative, a.star) < std::tie(b.representative, b.star);
    });
    std::vector<CurveVertex> curve_vertices;
    for (auto first = all.begin(); first != all.end();) {
        curve_vertices.clear();
        const std::uint32_t representative = first->representative;
        for (; first != all.end() && first->representative == representative; ++first)
            curve_vertices.push_back(first->curve_vertex);
        const double share = share_of(curve_vertices, squared_threshold);
        for (const CurveVertex& curve_vertex : curve_vertices)
            curve_vertex.star->content->fix_closing_share(curve_vertex.inner, curve_vertex.forward ? share : 1 - share,
                                                          *curve_vertex.star->hole);
    }
}

/// Along the closing edge of the first star: as laid out there, or where the errors on all stars are smallest together.
double ClosingShares::share_of(const std::vector<CurveVertex>& curve_vertices, double squared_threshold) const {
    const CurveVertex& first = curve_vertices.front();
    const double laid_out = first.star->content->vertices()[first.inner].share;
    const double share = first.forward ? laid_out : 1 - laid_out;
    const double here = error(curve_vertices, share);
    if (!optimize_ || !(here > squared_threshold)) return share;
    PlaneProducts sum;
    for (const CurveVertex& curve_vertex : curve_vertices) {
        const double* row = rows_[curve_vertex.star->content->vertices()[curve_vertex.inner].vertex];
        const PlaneProducts one =
            products_of(rows_, {row, row}, closing_edge(rows_, *curve_vertex.star->hole, curve_vertex.forward));
        sum.vv += one.vv;
        sum.vw += one.vw;
    }
    const double chosen = nearest_parameters(sum, 0, 0).y;
    return error(curve_vertices, chosen) < here ? chosen : share;
}

double ClosingShares::error(const std::vector<CurveVertex>& curve_vertices, double share) const {
    double worst = 0;
    for (const CurveVertex& curve_vertex : curve_vertices) {
        const std::uint32_t vertex = curve_vertex.star->content->vertices()[curve_vertex.inner].vertex;
        const JointSegment edge = closing_edge(rows_, *curve_vertex.star->hole, curve_vertex.forward);
        const double ratio = rows_.squared_ratio(
            BoundedRows::segment_difference(rows_[vertex], rows_[vertex], 0, edge.start, edge.end, share));
        worst = std::max(worst, rows_.multipliers().scale_at(vertex, ratio));
    }
    return worst;
}

} // namespace meshbound
