/// \file
/// A pool of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
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
///
/// Each has a part of the items, the same in every loop of that length, so that it meets in its own caches what it left
/// there in the loop before; who is done with his helps the others.
class Pool {
  struct alignas(64) Next {
    std::atomic<std::size_t> value;
  };
  std::mutex one_loop_;
  std::function<void(std::size_t)> job_;
  std::vector<Next> next_;
  std::atomic<std::size_t> round_ = 0, busy_ = 0;
  std::atomic<bool> stop_ = false;
  std::vector<std::jthread> workers_;

 public:
  explicit Pool(int count) : next_(std::size_t(count)) {
    try {
      for (int i = 1; i < count; ++i) workers_.emplace_back([this, i] { serve(std::size_t(i)); });
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
    std::exception_ptr failure;
    std::size_t failed_at = n;
    std::mutex failure_mutex;
    const std::size_t threads = workers_.size() + 1;
    const std::size_t chunk = std::clamp<std::size_t>(n / (16 * threads), 1, 16);
    const auto begin = [&](std::size_t part) { return n * part / threads; };
    for (std::size_t part = 0; part < threads; ++part) next_[part].value = begin(part);
    const auto work = [&](std::size_t me) {
      for (std::size_t k = 0; k < threads; ++k) {
        const std::size_t part = (me + k) % threads, end = begin(part + 1);
        auto& next = next_[part].value;
        for (std::size_t from; (from = next.fetch_add(chunk, std::memory_order_relaxed)) < end;)
          for (std::size_t i = from; i < std::min(end, from + chunk); ++i) try {
              f(i);
            } catch (...) {
              const std::lock_guard lock(failure_mutex);
              if (i < failed_at) {
                failed_at = i;
                failure = std::current_exception();
              }
            }
      }
    };
    start(work);
    work(0);
    finish();
    if (failure) std::rethrow_exception(failure);
  }

 private:
  void stop() {
    stop_ = true;
    announce();
  }
  void announce() {
    round_.fetch_add(1);
    round_.notify_all();
  }
  template <class Work>
  void start(const Work& work) {
    job_ = std::ref(work);
    busy_ = workers_.size();
    announce();
  }
  void finish() {
    for (std::size_t busy; (busy = busy_) != 0;) wait_while(busy_, busy);
  }
  void serve(std::size_t me) {
    for (std::size_t seen = 0;;) {
      wait_while(round_, seen);
      seen = round_;
      if (stop_) return;
      job_(me);
      if (--busy_ == 0) busy_.notify_one();
    }
  }
  /// Looks for a while before it sleeps: the loops of a step follow each other within microseconds, and waking a thread
  /// takes longer than that.
  static void wait_while(const std::atomic<std::size_t>& value, std::size_t old) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(50);
    while (value == old)
      if (std::chrono::steady_clock::now() > until) return value.wait(old);
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
