#include "errors/tracked/vertex_relocation.hpp"

#include <algorithm>

#include "geometry/plane.hpp"
#include "util/indexing.hpp"

namespace meshbound {

inline auto VertexRelocation::difference(const double* row, const VertexImage& image) const {
    const NewTriangle& triangle = tree_->triangle(image.triangle);
    const glm::dvec3& w = image.weight;
    return BoundedRows::blend_difference(row, products_.ring_row(triangle.a), products_.ring_row(triangle.m),
                                         products_.ring_row(triangle.b), w.x, w.y, w.z);
}

double VertexRelocation::error(const double* row, const VertexImage& image) const {
    return rows_.squared_ratio(difference(row, image));
}

bool VertexRelocation::relocate(const Hole& hole, const DualTree& tree, const Retriangulation& retriangulation,
                                const std::vector<InnerVertex>& inner, WorstError& worst) {
    hole_ = &hole;
    tree_ = &tree;
    retriangulation_ = &retriangulation;
    inner_ = &inner;
    joints_.clear();
    images_.clear();
    layout_.clear();
    for (std::size_t n = 0; n < inner.size(); ++n) {
        VertexImage image = locate(inner[n]);
        if (inner[n].container != InnerVertex::Container::link_edge && !relocate_vertex(n, image, worst)) return false;
        images_.push_back(image);
        layout_.push_back(layout_of(image));
    }
    return true;
}

glm::dvec2 VertexRelocation::layout_of(const VertexImage& image) const {
    const NewTriangle& triangle = tree_->triangle(image.triangle);
    const glm::dvec3& w = image.weight;
    return w.x * hole_->layout[to_index(triangle.a)] + w.y * hole_->layout[to_index(triangle.m)] +
           w.z * hole_->layout[to_index(triangle.b)];
}

bool VertexRelocation::relocate_vertex(std::size_t n, VertexImage& image, WorstError& worst) {
    const InnerVertex& inner = (*inner_)[n];
    const double* row = rows_[inner.vertex];
    double here = error(row, image);
    const auto scaled = [&] { return rows_.multipliers().scale_at(inner.vertex, here); };
    const bool free = inner.container == InnerVertex::Container::triangle,
               optimize = optimize_images_ && !inner.share_is_fixed;
    if (optimize && scaled() > worst.squared_threshold())
        free ? optimize_image(n, row, image, here) : optimize_share(row, image, here);
    if (optimize && scaled() > worst.squared_threshold())
        free ? optimize_image_minimax(n, row, image, here) : optimize_share_minimax(row, image, here);
    return worst.include(scaled(), [&] { return difference(row, image); });
}

/// The new triangle in which an inner vertex is laid out, found down the tree from the root; clamped where it lies in
/// none.
VertexRelocation::VertexImage VertexRelocation::locate(const InnerVertex& inner) const {
    const std::vector<glm::dvec2>& ring = hole_->layout;
    if (inner.container == InnerVertex::Container::closing_edge) return {0, {1 - inner.share, 0, inner.share}};
    int n = inner.container == InnerVertex::Container::link_edge ? tree_->at_link_edge(inner.link_edge) : 0;
    while (inner.container == InnerVertex::Container::triangle) {
        const NewTriangle& triangle = tree_->triangle(n);
        const glm::dvec2 &a = ring[to_index(triangle.a)], &m = ring[to_index(triangle.m)],
                         &b = ring[to_index(triangle.b)];
        if (triangle.left >= 0 && orientation(a, m, inner.layout) < 0) n = triangle.left;
        else if (triangle.right >= 0 && orientation(m, b, inner.layout) < 0) n = triangle.right;
        else break;
    }
    const NewTriangle& triangle = tree_->triangle(n);
    return {n, clamped_barycentric(inner.layout, ring[to_index(triangle.a)], ring[to_index(triangle.m)],
                                   ring[to_index(triangle.b)])};
}

/// Φ is free: any point of any triangle of the hole is a valid image, so the one with the smallest error is taken. The
/// points nearest in the joint space are tried; the error itself decides whether one is better.
void VertexRelocation::optimize_image(std::size_t n, const double* row, VertexImage& image, double& error) {
    if (joints_.empty())
        for (const NewTriangle& triangle : retriangulation_->triangles)
            joints_.emplace_back(products_, triangle.a, triangle.m, triangle.b);
    const double* along = products_.vertex(n);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const double limit = rows_.variables() * error;
        const JointTriangle::Nearest nearest = joints_[i].nearest(along, limit);
        if (nearest.squared_distance >= limit) continue;
        replace_if_better({static_cast<int>(i), nearest.weight}, row, image, error);
    }
}

/// The same, by the largest ratio instead of the sum of squares.
void VertexRelocation::optimize_image_minimax(std::size_t n, const double* row, VertexImage& image, double& error) {
    const double* along = products_.vertex(n);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const double limit = rows_.variables() * error;
        if (joints_[i].nearest(along, limit).squared_distance >= limit) continue;
        const NewTriangle& triangle = retriangulation_->triangles[i];
        minimax_.enter(within(
            {products_.ring_row(triangle.a), products_.ring_row(triangle.m), products_.ring_row(triangle.b)}, row));
        Minimax::Solution best{{0, 0}, error};
        minimax_.improve(best, [](const PlaneProducts& products) { return nearest_in_triangle(products); });
        if (!(best.squared_ratio < error)) continue;
        const glm::dvec3 weight(std::max(0.0, 1 - best.parameters.x - best.parameters.y), best.parameters.x,
                                best.parameters.y);
        replace_if_better({static_cast<int>(i), weight}, row, image, error);
    }
}

/// The closing edge, which is the root's edge from a to b.
JointSegment VertexRelocation::closing_edge() const {
    const NewTriangle& root = tree_->triangle(0);
    return {products_.ring_row(root.a), products_.ring_row(root.b)};
}

/// The same freedom on the closing edge.
void VertexRelocation::optimize_share(const double* row, VertexImage& image, double& error) {
    const double share = nearest_parameters(products_of(rows_, {row, row}, closing_edge()), 0, 0).y;
    replace_if_better({0, {1 - share, 0, share}}, row, image, error);
}

void VertexRelocation::optimize_share_minimax(const double* row, VertexImage& image, double& error) {
    minimax_.enter(between({row, row}, closing_edge()));
    Minimax::Solution best{{0, 0}, error};
    minimax_.improve(best, [](const PlaneProducts& products) { return nearest_parameters(products, 0, 0); });
    if (best.squared_ratio < error)
        replace_if_better({0, {1 - best.parameters.y, 0, best.parameters.y}}, row, image, error);
}

void VertexRelocation::replace_if_better(const VertexImage& chosen, const double* row, VertexImage& image,
                                         double& error) const {
    const double here = this->error(row, chosen);
    if (!(here < error)) return;
    error = here;
    image = chosen;
}

} // namespace meshbound
