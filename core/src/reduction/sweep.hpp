#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "reduction/patches.hpp"
#include "reduction/removal.hpp"
#include "util/team.hpp"
#include "util/ticker.hpp"

namespace meshbound {

/// The order of removal: few sweeps, each taking in turn whatever stays within its fraction of the bounds. A sweep
/// goes in rounds: what a round changes the next one looks at. It ends when no vertex is left to look at. A refused candidate
/// is remembered with the error it would have caused. What a bound refused is looked at again in a later sweep, where its
/// star has changed or the limit has passed that error; within a sweep, when its star changes, in the last one alone.
///
/// A large round is cut into patches, which several threads take at once: of each the vertices whose neighbours all lie in the
/// same patch, before the last sweep some rounds in a row. What a removal reads and writes belongs to its ring's vertices, so
/// patches have nothing in common. The rest waits for the next round, whose cut runs elsewhere. Cuts follow from positions
/// alone, so the result is the same for any number of threads.
class Sweeper {
public:
    /// `candidate[v]`: whether the site that vertex v names may go at all.
    Sweeper(Surface& surface, const Rows& rows, Accounting& accounting, std::vector<char> candidate, Team& team,
            const Guards& guards);

    /// Sweeps with each limit (fractions of the bounds, rising), which takes the progress from `start` to `end`; calls
    /// `before_last` where the last sweep begins and another one went before. False when the ticker cancelled.
    bool sweep(const std::vector<double>& limits, Ticker& ticker, double start, double end,
               const std::function<void()>& before_last = {});

    /// Whether a site that is still there was allowed to go at all.
    bool is_candidate(std::uint32_t vertex) const { return candidate_[vertex]; }
    /// The verdict on a vertex that is still there, from its last attempt.
    const Verdict& verdict(std::uint32_t vertex) const { return verdicts_[vertex]; }

private:
    /// One sweep under way.
    struct Sweep {
        double squared_limit;
        Removal::Effort effort;
        Ticker& ticker;
        double start, share; // of the progress
    };
    using Queue = std::vector<std::uint32_t>;
    struct Patch {
        Queue vertices, next;
        std::size_t put_off = 0;
    };

    bool sweep_once(const Sweep& sweep);
    void queue_candidates(double squared_limit);
    void line_up();
    void queue(std::uint32_t vertex, Queue& next);
    bool take_whole(const Sweep& sweep, const Queue& round);
    bool take_in_patches(const Sweep& sweep, const Queue& round);
    bool take_patch(const Sweep& sweep, const Patches& patches, std::size_t number, std::size_t member, Patch& patch);
    bool ring_lies_within(std::uint32_t vertex, const Patches& patches, std::size_t number) const;
    bool lies_within(std::uint32_t vertex, const Patches& patches, std::size_t number) const;
    bool waits(const Sweep& sweep, std::uint32_t vertex, std::uint32_t round) const;
    void take(const Sweep& sweep, std::uint32_t vertex, std::size_t member, std::uint32_t round, Queue& next);
    void attempt(const Sweep& sweep, std::uint32_t vertex, Removal& removal, std::uint32_t round, Queue& next);
    bool has_chance(const Sweep& sweep, std::uint32_t vertex) const;
    bool tick(const Sweep& sweep, std::size_t member);
    void gather_team();

    Surface& surface_;
    const Rows& rows_;
    Accounting& accounting_;
    Team& team_; // gathered for the first large round
    Guards guards_;
    std::vector<std::unique_ptr<Removal>> removals_; // by member of the team
    std::vector<char> candidate_;                    // what has gone is none any more
    std::vector<char> queued_;
    std::vector<std::uint32_t> touched_; // the round in which the star last changed; rounds count from 1
    std::uint32_t round_ = 0;
    std::uint32_t cuts_ = 0;
    bool next_whole_ = false; // the last cut left too much to the next round
    std::vector<Verdict> verdicts_;
    Queue queue_;                       // of the next round
    std::atomic<std::size_t> known_{0}; // vertices that were queued in this sweep …
    std::atomic<std::size_t> taken_{0}; // … and of these looked at
    std::atomic<bool> cancelled_{false};
};

} // namespace meshbound
