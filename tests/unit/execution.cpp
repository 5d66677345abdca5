/// \file
/// Executors: each item once, on all threads, and the failure of the lowest item.
#include <mote/execution/concept.hpp>
#include <mote/execution/serial.hpp>
#include <mote/execution/threads.hpp>

#include <set>

#include "catch.hpp"

using namespace mote;

TEST_CASE("executors satisfy their concept", "[execution]") {
  STATIC_REQUIRE(Execution<execution::Serial>);
  STATIC_REQUIRE(Execution<execution::Threads>);
  STATIC_REQUIRE(!Execution<int>);
}

TEST_CASE("serial calls the items in order", "[execution]") {
  std::vector<std::size_t> seen;
  execution::Serial{}.for_each(4, [&](std::size_t i) { seen.push_back(i); });
  CHECK(seen == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(execution::Serial{}.concurrency() == 1);
}

TEST_CASE("threads call each item exactly once", "[execution]") {
  const int count = GENERATE(1, 2, 3, 7);
  const execution::Threads threads(count);
  CHECK(threads.concurrency() == count);
  for (std::size_t n : {0, 1, 2, 5, 1000}) {
    std::vector<std::atomic<int>> calls(n);
    threads.for_each(n, [&](std::size_t i) { ++calls[i]; });
    for (const auto& c : calls) REQUIRE(c == 1);
  }
}

TEST_CASE("all threads are there at the same time", "[execution]") {
  const int count = 3;
  std::atomic<int> arrived = 0;
  // each of the first items waits for the others, so one thread alone would never return
  execution::Threads(count).for_each(count, [&](std::size_t) {
    ++arrived;
    while (arrived < count) std::this_thread::yield();
  });
  CHECK(arrived == count);
}

TEST_CASE("what the items wrote is there when the loop returns", "[execution]") {
  const execution::Threads threads(4);
  std::vector<int> value(100, 0);
  for (int round = 1; round <= 500; ++round) {
    threads.for_each(value.size(), [&](std::size_t i) { ++value[i]; });
    REQUIRE(std::all_of(value.begin(), value.end(), [&](int v) { return v == round; }));
  }
}

TEST_CASE("the failure of the lowest item arrives, and the other items are done", "[execution]") {
  const int count = GENERATE(1, 2, 5);
  const execution::Threads threads(count);
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> done = 0;
    const auto work = [&](std::size_t i) {
      ++done;
      if (i % 100 == 37) throw std::runtime_error(std::to_string(i));
    };
    REQUIRE_THROWS_WITH(threads.for_each(1000, work), "37");
    REQUIRE(done == 1000);
  }
}

TEST_CASE("threads work on after a failure", "[execution]") {
  const execution::Threads threads(2);
  CHECK_THROWS(threads.for_each(10, [](std::size_t) { throw 1; }));
  std::atomic<int> calls = 0;
  threads.for_each(10, [&](std::size_t) { ++calls; });
  CHECK(calls == 10);
}

TEST_CASE("zero threads are those of the machine, and nonsense is refused", "[execution]") {
  CHECK(execution::Threads().concurrency() == std::max(1, int(std::thread::hardware_concurrency())));
  CHECK_THROWS_AS(execution::Threads(-1), InputError);
  CHECK_THROWS_AS(execution::Threads(1025), InputError);
}

TEST_CASE("a copy shares its pool, and outlives the original", "[execution]") {
  auto original = std::make_unique<execution::Threads>(2);
  const execution::Threads copy = *original;
  original.reset();
  std::atomic<int> calls = 0;
  copy.for_each(10, [&](std::size_t) { ++calls; });
  CHECK(calls == 10);
}
