/// \file
/// A pool of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <mote/core/error.hpp>
#include <mote/core/role.hpp>

namespace mote::execution {

namespace detail {

/// Workers that wait for a job, take its items one chunk at a time, and report the failure with the lowest index.
class Pool {
  std::mutex one_loop_, mutex_;
  std::condition_variable wake_, idle_;
  std::function<void()> job_;
  std::size_t round_ = 0;
  int busy_ = 0;
  bool stop_ = false;
  std::vector<std::jthread> workers_;

 public:
  explicit Pool(int count) {
    try {
      for (int i = 1; i < count; ++i) workers_.emplace_back([this] { serve(); });
    } catch (...) {  // no more threads to be had: those that run must not wait for ever
      stop();
      throw;
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() { stop(); }

  template <class F>
  void for_each(std::size_t n, const F& f) {
    if (n == 0) return;
    const std::lock_guard turn(one_loop_);
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::size_t failed_at = n;
    std::mutex failure_mutex;
    // a few items at a time: the counter is shared, and neighbouring tiles share nodes
    const std::size_t chunk = std::max<std::size_t>(1, std::min<std::size_t>(16, n / (8 * (workers_.size() + 1))));
    const auto work = [&] {
      for (std::size_t from; (from = next.fetch_add(chunk, std::memory_order_relaxed)) < n;)
        for (std::size_t i = from; i < std::min(n, from + chunk); ++i) try {
            f(i);
          } catch (...) {
            const std::lock_guard lock(failure_mutex);
            if (i < failed_at) {
              failed_at = i;
              failure = std::current_exception();
            }
          }
    };
    start(work);
    work();
    finish();
    if (failure) std::rethrow_exception(failure);
  }

 private:
  void stop() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_all();
  }
  template <class Work>
  void start(const Work& work) {
    {
      const std::lock_guard lock(mutex_);
      job_ = std::ref(work);
      busy_ = int(workers_.size());
      ++round_;
    }
    wake_.notify_all();
  }
  void finish() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [&] { return busy_ == 0; });
  }
  void serve() {
    std::size_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
      wake_.wait(lock, [&] { return stop_ || round_ != seen; });
      if (stop_) return;
      seen = round_;
      const auto job = job_;
      lock.unlock();
      job();
      lock.lock();
      if (--busy_ == 0) idle_.notify_one();
    }
  }
};

}  // namespace detail

/// `count` threads, the caller's included; 0 takes what the machine has. Copies share one pool.
///
/// The solver's answer is the same to the last bit for any count. One loop at a time runs on a pool; others wait.
class Threads {
  std::shared_ptr<detail::Pool> pool_;
  int count_;

 public:
  using role = mote::role::Execution;

  /// \param count 1 to 1024 threads, or 0 for as many as the machine has.
  explicit Threads(int count = 0) : count_(count > 0 ? count : std::max(1, int(std::thread::hardware_concurrency()))) {
    require(count >= 0 && count <= 1024, "the number of threads is ", count, "; it must be in [0, 1024]");
    pool_ = std::make_shared<detail::Pool>(count_);
  }

  int concurrency() const { return count_; }

  template <class F>
  void for_each(std::size_t n, const F& f) const {
    pool_->for_each(n, f);
  }
};

}  // namespace mote::execution
