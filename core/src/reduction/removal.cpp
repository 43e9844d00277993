#include "reduction/removal.hpp"

#include <algorithm>
#include <utility>

#include "util/indexing.hpp"

namespace meshbound {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>; // of coincidence classes or input vertices, the lower one first

} // namespace

Removal::Removal(Surface& surface, const Rows& rows, ErrorModel& error_model, const ValidityChecks& checks)
    : surface_(surface), rows_(rows), error_model_(error_model), checks_(checks) {
    stars_.push_back(std::make_unique<Star>(error_model, checks));
}

RemovalOutcome Removal::attempt(std::uint32_t candidate, double squared_limit, Effort effort) {
    count_ = 0;
    surface_.for_each_coincident(candidate, [this](std::uint32_t vertex) { add_star(vertex); });
    if (has_large_ring()) return {Refusal::ring};
    if (!enter()) return {Refusal::topology};
    if (count_ > 1) models_.front()->share_closing_edges(models_, squared_limit);
    if (!triangulate()) return {Refusal::fold};
    for (std::size_t n = 0; n < count_; ++n) {
        const Trial trial = try_star(*stars_[n], squared_limit, effort);
        if (trial.accepted(squared_limit)) continue;
        if (trial.self_intersects) return {Refusal::self_intersection};
        return {Refusal::bound, false, static_cast<std::uint16_t>(trial.measured.variable),
                static_cast<float>(trial.measured.squared_ratio)};
    }
    if (count_ > 1 && stars_conflict()) return {Refusal::topology};
    if (count_ > 1 && self_intersects()) return {Refusal::self_intersection};
    apply();
    return {};
}

void Removal::add_star(std::uint32_t vertex) {
    if (count_ == stars_.size()) stars_.push_back(std::make_unique<Star>(error_model_, checks_));
    Star& star = *stars_[count_++];
    gather_star(surface_, vertex, star.hole);
    lay_out(rows_, star.hole);
}

bool Removal::has_large_ring() const {
    return std::any_of(stars_.begin(), stars_.begin() + static_cast<std::ptrdiff_t>(count_),
                       [](const auto& star) { return star->hole.size() > largest_ring; });
}

bool Removal::enter() {
    models_.clear();
    for (std::size_t n = 0; n < count_; ++n) {
        Star& star = *stars_[n];
        if (!star.legality.enter(surface_, rows_, star.hole)) return false;
        star.model->enter(star.hole);
        models_.push_back(star.model.get());
    }
    return count_ == 1 || !would_change_slits();
}

/// Whether a slit between two sides of a seam would close or merge with another one. Where the closing edges join the
/// same input vertices but the candidates are different ones, the slit between the two sides would close to an edge,
/// and a boundary loop vanish. Where the candidates are one input vertex but the closing edges are not the same, that
/// vertex separates two slits, which would become one.
bool Removal::would_change_slits() const {
    const auto ends = [&](const Hole& hole) -> Edge {
        return std::minmax({surface_.input(hole.ring.front()), surface_.input(hole.ring.back())});
    };
    for (std::size_t n = 1; n < count_; ++n)
        for (std::size_t m = 0; m < n; ++m) {
            const Hole &one = stars_[m]->hole, &other = stars_[n]->hole;
            const bool meet_now = surface_.input(one.candidate) == surface_.input(other.candidate);
            if (meet_now != (ends(one) == ends(other))) return true;
        }
    return false;
}

bool Removal::triangulate() {
    return std::all_of(stars_.begin(), stars_.begin() + static_cast<std::ptrdiff_t>(count_), [](const auto& star) {
        return star->retriangulator.triangulate(star->hole, star->legality, star->model->cost(), star->retriangulation);
    });
}

Removal::Trial Removal::try_star(Star& star, double squared_limit, Effort effort) {
    const Trial trial = try_retriangulation(star, squared_limit);
    if (trial.accepted(squared_limit) || effort != Effort::thorough) return trial;
    return try_fans(star, squared_limit, trial);
}

/// With several stars, self-intersection is checked once all retriangulations are known.
Removal::Trial Removal::try_retriangulation(Star& star, double squared_limit) {
    Trial trial{star.model->measure(star.retriangulation, squared_limit)};
    trial.self_intersects = count_ == 1 && trial.accepted(squared_limit) && self_intersects();
    return trial;
}

/// The cheapest retriangulation may exceed the bounds where another one does not. Tries the fans, which are what
/// collapsing a spoke would give. Returns the first that is accepted, else the best that was refused.
Removal::Trial Removal::try_fans(Star& star, double squared_limit, Trial refused) {
    for (int hub = 0; hub < star.hole.size(); ++hub) {
        if (!star.retriangulator.fan(star.hole, star.legality, hub, star.retriangulation)) continue;
        const Trial trial = try_retriangulation(star, squared_limit);
        if (trial.accepted(squared_limit)) return trial;
        if (trial.measured.squared_ratio < refused.measured.squared_ratio) refused = trial;
    }
    return refused;
}

/// Whether new edges of two stars, besides the closing edge, would join the same two coincidence classes, or their
/// triangles at the closing edge the same three.
bool Removal::stars_conflict() const {
    std::vector<Edge> edges;
    std::vector<std::uint32_t> tips;
    for (std::size_t n = 0; n < count_; ++n) {
        const Hole& hole = stars_[n]->hole;
        const auto representative = [&](int i) { return surface_.representative(hole.ring[to_index(i)]); };
        for (const NewTriangle& triangle : stars_[n]->retriangulation.triangles)
            if (triangle.parent < 0) tips.push_back(representative(triangle.m));
            else edges.push_back(std::minmax({representative(triangle.a), representative(triangle.b)}));
    }
    const auto repeats = [](auto& values) {
        std::sort(values.begin(), values.end());
        return std::adjacent_find(values.begin(), values.end()) != values.end();
    };
    return repeats(edges) || repeats(tips);
}

bool Removal::self_intersects() const {
    if (!checks_.self_intersection) return false;
    std::vector<SelfIntersectionCheck::Filling> fillings;
    for (std::size_t n = 0; n < count_; ++n) fillings.push_back({&stars_[n]->hole, &stars_[n]->retriangulation});
    return checks_.self_intersection->self_intersects(fillings);
}

/// Accepts the retriangulations tried last.
void Removal::apply() {
    for (std::size_t n = 0; n < count_; ++n) {
        Star& star = *stars_[n];
        surface_.retriangulate(star.hole, star.retriangulation);
        star.model->commit(star.retriangulation);
        if (checks_.self_intersection) checks_.self_intersection->update(star.hole, star.retriangulation);
    }
}

std::size_t Removal::work() const {
    std::size_t work = 0;
    for (std::size_t n = 0; n < count_; ++n) work += stars_[n]->model->work();
    return std::max<std::size_t>(work, 1);
}

} // namespace meshbound
