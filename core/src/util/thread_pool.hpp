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

/// A pool of threads, of which the caller is worker 0. Which worker gets which task is not deterministic, so no result
/// may depend on it.
class ThreadPool {
public:
    /// Does one task. `worker`: 0 … size() - 1; no two tasks run on the same worker at once.
    using Work = std::function<void(std::size_t worker, std::size_t task)>;

    explicit ThreadPool(std::size_t workers) : workers_(workers) {}
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// Starts the threads, unless they are running. Where the system refuses one (a WebAssembly module without threads,
    /// or without a free web worker), the pool is smaller.
    void start();

    std::size_t size() const { return threads_.size() + 1; }

    /// Does the tasks 0 … tasks - 1, each once, and returns when all are done. Rethrows the exception of a task; tasks
    /// that were not begun by then are left out.
    void run(std::size_t tasks, const Work& work);

private:
    void worker_loop(std::size_t worker);
    void run_tasks(std::size_t worker);

    std::size_t workers_;
    bool started_ = false;
    std::vector<std::thread> threads_;
    std::mutex mutex_; // of all members below but next_
    std::condition_variable begun_, done_;
    const Work* work_ = nullptr;
    std::size_t tasks_ = 0;
    std::atomic<std::size_t> next_{0}; // the task that is taken next
    std::size_t runs_ = 0;             // begun so far
    std::size_t busy_ = 0;             // threads that have not finished this run
    bool stopping_ = false;
    std::exception_ptr failure_;
};

} // namespace meshbound
