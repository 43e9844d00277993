#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "util/progress_reporter.hpp"
#include "util/thread_pool.hpp"

namespace meshbound {

/// Calls `visit(worker, i)` once for each i below `count`, in no particular order; workers take chunks of `chunk_size`
/// consecutive i. False where the caller cancels; then some were not visited. Only worker 0, the calling thread,
/// reports progress.
template <class Visit>
bool parallel_for(ThreadPool& pool, ProgressReporter& reporter, std::size_t count, std::size_t chunk_size,
                  const Visit& visit) {
    std::atomic<bool> cancelled{false};
    pool.run((count + chunk_size - 1) / chunk_size, [&](std::size_t worker, std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * chunk_size);
        for (std::size_t i = chunk * chunk_size; i < end && !cancelled; ++i) {
            visit(worker, i);
            if (worker == 0 && !reporter.advance(1)) cancelled = true;
        }
    });
    return !cancelled;
}

} // namespace meshbound
