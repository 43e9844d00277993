#include "segmentation/cell_cutter.hpp"

#include <algorithm>

namespace meshbound {

void CellCutter::cut(std::uint32_t triangle, Outline& outline, Segmentation& segmentation) {
    enter(triangle, outline, segmentation);
    if (outline.size() > 3) join_crossings(); // more than its corners, as few triangles have
    close();
}

void CellCutter::join_crossings() {
    collect_chains();
    for (std::vector<Step>& chain : chains_) join_returns(chain);
    for (std::size_t i = 0; i < kept_.size(); ++i) join_to_ends(i);
    join_around_corners();
    join_to_opposite_corners();
}

void CellCutter::enter(std::uint32_t triangle, Outline& outline, Segmentation& segmentation) {
    triangle_ = triangle;
    outline_ = &outline;
    out_ = &segmentation;
    left_ = 0;
    next_.resize(outline.size());
    for (Step step = 0; step < outline.size(); ++step) next_[step] = step + 1 < outline.size() ? step + 1 : 0;
}

void CellCutter::collect_chains() {
    kept_.clear();
    for (std::vector<Step>& chain : chains_) chain.clear();
    for (Step step = 0; step < outline_->size(); ++step)
        if ((*outline_)[step].is_kept()) kept_.push_back(step);
    const Step first = kept_.empty() ? 0 : kept_.front();
    std::size_t passed = 0; // kept corners
    for (std::size_t n = 0; n < outline_->size(); ++n) {
        const Step step = (first + n) % outline_->size();
        if ((*outline_)[step].is_kept()) ++passed;
        else if ((*outline_)[step].is_crossing()) chains_[passed > 0 ? passed - 1 : 0].push_back(step);
    }
}

/// Joins crossings after which the outline comes straight back over the same edge, and so on with what remains.
void CellCutter::join_returns(std::vector<Step>& chain) {
    std::size_t remaining = 0;
    for (const Step step : chain) {
        if (remaining > 0 && (*outline_)[chain[remaining - 1]].crossed == (*outline_)[step].crossed)
            cut_off(chain[--remaining], step);
        else chain[remaining++] = step;
    }
    chain.resize(remaining);
}

bool CellCutter::ends_at(Step crossing, Step kept) const {
    const glm::uvec2 edge = (*outline_)[crossing].crossed;
    return edge.x == (*outline_)[kept].kept || edge.y == (*outline_)[kept].kept;
}

/// Joins crossings next to one of the chain's two kept corners with it where their edges end there.
void CellCutter::join_to_ends(std::size_t i) {
    std::vector<Step>& chain = chains_[i];
    const Step start = kept_[i], end = kept_[(i + 1) % kept_.size()];
    auto first = chain.begin();
    for (; first != chain.end() && ends_at(*first, start); ++first) cut_off(start, *first);
    chain.erase(chain.begin(), first);
    for (; !chain.empty() && ends_at(chain.back(), end); chain.pop_back()) cut_off(chain.back(), end);
}

/// Joins crossings of two chains around the kept corner between them, from that corner outward. As many as must be, if
/// all of the two chains and the third are joined with each other, or those left in one chain with the opposite corner.
void CellCutter::join_around_corners() {
    std::array<std::ptrdiff_t, 3> length{}, around{};
    for (std::size_t i = 0; i < 3; ++i) length[i] = static_cast<std::ptrdiff_t>(chains_[i].size());
    for (std::size_t i = 0; i < 3; ++i) {
        const std::ptrdiff_t here = length[i], behind = length[(i + 1) % 3], opposite = length[(i + 2) % 3];
        around[i] = std::clamp<std::ptrdiff_t>((here + behind - opposite) / 2, 0, std::min(here, behind));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<Step>&here = chains_[i], &behind = chains_[(i + 1) % 3];
        for (std::ptrdiff_t n = 0; n < around[i]; ++n) {
            cut_off(here.back(), behind[static_cast<std::size_t>(n)]);
            here.pop_back();
        }
        behind.erase(behind.begin(), behind.begin() + around[i]);
    }
}

/// Crossings that are left in more than one chain fit no map: they stay in one cell, which fits no triangle either.
void CellCutter::join_to_opposite_corners() {
    const auto is_left = [](const std::vector<Step>& chain) { return !chain.empty(); };
    if (kept_.size() < 3 || std::count_if(chains_.begin(), chains_.end(), is_left) > 1) return;
    for (std::size_t i = 0; i < 3; ++i)
        for (const Step step : chains_[i]) cut_off(kept_[(i + 2) % 3], step);
}

void CellCutter::collect_kept_steps_left() {
    kept_.clear();
    Step step = left_;
    do {
        if ((*outline_)[step].is_kept()) kept_.push_back(step);
        step = next_[step];
    } while (step != left_);
}

/// What is left is the last cell, but for sides that a reduced edge between two kept corners separates from it.
void CellCutter::close() {
    collect_kept_steps_left();
    const auto vertex = [&](std::size_t i) { return (*outline_)[kept_[i]].kept; };
    const std::uint32_t last =
        kept_.size() == 3 ? faces_->of(vertex(0), vertex(1), vertex(2)) : triangle_of_run(left_, left_);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        const Step end = kept_[(i + 1) % kept_.size()];
        const std::uint32_t side = triangle_of_run(kept_[i], end);
        if (side != nowhere && side != last) cut_off(kept_[i], end);
    }
    add_cell(left_, left_, last);
}

/// The reduced triangle in which a run lies, all around if its ends are one; nowhere if nothing but kept vertices are
/// in it.
std::uint32_t CellCutter::triangle_of_run(Step from, Step to) const {
    Step step = from;
    do {
        if ((*outline_)[step].after != nowhere) return (*outline_)[step].after;
        step = next_[step];
    } while (step != to);
    return (*outline_)[to].before;
}

/// Takes the cell off that a chord between the two steps cuts from the outline.
void CellCutter::cut_off(Step from, Step to) {
    add_cell(from, to, triangle_of_run(from, to));
    next_[from] = to;
    left_ = from;
    (*outline_)[from].after = (*outline_)[from].before;
    (*outline_)[to].before = (*outline_)[to].after;
}

/// The reduced triangle that holds a run of nothing but kept vertices and such on curves.
std::uint32_t CellCutter::triangle_that_holds(Step from, Step to) const {
    std::vector<std::uint32_t> corners;
    const auto add = [&corners](std::uint32_t vertex) {
        if (std::find(corners.begin(), corners.end(), vertex) == corners.end()) corners.push_back(vertex);
    };
    const auto add_step = [&](Step step) {
        const OutlineStep& here = (*outline_)[step];
        for (const std::uint32_t vertex : {here.kept, here.curve.x, here.curve.y})
            if (vertex != nowhere) add(vertex);
    };
    Step step = from;
    do {
        add_step(step);
        step = next_[step];
    } while (step != to);
    add_step(to);
    if (corners.size() < 2) return nowhere; // no room for a cell
    if (corners.size() > 2) return faces_->of(corners[0], corners[1], corners[2]);
    return triangle_beside(corners.front(), corners.back());
}

/// A reduced triangle with this edge, of the original triangle's region if there is one.
std::uint32_t CellCutter::triangle_beside(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t left = faces_->left_of(a, b), right = faces_->left_of(b, a);
    if (left == nowhere || right == nowhere) return left != nowhere ? left : right;
    const bool is_right = !regions_->empty() && faces_->region(right) == (*regions_)[triangle_] &&
                          faces_->region(left) != (*regions_)[triangle_];
    return is_right ? right : left;
}

/// The cell of a run, or of all that is left if its ends are one. Two steps leave no room for a cell between them.
void CellCutter::add_cell(Step from, Step to, std::uint32_t reduced) {
    SegmentationCell cell;
    cell.original = triangle_;
    cell.reduced = reduced != nowhere ? reduced : triangle_that_holds(from, to);
    cell.first_corner = static_cast<std::uint32_t>(out_->corners.size());
    Step step = from;
    do {
        out_->corners.push_back((*outline_)[step].corner);
        step = next_[step];
    } while (step != to);
    if (from != to) out_->corners.push_back((*outline_)[to].corner);
    cell.corner_count = static_cast<std::uint32_t>(out_->corners.size()) - cell.first_corner;
    if (cell.corner_count < 3) out_->corners.resize(cell.first_corner);
    else out_->cells.push_back(cell);
}

} // namespace meshbound
