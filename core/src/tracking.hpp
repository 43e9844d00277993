#pragma once

#include <vector>

#include "accounting.hpp"
#include "crossings.hpp"
#include "hole_content.hpp"
#include "joint_space.hpp"
#include "measured_rows.hpp"
#include "meshbound/options.hpp"
#include "original_edges.hpp"
#include "residents.hpp"
#include "tracked_cost.hpp"

namespace meshbound {

/// The tracked accounting (beyond the paper): keeps the map Φ from the original surface to the current one and measures
/// against the original at every step, so that nothing accumulates.
///
/// The state is combinatorial plus parameters: where the removed vertices lie (Residents) and where original edges cross
/// current ones (Crossings). Cutting each original triangle along chords between its crossings leaves cells, each of which
/// lands in one current triangle; so any choice of places makes Φ continuous, piecewise linear, with corners exactly at the
/// removed vertices and the crossings, and the largest error over the whole surface stands at one of these. Rounding
/// changes which Φ is chosen, never whether it is a valid one.
class Tracking final : public Accounting {
public:
    Tracking(const Rows& rows, const Surface& surface, const Options& options);

    void enter(const Hole& hole) override;
    HoleCost& cost() override { return cost_; }
    Measured measure(const Retriangulation& retriangulation, double squared_limit) override;
    void commit(const Retriangulation& retriangulation) override;
    bool minds_turns() const override { return false; }
    std::size_t work() const override;
    void measure_in(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

    /// The parts of the map, for writing it out.
    const OriginalEdges& original_edges() const { return edges_; }
    const Crossings& crossings() const { return crossings_; }
    const Residents& residents() const { return residents_; }

private:
    /// Where a vertex settles among the new triangles.
    struct Settlement {
        int triangle = 0;
        glm::dvec3 weight{1, 0, 0}; // at the corners a, m, b
    };
    /// A crossing with a new diagonal, t from ring position a to b of the triangle below the diagonal.
    struct NewCrossing {
        int triangle = 0; // the diagonal is this triangle's (a, b)
        double s = 0, t = 0;
        bool into = false; // passes into this triangle as s rises
    };

    const double* ring_row(int i) const;
    void index_tree(const Retriangulation& retriangulation);
    bool settle_vertices(const Retriangulation& retriangulation, double squared_limit);
    Settlement locate(const Retriangulation& retriangulation, const InnerVertex& inner) const;
    void choose_place(const double* row, Settlement& settlement, double& error) const;
    void choose_share(const double* row, Settlement& settlement, double& error) const;
    bool lay_pieces(const Retriangulation& retriangulation, double squared_limit);
    bool lay_piece(const Retriangulation& retriangulation, const Piece& piece, double squared_limit);
    void cross_straight(const Retriangulation& retriangulation, const Piece& piece, std::size_t first);
    void choose_crossings(const Piece& piece, std::size_t first, double threshold);
    auto difference_at(const Piece& piece, const NewCrossing& crossing) const;
    double error_at(const Piece& piece, const NewCrossing& crossing) const;
    int triangle_at(const PieceEnd& end) const;
    glm::dvec2 place_of(const PieceEnd& end) const;
    void find_path(const Retriangulation& retriangulation, const Piece& piece);
    template <class Difference>
    bool record(double squared_error, const Difference& difference, double squared_limit);
    template <class Visit>
    void for_each_corner(std::uint32_t slot, const Visit& visit) const;

    const Rows* rows_;
    MeasuredRows measured_rows_;
    const Surface* surface_;
    Options options_;
    OriginalEdges edges_;
    Crossings crossings_;
    Residents residents_;
    HoleContent content_;
    TrackedCost cost_;

    // The removal at hand.
    const Hole* hole_ = nullptr;
    Measured measured_;
    std::vector<int> depth_;                 // by new triangle
    std::vector<int> at_rim_;                // by rim: its new triangle
    std::vector<JointTriangle> joints_;      // by new triangle
    std::vector<Settlement> settlements_;    // by inner vertex
    std::vector<glm::dvec2> places_;         // by inner vertex, after settling
    std::vector<NewCrossing> new_crossings_; // piece after piece
    std::vector<std::size_t> piece_start_;   // by piece: its first crossing
    std::vector<NewCrossing> path_, path_down_;
};

} // namespace meshbound
