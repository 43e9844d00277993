#include "util/thread_pool.hpp"

#include <system_error>
#include <utility>

namespace meshbound {

void ThreadPool::start() {
    if (std::exchange(started_, true)) return;
    try {
        for (std::size_t worker = 1; worker < workers_; ++worker)
            threads_.emplace_back([this, worker] { worker_loop(worker); });
    } catch (const std::system_error&) {
        // Fewer do the same work.
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(std::size_t tasks, const Work& work) {
    start();
    {
        const std::lock_guard lock(mutex_);
        work_ = &work;
        tasks_ = tasks;
        next_ = 0;
        busy_ = threads_.size();
        failure_ = nullptr;
        ++runs_;
    }
    begun_.notify_all();
    run_tasks(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    if (failure_) std::rethrow_exception(failure_);
}

/// What a thread does from its start to its end: it takes part in every run.
void ThreadPool::worker_loop(std::size_t worker) {
    for (std::size_t run = 1;; ++run) {
        {
            std::unique_lock lock(mutex_);
            begun_.wait(lock, [&] { return stopping_ || runs_ == run; });
            if (stopping_) return;
        }
        run_tasks(worker);
        const std::lock_guard lock(mutex_);
        if (--busy_ == 0) done_.notify_one();
    }
}

void ThreadPool::run_tasks(std::size_t worker) {
    try {
        for (std::size_t task = next_++; task < tasks_; task = next_++) (*work_)(worker, task);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
        next_ = tasks_;
    }
}

} // namespace meshbound
