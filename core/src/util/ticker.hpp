#pragma once

#include <algorithm>
#include <cstddef>

#include "meshbound/options.hpp"

namespace meshbound {

/// Reports progress and asks for cancellation once in a while: often enough to answer within milliseconds, rarely enough to
/// cost nothing. Counts work instead of time, so that asking the clock is not part of the inner loop.
class Ticker {
public:
    explicit Ticker(const Progress& progress) : progress_(progress) {}

    /// `work` units were done, `progress` of what lies ahead (see start_from) is reached. False when the caller wants to
    /// cancel.
    bool tick(std::size_t work, double progress) {
        reached_ = std::max(reached_, start_ + (1 - start_) * std::min(progress, 1.0));
        return tick(work);
    }

    /// What was done so far is this share of the whole; progress counts from here.
    void start_from(double share) { reached_ = start_ = std::max(reached_, share); }

    /// The same, no farther than before.
    bool tick(std::size_t work) {
        pending_ += work;
        return pending_ < work_between_calls ? !cancelled_ : ask();
    }

    /// Reports and asks at once: between the steps of preparing, each of which takes a while on a large mesh.
    bool ask() {
        pending_ = 0;
        if (progress_ && !cancelled_) cancelled_ = !progress_(reached_);
        return !cancelled_;
    }

    /// Tells the caller that all is done.
    void finish() {
        if (progress_ && !cancelled_) progress_(1.0);
    }

    bool cancelled() const { return cancelled_; }

private:
    /// A small star takes a few microseconds; this many take a few milliseconds.
    static constexpr std::size_t work_between_calls = 512;

    const Progress& progress_;
    std::size_t pending_ = 0;
    double reached_ = 0, start_ = 0;
    bool cancelled_ = false;
};

} // namespace meshbound
