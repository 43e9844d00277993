#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace meshbound {

/// Threads that share tasks out among themselves; the caller is one of them. Which of them does a task is chance, so nothing
/// that a task leaves behind may depend on it.
class Team {
public:
    /// Does one task. `member`: which of the team does it, 0 … size() - 1; one at a time is never two.
    using Work = std::function<void(std::size_t member, std::size_t task)>;

    explicit Team(std::size_t members) : members_(members) {}
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team();

    /// Starts the threads, unless they run already. Where no more can be started (a WebAssembly module without them, or
    /// without another worker), the team is smaller.
    void gather();

    std::size_t size() const { return threads_.size() + 1; }

    /// Does the tasks 0 … tasks - 1, each once, and returns when all are done. Passes on an exception of one of them; tasks
    /// that were not begun by then are left out.
    void run(std::size_t tasks, const Work& work);

private:
    void serve(std::size_t member);
    void take_tasks(std::size_t member);

    std::size_t members_;
    bool gathered_ = false;
    std::vector<std::thread> threads_;
    std::mutex mutex_; // of all that is below but next_
    std::condition_variable begun_, done_;
    const Work* work_ = nullptr;
    std::size_t tasks_ = 0;
    std::atomic<std::size_t> next_{0}; // the task that is taken next
    std::size_t runs_ = 0;             // begun so far
    std::size_t busy_ = 0;             // threads that are not done with this run
    bool over_ = false;
    std::exception_ptr failure_;
};

} // namespace meshbound
