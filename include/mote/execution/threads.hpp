/// \file
/// A pool of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
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
  /// Not a template over what is called: a step has many loops, and this would be compiled for each.
  struct Job {
    void (*call)(const void*, std::size_t);
    const void* f;
    std::size_t n, chunk;
  };
  std::mutex one_loop_, failure_mutex_;
  Job job_ = {};
  std::exception_ptr failure_;
  std::size_t failed_at_ = 0;
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

  /// Calls call(f, i) for every i < n.
  void for_each(std::size_t n, void (*call)(const void*, std::size_t), const void* f) {
    if (n == 0) return;
    const std::lock_guard turn(one_loop_);
    job_ = {call, f, n, std::clamp<std::size_t>(n / (16 * next_.size()), 1, 16)};
    for (std::size_t part = 0; part < next_.size(); ++part) next_[part].value = begin(part);
    failure_ = nullptr;
    failed_at_ = n;
    busy_ = workers_.size();
    announce();
    work(0);
    for (std::size_t busy; (busy = busy_) != 0;) wait_while(busy_, busy);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
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
  std::size_t begin(std::size_t part) const { return job_.n * part / next_.size(); }
  /// One's own part, then what others have left of theirs.
  void work(std::size_t me) {
    for (std::size_t k = 0; k < next_.size(); ++k) {
      const std::size_t part = (me + k) % next_.size(), end = begin(part + 1);
      for (std::size_t from; (from = next_[part].value.fetch_add(job_.chunk, std::memory_order_relaxed)) < end;)
        for (std::size_t i = from; i < std::min(end, from + job_.chunk); ++i) try {
            job_.call(job_.f, i);
          } catch (...) {
            failed(i);
          }
    }
  }
  void failed(std::size_t i) {
    const std::lock_guard lock(failure_mutex_);
    if (i >= failed_at_) return;
    failed_at_ = i;
    failure_ = std::current_exception();
  }
  void serve(std::size_t me) {
    for (std::size_t seen = 0;;) {
      wait_while(round_, seen);
      seen = round_;
      if (stop_) return;
      work(me);
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
    pool_->for_each(
        n, [](const void* called, std::size_t i) { (*static_cast<const F*>(called))(i); }, std::addressof(f));
  }
};

}  // namespace mote::execution
