#include "reduction/removal.hpp"

#include <algorithm>
#include <utility>

#include "util/indexing.hpp"

namespace meshbound {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>; // of sites or vertices of the input, the lower one first

} // namespace

Removal::Removal(Surface& surface, const Rows& rows, Accounting& accounting, const Guards& guards)
    : surface_(surface), rows_(rows), accounting_(accounting), guards_(guards) {
    parts_.push_back(std::make_unique<Part>(accounting, guards));
}

Verdict Removal::attempt(std::uint32_t candidate, double squared_limit, Effort effort) {
    count_ = 0;
    surface_.for_each_in_site(candidate, [this](std::uint32_t vertex) { open(vertex); });
    if (has_large_ring()) return {Refusal::ring};
    if (!enter()) return {Refusal::topology};
    if (count_ > 1) joined_.front()->join(joined_, squared_limit);
    if (!triangulate()) return {Refusal::fold};
    for (std::size_t n = 0; n < count_; ++n) {
        const Trial trial = try_part(*parts_[n], squared_limit, effort);
        if (trial.accepted(squared_limit)) continue;
        if (trial.pierces) return {Refusal::piercing};
        return {Refusal::bound, false, static_cast<std::uint16_t>(trial.measured.variable),
                static_cast<float>(trial.measured.squared_ratio)};
    }
    if (count_ > 1 && parts_meet()) return {Refusal::topology};
    if (count_ > 1 && pierces()) return {Refusal::piercing};
    take();
    return {};
}

void Removal::open(std::uint32_t vertex) {
    if (count_ == parts_.size()) parts_.push_back(std::make_unique<Part>(accounting_, guards_));
    Part& part = *parts_[count_++];
    gather_star(surface_, vertex, part.hole);
    lay_out(rows_, part.hole);
}

bool Removal::has_large_ring() const {
    return std::any_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(count_),
                       [](const auto& part) { return part->hole.size() > largest_ring; });
}

bool Removal::enter() {
    joined_.clear();
    for (std::size_t n = 0; n < count_; ++n) {
        Part& part = *parts_[n];
        if (!part.legality.enter(surface_, rows_, part.hole)) return false;
        part.removals->enter(part.hole);
        joined_.push_back(part.removals.get());
    }
    return count_ == 1 || !would_change_slits();
}

/// Whether two sides of a seam would come together or apart. Where their closing edges would join the same vertices of the input,
/// which their candidates are not, the slit between the two would close to one edge, and a boundary vanish. Where their
/// candidates are one vertex that holds two slits apart, the sides do not meet elsewhere, and the two would become one.
bool Removal::would_change_slits() const {
    const auto ends = [&](const Hole& hole) -> Edge {
        return std::minmax({surface_.input(hole.ring.front()), surface_.input(hole.ring.back())});
    };
    for (std::size_t n = 1; n < count_; ++n)
        for (std::size_t m = 0; m < n; ++m) {
            const Hole &one = parts_[m]->hole, &other = parts_[n]->hole;
            const bool meet_now = surface_.input(one.candidate) == surface_.input(other.candidate);
            if (meet_now != (ends(one) == ends(other))) return true;
        }
    return false;
}

bool Removal::triangulate() {
    return std::all_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(count_), [](const auto& part) {
        return part->retriangulator.triangulate(part->hole, part->legality, part->removals->cost(),
                                                part->retriangulation);
    });
}

Removal::Trial Removal::try_part(Part& part, double squared_limit, Effort effort) {
    const Trial trial = try_out(part, squared_limit);
    if (trial.accepted(squared_limit) || effort != Effort::thorough) return trial;
    return try_fans(part, squared_limit, trial);
}

/// Of several parts, whether they pierce is asked when all of them are known.
Removal::Trial Removal::try_out(Part& part, double squared_limit) {
    Trial trial{part.removals->measure(part.retriangulation, squared_limit)};
    trial.pierces = count_ == 1 && trial.accepted(squared_limit) && pierces();
    return trial;
}

/// The cheapest retriangulation is the best guess, not the only one within the bounds: the fans (what collapsing a spoke would
/// give) are few, and leave 2 % fewer triangles. Returns the first that is accepted, else what was refused.
Removal::Trial Removal::try_fans(Part& part, double squared_limit, Trial refused) {
    for (int hub = 0; hub < part.hole.size(); ++hub) {
        if (!part.retriangulator.fan(part.hole, part.legality, hub, part.retriangulation)) continue;
        const Trial trial = try_out(part, squared_limit);
        if (trial.accepted(squared_limit)) return trial;
        if (trial.measured.squared_ratio < refused.measured.squared_ratio) refused = trial;
    }
    return refused;
}

/// Whether new edges of two parts, besides the closing edge, would join the same two sites, or their triangles at the closing
/// edge the same three.
bool Removal::parts_meet() const {
    std::vector<Edge> edges;
    std::vector<std::uint32_t> tips;
    for (std::size_t n = 0; n < count_; ++n) {
        const Hole& hole = parts_[n]->hole;
        const auto site = [&](int i) { return surface_.site(hole.ring[at(i)]); };
        for (const NewTriangle& triangle : parts_[n]->retriangulation.triangles)
            if (triangle.parent < 0) tips.push_back(site(triangle.m));
            else edges.push_back(std::minmax({site(triangle.a), site(triangle.b)}));
    }
    const auto repeats = [](auto& values) {
        std::sort(values.begin(), values.end());
        return std::adjacent_find(values.begin(), values.end()) != values.end();
    };
    return repeats(edges) || repeats(tips);
}

bool Removal::pierces() const {
    if (!guards_.piercing) return false;
    std::vector<Piercing::Filling> fillings;
    for (std::size_t n = 0; n < count_; ++n) fillings.push_back({&parts_[n]->hole, &parts_[n]->retriangulation});
    return guards_.piercing->pierces(fillings);
}

/// Takes what was tried out last.
void Removal::take() {
    for (std::size_t n = 0; n < count_; ++n) {
        Part& part = *parts_[n];
        surface_.retriangulate(part.hole, part.retriangulation);
        part.removals->commit(part.retriangulation);
        if (guards_.piercing) guards_.piercing->change(part.hole, part.retriangulation);
    }
}

std::size_t Removal::work() const {
    std::size_t work = 0;
    for (std::size_t n = 0; n < count_; ++n) work += parts_[n]->removals->work();
    return std::max<std::size_t>(work, 1);
}

} // namespace meshbound
