#include "settling.hpp"

#include "indexing.hpp"
#include "plane.hpp"

namespace meshbound {

auto Settling::difference(const double* row, const Settlement& settlement) const {
    const NewTriangle& triangle = tree_->triangle(settlement.triangle);
    const auto ring_row = [&](int i) { return rows_[hole_->ring[at(i)]]; };
    const glm::dvec3& w = settlement.weight;
    return MeasuredRows::blend_difference(row, ring_row(triangle.a), ring_row(triangle.m), ring_row(triangle.b), w.x,
                                          w.y, w.z);
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
    const double scaled = rows_.multipliers().scale_at(inner.vertex, here);
    if (choose_places_ && scaled > content_with * content_with * worst.squared_limit()) {
        if (inner.host == InnerVertex::Host::triangle) choose_place(n, row, settlement, here);
        else choose_share(row, settlement, here);
    }
    return worst.take(rows_.multipliers().scale_at(inner.vertex, here), difference(row, settlement));
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
        const JointTriangle::Nearest nearest = joints_[i].nearest(along);
        if (nearest.squared_distance >= rows_.variables() * error) continue;
        const Settlement chosen{static_cast<int>(i), nearest.weight};
        const double here = this->error(row, chosen);
        if (!(here < error)) continue;
        error = here;
        settlement = chosen;
    }
}

/// The same on the closing edge, which is the root's edge from a to b.
void Settling::choose_share(const double* row, Settlement& settlement, double& error) const {
    const NewTriangle& root = tree_->triangle(0);
    const JointSegment closing{rows_[hole_->ring[at(root.a)]], rows_[hole_->ring[at(root.b)]]};
    const double share = nearest_parameters(products_of(rows_, {row, row}, closing), 0, 0).y;
    const Settlement chosen{0, {1 - share, 0, share}};
    const double here = this->error(row, chosen);
    if (!(here < error)) return;
    error = here;
    settlement = chosen;
}

} // namespace meshbound
