#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "reduction/patches.hpp"
#include "reduction/removal.hpp"
#include "util/progress_reporter.hpp"
#include "util/thread_pool.hpp"

namespace meshbound {

/// The order of removal: a few sweeps, each of which removes what stays within its fraction of the bounds. A sweep goes
/// in rounds: what changes in one is tried again in the next. It ends when the queue is empty. A refused candidate is
/// kept with the error that it would have caused. What was refused for a bound is tried again in a later sweep, if its
/// star has changed or that error is within the limit; within a sweep, when its star changes, in the last one only.
///
/// A large round is partitioned into patches, which are processed in parallel: of each patch the vertices whose
/// neighbours all lie in it, before the last sweep for some rounds in a row. What a removal reads and writes belongs to
/// the vertices of its ring, so patches are independent. The rest is deferred to the next round, whose cuts run
/// elsewhere. Cuts follow from positions alone, so the result is the same for any number of threads.
class Sweeper {
public:
    /// `candidate[v]`: whether v is the lowest vertex of a coincidence class that may be removed.
    Sweeper(Surface& surface, const Rows& rows, ErrorModel& error_model, std::vector<char> candidate, ThreadPool& pool,
            const ValidityChecks& checks);

    /// Sweeps with each limit (fractions of the bounds, rising), which takes the progress from `start` to `end`; calls
    /// `before_last` where the last sweep begins and another one went before. False when the caller cancelled.
    bool sweep(const std::vector<double>& limits, ProgressReporter& reporter, double start, double end,
               const std::function<void()>& before_last = {});

    /// Whether a coincidence class that is left was a candidate. It is given by its lowest vertex, as below.
    bool is_candidate(std::uint32_t vertex) const { return candidate_[vertex]; }
    /// What came of the last attempt to remove a vertex that is left.
    const RemovalOutcome& outcome(std::uint32_t vertex) const { return outcomes_[vertex]; }

private:
    /// One sweep under way.
    struct Sweep {
        double squared_limit;
        Removal::Effort effort;
        ProgressReporter& reporter;
        double start, share; // of the progress
    };
    using Queue = std::vector<std::uint32_t>;
    struct Patch {
        Queue vertices, next;
        std::size_t deferred = 0;
    };

    bool sweep_once(const Sweep& sweep);
    void queue_candidates(double squared_limit);
    void sort_along_longest_axis();
    void queue(std::uint32_t vertex, Queue& next);
    bool process_serially(const Sweep& sweep, const Queue& round);
    bool process_in_patches(const Sweep& sweep, const Queue& round);
    bool process_patch(const Sweep& sweep, const Patches& patches, std::size_t number, std::size_t worker,
                       Patch& patch);
    bool ring_lies_in_patch(std::uint32_t vertex, const Patches& patches, std::size_t number) const;
    bool lies_in_patch(std::uint32_t vertex, const Patches& patches, std::size_t number) const;
    bool is_deferred(const Sweep& sweep, std::uint32_t vertex, std::uint32_t round) const;
    void process(const Sweep& sweep, std::uint32_t vertex, std::size_t worker, std::uint32_t round, Queue& next);
    void attempt(const Sweep& sweep, std::uint32_t vertex, Removal& removal, std::uint32_t round, Queue& next);
    bool may_succeed(const Sweep& sweep, std::uint32_t vertex) const;
    bool advance(const Sweep& sweep, std::size_t worker);
    void start_pool();

    Surface& surface_;
    const Rows& rows_;
    ErrorModel& error_model_;
    ThreadPool& pool_; // started for the first large round
    ValidityChecks checks_;
    std::vector<std::unique_ptr<Removal>> removals_; // by worker
    std::vector<char> candidate_;                    // false once it is removed
    std::vector<char> queued_;
    std::vector<std::uint32_t> changed_in_round_; // the round in which the star last changed; rounds count from 1
    std::uint32_t round_ = 0;
    std::uint32_t cuts_ = 0;
    bool next_is_serial_ = false; // the last round deferred too much
    std::vector<RemovalOutcome> outcomes_;
    Queue queue_;                           // of the next round
    std::atomic<std::size_t> enqueued_{0};  // vertices queued in this sweep …
    std::atomic<std::size_t> processed_{0}; // … and of these processed
    std::atomic<bool> cancelled_{false};
};

} // namespace meshbound
