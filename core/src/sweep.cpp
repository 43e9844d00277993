#include "sweep.hpp"

#include <algorithm>

namespace meshbound {

Sweeper::Sweeper(Surface& surface, const Rows& rows, Accounting& accounting, std::vector<char> candidate)
    : removal_(surface, rows, accounting), candidate_(std::move(candidate)), queued_(candidate_.size(), 0),
      fresh_(candidate_.size(), 1), touched_(candidate_.size(), 0), verdicts_(candidate_.size()) {}

bool Sweeper::sweep(const std::vector<double>& limits, Ticker& ticker, double start, double end) {
    const double share = (end - start) / static_cast<double>(limits.size());
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const bool last = i + 1 == limits.size(); // before, a refused candidate gets another chance anyway
        const Removal::Effort effort = last ? Removal::Effort::thorough : Removal::Effort::best;
        if (!sweep_once(limits[i] * limits[i], effort, ticker, start + static_cast<double>(i) * share, share))
            return false;
    }
    return true;
}

/// Everything whose star changed since it was last looked at, or whose known error the limit has passed.
void Sweeper::queue_candidates(double squared_limit) {
    queue_.clear();
    for (std::uint32_t vertex = 0; vertex < candidate_.size(); ++vertex) {
        const Verdict& verdict = verdicts_[vertex];
        if (fresh_[vertex] || (verdict.refusal == Refusal::bound && verdict.squared_ratio <= squared_limit))
            queue(vertex);
    }
}

void Sweeper::queue(std::uint32_t vertex) {
    if (queued_[vertex] || !candidate_[vertex]) return;
    queued_[vertex] = 1;
    queue_.push_back(vertex);
}

void Sweeper::attempt(std::uint32_t vertex, double squared_limit, Removal::Effort effort) {
    fresh_[vertex] = 0;
    verdicts_[vertex] = removal_.attempt(vertex, squared_limit, effort);
    if (verdicts_[vertex].refusal != Refusal::none) return;
    candidate_[vertex] = 0;
    for (const std::uint32_t neighbour : removal_.hole().ring) {
        fresh_[neighbour] = 1;
        touched_[neighbour] = round_;
        queue(neighbour);
    }
}

/// Before the last sweep, a vertex whose star has changed waits for the next round: removing one after its neighbour, along
/// a numbering that runs in rows, would drag a front of long triangles, and of all that is tracked in them, over the surface.
bool Sweeper::waits(std::uint32_t vertex, Removal::Effort effort) const {
    return effort == Removal::Effort::best && touched_[vertex] == round_;
}

bool Sweeper::sweep_once(double squared_limit, Removal::Effort effort, Ticker& ticker, double start, double share) {
    queue_candidates(squared_limit);
    std::size_t round_end = 0;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
        if (next == round_end) {
            ++round_;
            round_end = queue_.size();
        }
        const std::uint32_t vertex = queue_[next];
        queued_[vertex] = 0;
        if (waits(vertex, effort)) {
            queue(vertex);
            continue;
        }
        attempt(vertex, squared_limit, effort);
        const double done = static_cast<double>(next + 1) / static_cast<double>(queue_.size());
        if (!ticker.tick(removal_.work(), start + share * done)) return false;
    }
    return true;
}

} // namespace meshbound
