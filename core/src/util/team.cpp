#include "util/team.hpp"

#include <system_error>
#include <utility>

namespace meshbound {

void Team::gather() {
    if (std::exchange(gathered_, true)) return;
    try {
        for (std::size_t member = 1; member < members_; ++member)
            threads_.emplace_back([this, member] { serve(member); });
    } catch (const std::system_error&) {
        // Fewer do the same work.
    }
}

Team::~Team() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    begun_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void Team::run(std::size_t tasks, const Work& work) {
    gather();
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
    take_tasks(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    if (failure_) std::rethrow_exception(failure_);
}

/// The life of a thread: to take part in every run.
void Team::serve(std::size_t member) {
    for (std::size_t run = 1;; ++run) {
        {
            std::unique_lock lock(mutex_);
            begun_.wait(lock, [&] { return over_ || runs_ == run; });
            if (over_) return;
        }
        take_tasks(member);
        const std::lock_guard lock(mutex_);
        if (--busy_ == 0) done_.notify_one();
    }
}

void Team::take_tasks(std::size_t member) {
    try {
        for (std::size_t task = next_++; task < tasks_; task = next_++) (*work_)(member, task);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
        next_ = tasks_;
    }
}

} // namespace meshbound
