#include "reduction/sweep.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "geometry/longest_side.hpp"

namespace meshbound {
namespace {

/// How a round is partitioned: into enough patches to keep many threads busy, and so few that little lies on the cuts.
struct Partitioning {
    std::size_t least;          // a smaller round is processed serially
    std::size_t least_in_patch; // vertices in a patch at least, where there are more than two patches
    int deepest;                // 2^deepest patches at most
};

/// Where changed vertices are deferred, the patches make no difference to the result.
constexpr Partitioning partitioning_in_rounds = {1024, 256, 8};

/// The last sweep advances in fronts, which reduces further; a front that begins at a cut spoils that. So there are
/// two, which begin at opposite ends of the surface and meet in its middle.
constexpr Partitioning partitioning_in_fronts = {2048, 1024, 1};

/// How many rounds a patch goes on by itself, while its surface is in the cache.
constexpr std::uint32_t rounds_in_patch = 4;

/// Before the last sweep, a vertex whose star has changed waits for the next round: removing one after its neighbour, along
/// a numbering that runs in rows, would drag a front of long triangles, and of all that is tracked in them, over the surface.
bool defers_changed(Removal::Effort effort) { return effort == Removal::Effort::best; }

const Partitioning& partitioning(Removal::Effort effort) {
    return defers_changed(effort) ? partitioning_in_rounds : partitioning_in_fronts;
}

int depth_of_partitioning(std::size_t vertices, const Partitioning& partitioning) {
    int depth = 1;
    while (depth < partitioning.deepest && (vertices >> (depth + 1)) >= partitioning.least_in_patch) ++depth;
    return depth;
}

} // namespace

Sweeper::Sweeper(Surface& surface, const Rows& rows, ErrorModel& error_model, std::vector<char> candidate,
                 ThreadPool& pool, const ValidityChecks& checks)
    : surface_(surface), rows_(rows), error_model_(error_model), pool_(pool), checks_(checks),
      candidate_(std::move(candidate)), queued_(candidate_.size(), 0), changed_in_round_(candidate_.size(), 0),
      outcomes_(candidate_.size(), {Refusal::none, true}) {
    removals_.push_back(std::make_unique<Removal>(surface, rows, error_model, checks));
}

bool Sweeper::sweep(const std::vector<double>& limits, ProgressReporter& reporter, double start, double end,
                    const std::function<void()>& before_last) {
    const double share = (end - start) / static_cast<double>(limits.size());
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const bool last = i + 1 == limits.size(); // in the others, a refused candidate gets another chance anyway
        if (last && i > 0 && before_last) before_last();
        const Removal::Effort effort = last ? Removal::Effort::thorough : Removal::Effort::best;
        if (!sweep_once({limits[i] * limits[i], effort, reporter, start + static_cast<double>(i) * share, share}))
            return false;
    }
    return true;
}

bool Sweeper::sweep_once(const Sweep& sweep) {
    queue_candidates(sweep.squared_limit);
    if (!defers_changed(sweep.effort)) sort_along_longest_axis();
    enqueued_ = queue_.size();
    processed_ = 0;
    next_is_serial_ = false;
    while (!queue_.empty()) {
        ++round_;
        if (checks_.self_intersection) checks_.self_intersection->rebuild_if_sparse();
        const Queue round = std::exchange(queue_, {});
        const bool serial = next_is_serial_ || round.size() < partitioning(sweep.effort).least;
        if (!(serial ? process_serially(sweep, round) : process_in_patches(sweep, round))) return false;
    }
    return true;
}

/// Everything whose star has changed since its last attempt, whose known error is within the limit now, or which
/// another lobe was in the way of: that may have changed.
void Sweeper::queue_candidates(double squared_limit) {
    queue_.clear();
    for (std::uint32_t vertex = 0; vertex < candidate_.size(); ++vertex) {
        const RemovalOutcome& outcome = outcomes_[vertex];
        if (outcome.stale || outcome.refusal == Refusal::self_intersection ||
            (outcome.refusal == Refusal::bound && outcome.squared_ratio <= squared_limit))
            queue(vertex, queue_);
    }
}

/// So that the removals advance over the surface as one front, which reduces further than the order of the numbers or a
/// random one.
void Sweeper::sort_along_longest_axis() {
    glm::dvec3 low(0), high(0);
    for (const std::uint32_t vertex : queue_) {
        low = glm::min(low, rows_.position(vertex));
        high = glm::max(high, rows_.position(vertex));
    }
    const glm::dvec3 extent = high - low;
    const int axis = longest_side(extent);
    std::stable_sort(queue_.begin(), queue_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return rows_.position(a)[axis] < rows_.position(b)[axis];
    });
}

void Sweeper::queue(std::uint32_t vertex, Queue& next) {
    if (queued_[vertex] || !candidate_[vertex]) return;
    queued_[vertex] = 1;
    next.push_back(vertex);
}

bool Sweeper::process_serially(const Sweep& sweep, const Queue& round) {
    next_is_serial_ = false;
    for (const std::uint32_t vertex : round) {
        process(sweep, vertex, 0, round_, queue_);
        if (!advance(sweep, 0)) return false;
    }
    return true;
}

bool Sweeper::process_in_patches(const Sweep& sweep, const Queue& round) {
    start_pool();
    const Patches patches(rows_, round, depth_of_partitioning(round.size(), partitioning(sweep.effort)), cuts_++);
    std::vector<Patch> cut(patches.count());
    for (const std::uint32_t vertex : round) cut[patches.patch_of(rows_.position(vertex))].vertices.push_back(vertex);
    if (!defers_changed(sweep.effort)) std::reverse(cut.back().vertices.begin(), cut.back().vertices.end());
    pool_.run(cut.size(), [&](std::size_t worker, std::size_t number) {
        if (!process_patch(sweep, patches, number, worker, cut[number])) cancelled_ = true;
    });
    round_ += rounds_in_patch - 1;
    std::size_t deferred = 0;
    for (const Patch& patch : cut) {
        queue_.insert(queue_.end(), patch.next.begin(), patch.next.end());
        deferred += patch.deferred;
    }
    next_is_serial_ = 2 * deferred > round.size();
    return !cancelled_;
}

bool Sweeper::process_patch(const Sweep& sweep, const Patches& patches, std::size_t number, std::size_t worker,
                            Patch& patch) {
    Queue waiting;
    const std::uint32_t rounds = defers_changed(sweep.effort) ? rounds_in_patch : 1;
    for (std::uint32_t n = 0; n < rounds && !patch.vertices.empty(); ++n) {
        waiting.clear();
        for (const std::uint32_t vertex : patch.vertices) {
            if (is_deferred(sweep, vertex, round_ + n) || lies_in_patch(vertex, patches, number)) {
                process(sweep, vertex, worker, round_ + n, waiting);
            } else {
                ++patch.deferred;
                patch.next.push_back(vertex);
            }
            if (cancelled_ || !advance(sweep, worker)) return false;
        }
        std::swap(patch.vertices, waiting);
    }
    patch.next.insert(patch.next.end(), patch.vertices.begin(), patch.vertices.end());
    return true;
}

/// Whether the one-rings of all vertices of a coincidence class lie in a patch.
bool Sweeper::lies_in_patch(std::uint32_t vertex, const Patches& patches, std::size_t number) const {
    bool within = true;
    surface_.for_each_coincident(
        vertex, [&](std::uint32_t coincident) { within = within && ring_lies_in_patch(coincident, patches, number); });
    return within;
}

bool Sweeper::ring_lies_in_patch(std::uint32_t vertex, const Patches& patches, std::size_t number) const {
    return surface_.all_of_ring(
        vertex, [&](std::uint32_t neighbour) { return patches.contains(number, rows_.position(neighbour)); });
}

/// Whether the star has changed in this round, so that the vertex is deferred to the next one.
bool Sweeper::is_deferred(const Sweep& sweep, std::uint32_t vertex, std::uint32_t round) const {
    return defers_changed(sweep.effort) && changed_in_round_[vertex] == round;
}

void Sweeper::process(const Sweep& sweep, std::uint32_t vertex, std::size_t worker, std::uint32_t round, Queue& next) {
    const std::size_t before = next.size();
    queued_[vertex] = 0;
    if (is_deferred(sweep, vertex, round)) queue(vertex, next);
    else attempt(sweep, vertex, *removals_[worker], round, next);
    enqueued_ += next.size() - before;
    ++processed_;
}

void Sweeper::attempt(const Sweep& sweep, std::uint32_t vertex, Removal& removal, std::uint32_t round, Queue& next) {
    outcomes_[vertex] = removal.attempt(vertex, sweep.squared_limit, sweep.effort);
    if (outcomes_[vertex].refusal != Refusal::none) return;
    candidate_[vertex] = 0;
    removal.for_each_ring_vertex([&](std::uint32_t coincident) {
        const std::uint32_t neighbour = surface_.representative(coincident);
        outcomes_[neighbour].stale = true;
        changed_in_round_[neighbour] = round;
        if (may_succeed(sweep, neighbour)) queue(neighbour, next);
    });
}

/// Before the last sweep, what was refused for a bound is not tried again when its star has changed: few such vertices
/// could be removed, and the last sweep tries them anyway.
bool Sweeper::may_succeed(const Sweep& sweep, std::uint32_t vertex) const {
    return !defers_changed(sweep.effort) || outcomes_[vertex].refusal != Refusal::bound;
}

/// Only worker 0, the calling thread, reports.
bool Sweeper::advance(const Sweep& sweep, std::size_t worker) {
    if (worker != 0) return true;
    const double done = static_cast<double>(processed_) / static_cast<double>(enqueued_);
    return sweep.reporter.advance(removals_[0]->work(), sweep.start + sweep.share * done);
}

void Sweeper::start_pool() {
    pool_.start();
    while (removals_.size() < pool_.size())
        removals_.push_back(std::make_unique<Removal>(surface_, rows_, error_model_, checks_));
}

} // namespace meshbound
