#pragma once

#include <vector>

#include "errors/tracked/hole_content.hpp"
#include "errors/tracked/hole_products.hpp"
#include "retriangulation/hole_tree.hpp"
#include "metric/joint_space.hpp"
#include "metric/measured_rows.hpp"
#include "metric/minimax.hpp"
#include "metric/worst_error.hpp"

namespace meshbound {

/// Where the vertices in a hole settle among its new triangles: where the layout puts them or, where the error is too high
/// there and the map is free, where it is smallest.
class Settling {
public:
    Settling(const MeasuredRows& rows, HoleProducts& products, bool choose_places)
        : rows_(rows), products_(products), choose_places_(choose_places), minimax_(rows) {}

    /// At the corners a, m, b of a new triangle.
    struct Settlement {
        int triangle = 0;
        glm::dvec3 weight{1, 0, 0};
    };

    /// Settles all inner vertices; false as soon as an error is above the limit.
    bool settle(const Hole& hole, const HoleTree& tree, const Retriangulation& retriangulation,
                const std::vector<InnerVertex>& inner, WorstError& worst);

    const std::vector<Settlement>& settlements() const { return settlements_; } // by inner vertex
    /// The new triangle in which an inner vertex has settled.
    int triangle_of(int inner) const { return settlements_[static_cast<std::size_t>(inner)].triangle; }
    const std::vector<glm::dvec2>& places() const { return places_; } // in the plane

private:
    Settlement locate(const InnerVertex& inner) const;
    bool settle_vertex(std::size_t n, Settlement& settlement, WorstError& worst);
    auto difference(const double* row, const Settlement& settlement) const;
    double error(const double* row, const Settlement& settlement) const;
    void choose_place(std::size_t n, const double* row, Settlement& settlement, double& error);
    void choose_place_tightly(std::size_t n, const double* row, Settlement& settlement, double& error);
    void choose_share(const double* row, Settlement& settlement, double& error);
    void choose_share_tightly(const double* row, Settlement& settlement, double& error);
    void take_better(const Settlement& chosen, const double* row, Settlement& settlement, double& error) const;
    JointSegment closing() const;
    glm::dvec2 place(const Settlement& settlement) const;

    const MeasuredRows& rows_;
    HoleProducts& products_;
    bool choose_places_;
    Minimax minimax_;
    const Hole* hole_ = nullptr;
    const HoleTree* tree_ = nullptr;
    const std::vector<InnerVertex>* inner_ = nullptr;
    std::vector<JointTriangle> joints_; // by new triangle; made when the first place is chosen
    const Retriangulation* retriangulation_ = nullptr;
    std::vector<Settlement> settlements_;
    std::vector<glm::dvec2> places_;
};

} // namespace meshbound
