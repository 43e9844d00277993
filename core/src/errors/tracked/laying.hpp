#pragma once

#include <vector>

#include "errors/tracked/hole_content.hpp"
#include "errors/tracked/hole_products.hpp"
#include "retriangulation/hole_tree.hpp"
#include "metric/joint_space.hpp"
#include "metric/measured_rows.hpp"
#include "metric/minimax.hpp"
#include "errors/tracked/settling.hpp"
#include "errors/tracked/tracked_map.hpp"
#include "metric/worst_error.hpp"

namespace meshbound {

/// A crossing with a new diagonal: that of `triangle` to its parent, t from its ring position a to b.
struct NewCrossing {
    int triangle = 0;
    double s = 0, t = 0;
    bool into = false; ///< passes into this triangle as s rises
};

/// How the pieces of original edges in a hole are laid over its new triangles: each runs from the triangle of its start to
/// that of its end, straight in the layout or, where the error is too high there and the map is free, where it is smallest.
class Laying {
public:
    Laying(const MeasuredRows& rows, const HoleProducts& products, const TrackedMap& map, bool choose_crossings)
        : rows_(rows), products_(products), map_(map), choose_crossings_(choose_crossings), minimax_(rows) {}

    /// Lays all pieces, their inner vertices being settled; false as soon as an error is above the limit.
    bool lay(const Hole& hole, HoleTree& tree, const Settling& settling, const std::vector<Piece>& pieces,
             WorstError& worst);

    /// The crossings of a piece, with s rising: [begin(p), begin(p + 1)) of all.
    const std::vector<NewCrossing>& crossings() const { return crossings_; }
    std::size_t begin(std::size_t piece) const { return begin_[piece]; }
    bool crosses(std::size_t piece) const { return begin(piece) < begin(piece + 1); }

private:
    bool lay_piece(const Piece& piece, int from, int to, WorstError& worst);
    /// The triangle at which a piece may begin or end. Of a ring vertex any of its triangles serves.
    int triangle_at(const PieceEnd& end) const {
        return end.is_inner() ? settling_->triangle_of(end.inner())
                              : tree_->at_rim(end.is_crossing() ? end.rim() : end.ring());
    }
    glm::dvec2 place_of(const PieceEnd& end) const;
    double start_of(const Piece& piece) const;
    double end_of(const Piece& piece) const;
    void cross_straight(const Piece& piece, std::size_t first);
    void choose(const Piece& piece, std::size_t first, std::size_t n, double squared_content, double& error);
    void take_better(const Piece& piece, const glm::dvec2& chosen, NewCrossing& crossing, double& error) const;
    auto difference(const Piece& piece, const NewCrossing& crossing) const;
    double error(const Piece& piece, const NewCrossing& crossing) const;

    const MeasuredRows& rows_;
    const HoleProducts& products_;
    const TrackedMap& map_;
    bool choose_crossings_;
    Minimax minimax_;
    const Hole* hole_ = nullptr;
    HoleTree* tree_ = nullptr;
    const Settling* settling_ = nullptr;
    std::vector<NewCrossing> crossings_; // piece after piece
    std::vector<std::size_t> begin_;     // by piece: its first crossing
};

} // namespace meshbound
