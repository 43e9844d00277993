#pragma once

#include <cstdint>
#include <vector>

#include "removal.hpp"
#include "ticker.hpp"

namespace meshbound {

/// The order of removal: few sweeps, each taking in turn whatever stays within its fraction of the bounds. A refused
/// candidate is remembered with the error it would have caused and skipped until its star changes or the limit passes that
/// error. A sweep ends when no vertex is left to look at.
class Sweeper {
public:
    /// `candidate[v]`: whether vertex v may go at all.
    Sweeper(Surface& surface, const Rows& rows, Accounting& accounting, std::vector<char> candidate);

    /// Sweeps with each limit (fractions of the bounds, rising), which takes the progress from `start` to `end`. False when
    /// the ticker cancelled.
    bool sweep(const std::vector<double>& limits, Ticker& ticker, double start, double end);

    /// The verdict on a vertex that is still there, from its last attempt.
    const Verdict& verdict(std::uint32_t vertex) const { return verdicts_[vertex]; }

private:
    bool sweep_once(double squared_limit, Removal::Effort effort, Ticker& ticker, double start, double share);
    bool waits(std::uint32_t vertex, Removal::Effort effort) const;
    void queue_candidates(double squared_limit);
    void queue(std::uint32_t vertex);
    void attempt(std::uint32_t vertex, double squared_limit, Removal::Effort effort);

    Removal removal_;
    std::vector<char> candidate_;
    std::vector<char> queued_;
    std::vector<char> fresh_;            // never looked at since its star changed
    std::vector<std::uint32_t> touched_; // the round in which the star last changed; rounds count from 1
    std::uint32_t round_ = 0;
    std::vector<Verdict> verdicts_;
    std::vector<std::uint32_t> queue_; // processed from the front; grows at the back
};

} // namespace meshbound
