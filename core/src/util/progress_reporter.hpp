#pragma once

#include <algorithm>
#include <cstddef>

#include "meshbound/progress.hpp"

namespace meshbound {

/// Reports progress and polls for cancellation, every few milliseconds. It counts work instead of time, so that the
/// inner loop does not read the clock.
class ProgressReporter {
public:
    explicit ProgressReporter(const Progress& progress) : progress_(progress) {}

    /// `work` units were done since the last call; `progress`, 0…1, is that of what was left at start_from. False when
    /// the caller cancels.
    bool advance(std::size_t work, double progress) {
        reached_ = std::max(reached_, start_ + (1 - start_) * std::min(progress, 1.0));
        return advance(work);
    }

    /// What was done so far is this share of the whole; `advance` counts from here.
    void start_from(double share) { reached_ = start_ = std::max(reached_, share); }

    /// The same, with the progress as it was.
    bool advance(std::size_t work) {
        pending_ += work;
        return pending_ < work_between_calls ? !cancelled_ : poll();
    }

    /// Reports and polls at once: for steps of the preparation, each of which takes a while on a large mesh.
    bool poll() {
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
    /// The unit is a small star, some microseconds; this many take some milliseconds.
    static constexpr std::size_t work_between_calls = 512;

    const Progress& progress_;
    std::size_t pending_ = 0;
    double reached_ = 0, start_ = 0;
    bool cancelled_ = false;
};

} // namespace meshbound
