#pragma once

#include <vector>

#include "errors/tracked/hole_products.hpp"
#include "errors/tracked/joint_space.hpp"
#include "errors/tracked/mapped_content.hpp"
#include "errors/tracked/worst_error.hpp"
#include "metric/bounded_rows.hpp"
#include "metric/minimax.hpp"
#include "retriangulation/dual_tree.hpp"

namespace meshbound {

/// Finds the images of the vertices in a hole on its new triangles: where the layout puts them or, where the error is
/// too high there and images are optimized, where it is smallest.
class VertexRelocation {
public:
    VertexRelocation(const BoundedRows& rows, HoleProducts& products, bool optimize_images)
        : rows_(rows), products_(products), optimize_images_(optimize_images), minimax_(rows) {}

    /// A point of a new triangle, by the weights of its corners a, m, b.
    struct VertexImage {
        int triangle = 0;
        glm::dvec3 weight{1, 0, 0};
    };

    /// Relocates all inner vertices; false as soon as an error is above the limit.
    bool relocate(const Hole& hole, const DualTree& tree, const Retriangulation& retriangulation,
                  const std::vector<InnerVertex>& inner, WorstError& worst);

    const std::vector<VertexImage>& images() const { return images_; } // by inner vertex
    /// The new triangle that has the image of an inner vertex.
    int triangle_of(int inner) const { return images_[static_cast<std::size_t>(inner)].triangle; }
    const std::vector<glm::dvec2>& layout() const { return layout_; } // in the plane

private:
    VertexImage locate(const InnerVertex& inner) const;
    bool relocate_vertex(std::size_t n, VertexImage& image, WorstError& worst);
    auto difference(const double* row, const VertexImage& image) const;
    double error(const double* row, const VertexImage& image) const;
    void optimize_image(std::size_t n, const double* row, VertexImage& image, double& error);
    void optimize_image_minimax(std::size_t n, const double* row, VertexImage& image, double& error);
    void optimize_share(const double* row, VertexImage& image, double& error);
    void optimize_share_minimax(const double* row, VertexImage& image, double& error);
    void replace_if_better(const VertexImage& chosen, const double* row, VertexImage& image, double& error) const;
    JointSegment closing_edge() const;
    glm::dvec2 layout_of(const VertexImage& image) const;

    const BoundedRows& rows_;
    HoleProducts& products_;
    bool optimize_images_;
    Minimax minimax_;
    const Hole* hole_ = nullptr;
    const DualTree* tree_ = nullptr;
    const std::vector<InnerVertex>* inner_ = nullptr;
    std::vector<JointTriangle> joints_; // by new triangle; made when the first image is optimized
    const Retriangulation* retriangulation_ = nullptr;
    std::vector<VertexImage> images_;
    std::vector<glm::dvec2> layout_;
};

} // namespace meshbound
