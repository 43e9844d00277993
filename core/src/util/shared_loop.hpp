#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "util/team.hpp"
#include "util/ticker.hpp"

namespace meshbound {

/// Calls `visit(member, i)` for each i below `count`, shared out among a team: its members take runs of `at_once` neighbours
/// in turn, each i once, in no order. False where the ticker cancels, which the caller's own thread alone asks; then some were
/// not visited.
template <class Visit>
bool share_out(Team& team, Ticker& ticker, std::size_t count, std::size_t at_once, const Visit& visit) {
    std::atomic<bool> cancelled{false};
    team.run((count + at_once - 1) / at_once, [&](std::size_t member, std::size_t run) {
        const std::size_t end = std::min(count, (run + 1) * at_once);
        for (std::size_t i = run * at_once; i < end && !cancelled; ++i) {
            visit(member, i);
            if (member == 0 && !ticker.tick(1)) cancelled = true;
        }
    });
    return !cancelled;
}

} // namespace meshbound
