#include "reduction/sweep.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace meshbound {
namespace {

/// How a round is cut: into as many patches as keep many threads busy, and as few as leave little on the cuts.
struct Cutting {
    std::size_t least;    // a smaller round is taken whole
    std::size_t in_patch; // vertices in a patch, at least, where there are more than two
    int deepest;          // 2^deepest patches at most
};

/// Where changed vertices wait, patches change nothing.
constexpr Cutting cutting_in_rounds = {1024, 256, 8};

/// The last sweep advances in fronts, which are worth 10 % of the triangles and break where one begins at a cut: two, which
/// begin at opposite ends of the surface and meet at its middle, leave 0.2 % more than one.
constexpr Cutting cutting_in_fronts = {2048, 1024, 1};

/// So many rounds does a patch go on by itself, while its part of the surface is at hand in the cache.
constexpr std::uint32_t rounds_in_patch = 4;

/// Before the last sweep, a vertex whose star has changed waits for the next round: removing one after its neighbour, along
/// a numbering that runs in rows, would drag a front of long triangles, and of all that is tracked in them, over the surface.
bool changed_wait(Removal::Effort effort) { return effort == Removal::Effort::best; }

const Cutting& cutting(Removal::Effort effort) { return changed_wait(effort) ? cutting_in_rounds : cutting_in_fronts; }

int depth_of_cut(std::size_t vertices, const Cutting& cutting) {
    int depth = 1;
    while (depth < cutting.deepest && (vertices >> (depth + 1)) >= cutting.in_patch) ++depth;
    return depth;
}

} // namespace

Sweeper::Sweeper(Surface& surface, const Rows& rows, Accounting& accounting, std::vector<char> candidate, Team& team,
                 const Guards& guards)
    : surface_(surface), rows_(rows), accounting_(accounting), team_(team), guards_(guards),
      candidate_(std::move(candidate)), queued_(candidate_.size(), 0), touched_(candidate_.size(), 0),
      verdicts_(candidate_.size(), {Refusal::none, true}) {
    removals_.push_back(std::make_unique<Removal>(surface, rows, accounting, guards));
}

bool Sweeper::sweep(const std::vector<double>& limits, Ticker& ticker, double start, double end,
                    const std::function<void()>& before_last) {
    const double share = (end - start) / static_cast<double>(limits.size());
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const bool last = i + 1 == limits.size(); // before, a refused candidate gets another chance anyway
        if (last && i > 0 && before_last) before_last();
        const Removal::Effort effort = last ? Removal::Effort::thorough : Removal::Effort::best;
        if (!sweep_once({limits[i] * limits[i], effort, ticker, start + static_cast<double>(i) * share, share}))
            return false;
    }
    return true;
}

bool Sweeper::sweep_once(const Sweep& sweep) {
    queue_candidates(sweep.squared_limit);
    if (!changed_wait(sweep.effort)) line_up();
    known_ = queue_.size();
    taken_ = 0;
    next_whole_ = false;
    while (!queue_.empty()) {
        ++round_;
        if (guards_.piercing) guards_.piercing->tidy();
        const Queue round = std::exchange(queue_, {});
        const bool whole = next_whole_ || round.size() < cutting(sweep.effort).least;
        if (!(whole ? take_whole(sweep, round) : take_in_patches(sweep, round))) return false;
    }
    return true;
}

/// Everything whose star changed since it was last looked at, whose known error the limit has passed, or whose way another
/// lobe was in, which may have changed.
void Sweeper::queue_candidates(double squared_limit) {
    queue_.clear();
    for (std::uint32_t vertex = 0; vertex < candidate_.size(); ++vertex) {
        const Verdict& verdict = verdicts_[vertex];
        if (verdict.stale || verdict.refusal == Refusal::piercing ||
            (verdict.refusal == Refusal::bound && verdict.squared_ratio <= squared_limit))
            queue(vertex, queue_);
    }
}

/// Along the longest axis: fronts that advance in step over the surface leave 4 % fewer triangles than fronts that follow the
/// numbering, and a random order leaves 6 % more.
void Sweeper::line_up() {
    glm::dvec3 low(0), high(0);
    for (const std::uint32_t vertex : queue_) {
        low = glm::min(low, rows_.position(vertex));
        high = glm::max(high, rows_.position(vertex));
    }
    const glm::dvec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    std::stable_sort(queue_.begin(), queue_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return rows_.position(a)[axis] < rows_.position(b)[axis];
    });
}

void Sweeper::queue(std::uint32_t vertex, Queue& next) {
    if (queued_[vertex] || !candidate_[vertex]) return;
    queued_[vertex] = 1;
    next.push_back(vertex);
}

bool Sweeper::take_whole(const Sweep& sweep, const Queue& round) {
    next_whole_ = false;
    for (const std::uint32_t vertex : round) {
        take(sweep, vertex, 0, round_, queue_);
        if (!tick(sweep, 0)) return false;
    }
    return true;
}

bool Sweeper::take_in_patches(const Sweep& sweep, const Queue& round) {
    gather_team();
    const Patches patches(rows_, round, depth_of_cut(round.size(), cutting(sweep.effort)), cuts_++);
    std::vector<Patch> cut(patches.count());
    for (const std::uint32_t vertex : round) cut[patches.at(rows_.position(vertex))].vertices.push_back(vertex);
    if (!changed_wait(sweep.effort)) std::reverse(cut.back().vertices.begin(), cut.back().vertices.end());
    team_.run(cut.size(), [&](std::size_t member, std::size_t number) {
        if (!take_patch(sweep, patches, number, member, cut[number])) cancelled_ = true;
    });
    round_ += rounds_in_patch - 1;
    std::size_t put_off = 0;
    for (const Patch& patch : cut) {
        queue_.insert(queue_.end(), patch.next.begin(), patch.next.end());
        put_off += patch.put_off;
    }
    next_whole_ = 2 * put_off > round.size();
    return !cancelled_;
}

bool Sweeper::take_patch(const Sweep& sweep, const Patches& patches, std::size_t number, std::size_t member,
                         Patch& patch) {
    Queue waiting;
    const std::uint32_t rounds = changed_wait(sweep.effort) ? rounds_in_patch : 1;
    for (std::uint32_t n = 0; n < rounds && !patch.vertices.empty(); ++n) {
        waiting.clear();
        for (const std::uint32_t vertex : patch.vertices) {
            if (waits(sweep, vertex, round_ + n) || lies_within(vertex, patches, number)) {
                take(sweep, vertex, member, round_ + n, waiting);
            } else {
                ++patch.put_off;
                patch.next.push_back(vertex);
            }
            if (cancelled_ || !tick(sweep, member)) return false;
        }
        std::swap(patch.vertices, waiting);
    }
    patch.next.insert(patch.next.end(), patch.vertices.begin(), patch.vertices.end());
    return true;
}

/// Whether the rings of all vertices of a site lie in the same patch.
bool Sweeper::lies_within(std::uint32_t vertex, const Patches& patches, std::size_t number) const {
    bool within = true;
    surface_.for_each_in_site(vertex,
                              [&](std::uint32_t copy) { within = within && ring_lies_within(copy, patches, number); });
    return within;
}

bool Sweeper::ring_lies_within(std::uint32_t vertex, const Patches& patches, std::size_t number) const {
    return surface_.all_of_ring(
        vertex, [&](std::uint32_t neighbour) { return patches.holds(number, rows_.position(neighbour)); });
}

/// Whether the star has changed in this round, and is looked at in the next one.
bool Sweeper::waits(const Sweep& sweep, std::uint32_t vertex, std::uint32_t round) const {
    return changed_wait(sweep.effort) && touched_[vertex] == round;
}

void Sweeper::take(const Sweep& sweep, std::uint32_t vertex, std::size_t member, std::uint32_t round, Queue& next) {
    const std::size_t before = next.size();
    queued_[vertex] = 0;
    if (waits(sweep, vertex, round)) queue(vertex, next);
    else attempt(sweep, vertex, *removals_[member], round, next);
    known_ += next.size() - before;
    ++taken_;
}

void Sweeper::attempt(const Sweep& sweep, std::uint32_t vertex, Removal& removal, std::uint32_t round, Queue& next) {
    verdicts_[vertex] = removal.attempt(vertex, sweep.squared_limit, sweep.effort);
    if (verdicts_[vertex].refusal != Refusal::none) return;
    candidate_[vertex] = 0;
    removal.for_each_ring_vertex([&](std::uint32_t copy) {
        const std::uint32_t neighbour = surface_.site(copy);
        verdicts_[neighbour].stale = true;
        touched_[neighbour] = round;
        if (has_chance(sweep, neighbour)) queue(neighbour, next);
    });
}

/// Before the last sweep, what was refused for a bound is not looked at again when its star has changed: 2 to 4 % of such
/// vertices could go, and the last sweep asks them anyway. Asking all of them took a tenth of the time and left 0.3 % more
/// triangles.
bool Sweeper::has_chance(const Sweep& sweep, std::uint32_t vertex) const {
    return !changed_wait(sweep.effort) || verdicts_[vertex].refusal != Refusal::bound;
}

/// Only the caller's own thread reports to it.
bool Sweeper::tick(const Sweep& sweep, std::size_t member) {
    if (member != 0) return true;
    const double done = static_cast<double>(taken_) / static_cast<double>(known_);
    return sweep.ticker.tick(removals_[0]->work(), sweep.start + sweep.share * done);
}

void Sweeper::gather_team() {
    team_.gather();
    while (removals_.size() < team_.size())
        removals_.push_back(std::make_unique<Removal>(surface_, rows_, accounting_, guards_));
}

} // namespace meshbound
