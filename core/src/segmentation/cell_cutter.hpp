#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshbound/segmentation.hpp"
#include "segmentation/face_lookup.hpp"
#include "segmentation/outline.hpp"

namespace meshbound {

/// Cuts an original triangle into cells, from its outline alone. The chords that cut it are the preimage of the reduced
/// edges: each joins two crossings of one reduced edge, or a crossing and a kept corner or two kept corners that are
/// ends of it. No two of them meet inside. Each cut takes one cell off, and its chord becomes a part of the outline.
///
///           C            A is kept, B and C are removed.
///          / \           1 and 2 cross one reduced edge: the cut 1 … 2 takes off the cell (1, B, 2).
///         /   3          3 crosses a reduced edge that ends at A: the cut 3 … A takes off the cell (3, C, A).
///        /     2         What is left, (A, 1, 2, 3), is the last cell.
///       A---1---B
///
/// Which steps to join follows from the outline's filling being a disk: where the outline returns over the edge that it
/// has just crossed, these two; then all crossings next to a kept corner of edges that end there; and then the chords
/// that are left run from side to side or to the opposite corner, so that their numbers follow from those of the three
/// sides.
class CellCutter {
public:
    /// The regions are those of the original; none, if it has none.
    CellCutter(const FaceLookup& reduced_faces, const std::vector<std::int32_t>& regions)
        : faces_(&reduced_faces), regions_(&regions) {}

    /// Adds the cells of an original triangle to the segmentation, without pieces. The outline is used up.
    void cut(std::uint32_t triangle, Outline& outline, Segmentation& segmentation);

private:
    using Step = std::size_t;

    void enter(std::uint32_t triangle, Outline& outline, Segmentation& segmentation);
    void join_crossings();
    void collect_chains();
    void join_returns(std::vector<Step>& chain);
    void join_to_ends(std::size_t chain);
    void join_around_corners();
    void join_to_opposite_corners();
    void close();
    void collect_kept_steps_left();
    bool ends_at(Step crossing, Step kept) const;
    std::uint32_t triangle_of_run(Step from, Step to) const;
    std::uint32_t triangle_that_holds(Step from, Step to) const;
    std::uint32_t triangle_beside(std::uint32_t a, std::uint32_t b) const;
    void cut_off(Step from, Step to);
    void add_cell(Step from, Step to, std::uint32_t reduced);

    const FaceLookup* faces_;
    const std::vector<std::int32_t>* regions_;
    std::uint32_t triangle_ = 0;
    Outline* outline_ = nullptr;
    Segmentation* out_ = nullptr;
    std::vector<Step> next_; // what is left of the outline
    Step left_ = 0;          // one step of it
    std::vector<Step> kept_; // the kept corners in their order, of the whole outline, at last of what is left
    /// The crossings not yet joined from each kept corner to the next; all in the first where no corner is kept.
    std::array<std::vector<Step>, 3> chains_;
};

} // namespace meshbound
