#include "errors/tracked/settling.hpp"

#include <algorithm>

#include "util/indexing.hpp"
#include "geometry/plane.hpp"

namespace meshbound {

inline auto Settling::difference(const double* row, const Settlement& settlement) const {
    const NewTriangle& triangle = tree_->triangle(settlement.triangle);
    const glm::dvec3& w = settlement.weight;
    return MeasuredRows::blend_difference(row, products_.ring_row(triangle.a), products_.ring_row(triangle.m),
                                          products_.ring_row(triangle.b), w.x, w.y, w.z);
}

double Settling::error(const double* row, const Settlement& settlement) const {
    return rows_.squared_ratio(difference(row, settlement));
}

bool Settling::settle(const Hole& hole, const HoleTree& tree, const Retriangulation& retriangulation,
                      const std::vector<InnerVertex>& inner, WorstError& worst) {
    hole_ = &hole;
    tree_ = &tree;
    retriangulation_ = &retriangulation;
    inner_ = &inner;
    joints_.clear();
    settlements_.clear();
    places_.clear();
    for (std::size_t n = 0; n < inner.size(); ++n) {
        Settlement settlement = locate(inner[n]);
        if (inner[n].host != InnerVertex::Host::rim && !settle_vertex(n, settlement, worst)) return false;
        settlements_.push_back(settlement);
        places_.push_back(place(settlement));
    }
    return true;
}

glm::dvec2 Settling::place(const Settlement& settlement) const {
    const NewTriangle& triangle = tree_->triangle(settlement.triangle);
    const glm::dvec3& w = settlement.weight;
    return w.x * hole_->places[at(triangle.a)] + w.y * hole_->places[at(triangle.m)] +
           w.z * hole_->places[at(triangle.b)];
}

bool Settling::settle_vertex(std::size_t n, Settlement& settlement, WorstError& worst) {
    const InnerVertex& inner = (*inner_)[n];
    const double* row = rows_[inner.vertex];
    double here = error(row, settlement);
    const auto scaled = [&] { return rows_.multipliers().scale_at(inner.vertex, here); };
    const bool free = inner.host == InnerVertex::Host::triangle, choose = choose_places_ && !inner.settled;
    if (choose && scaled() > worst.squared_content())
        free ? choose_place(n, row, settlement, here) : choose_share(row, settlement, here);
    if (choose && scaled() > worst.squared_content())
        free ? choose_place_tightly(n, row, settlement, here) : choose_share_tightly(row, settlement, here);
    return worst.take(scaled(), [&] { return difference(row, settlement); });
}

/// The new triangle in which an inner vertex lies, down the tree from the root; clamped where it lies in none.
Settling::Settlement Settling::locate(const InnerVertex& inner) const {
    const std::vector<glm::dvec2>& ring = hole_->places;
    if (inner.host == InnerVertex::Host::closing) return {0, {1 - inner.share, 0, inner.share}};
    int n = inner.host == InnerVertex::Host::rim ? tree_->at_rim(inner.rim) : 0;
    while (inner.host == InnerVertex::Host::triangle) {
        const NewTriangle& triangle = tree_->triangle(n);
        const glm::dvec2 &a = ring[at(triangle.a)], &m = ring[at(triangle.m)], &b = ring[at(triangle.b)];
        if (triangle.left >= 0 && orientation(a, m, inner.place) < 0) n = triangle.left;
        else if (triangle.right >= 0 && orientation(m, b, inner.place) < 0) n = triangle.right;
        else break;
    }
    const NewTriangle& triangle = tree_->triangle(n);
    return {n, clamped_barycentric(inner.place, ring[at(triangle.a)], ring[at(triangle.m)], ring[at(triangle.b)])};
}

/// The freedom of Φ: any place in any triangle of the hole is valid, so the one with the smallest error is taken. The sum of
/// squares parts the triangles; the error itself decides whether the best of them is better.
void Settling::choose_place(std::size_t n, const double* row, Settlement& settlement, double& error) {
    if (joints_.empty())
        for (const NewTriangle& triangle : retriangulation_->triangles)
            joints_.emplace_back(products_, triangle.a, triangle.m, triangle.b);
    const double* along = products_.vertex(n);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const double limit = rows_.variables() * error;
        const JointTriangle::Nearest nearest = joints_[i].nearest(along, limit);
        if (nearest.squared_distance >= limit) continue;
        take_better({static_cast<int>(i), nearest.weight}, row, settlement, error);
    }
}

/// The same, by the largest ratio.
void Settling::choose_place_tightly(std::size_t n, const double* row, Settlement& settlement, double& error) {
    const double* along = products_.vertex(n);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const double limit = rows_.variables() * error;
        if (joints_[i].nearest(along, limit).squared_distance >= limit) continue;
        const NewTriangle& triangle = retriangulation_->triangles[i];
        minimax_.enter(within(
            {products_.ring_row(triangle.a), products_.ring_row(triangle.m), products_.ring_row(triangle.b)}, row));
        Minimax::Place best{{0, 0}, error};
        minimax_.improve(best, [](const PlaneProducts& products) { return nearest_in_triangle(products); });
        if (!(best.squared_ratio < error)) continue;
        const glm::dvec3 weight(std::max(0.0, 1 - best.at.x - best.at.y), best.at.x, best.at.y);
        take_better({static_cast<int>(i), weight}, row, settlement, error);
    }
}

/// The closing edge, which is the root's edge from a to b.
JointSegment Settling::closing() const {
    const NewTriangle& root = tree_->triangle(0);
    return {products_.ring_row(root.a), products_.ring_row(root.b)};
}

/// The same freedom on the closing edge.
void Settling::choose_share(const double* row, Settlement& settlement, double& error) {
    const double share = nearest_parameters(products_of(rows_, {row, row}, closing()), 0, 0).y;
    take_better({0, {1 - share, 0, share}}, row, settlement, error);
}

void Settling::choose_share_tightly(const double* row, Settlement& settlement, double& error) {
    minimax_.enter(between({row, row}, closing()));
    Minimax::Place best{{0, 0}, error};
    minimax_.improve(best, [](const PlaneProducts& products) { return nearest_parameters(products, 0, 0); });
    if (best.squared_ratio < error) take_better({0, {1 - best.at.y, 0, best.at.y}}, row, settlement, error);
}

void Settling::take_better(const Settlement& chosen, const double* row, Settlement& settlement, double& error) const {
    const double here = this->error(row, chosen);
    if (!(here < error)) return;
    error = here;
    settlement = chosen;
}

} // namespace meshbound
