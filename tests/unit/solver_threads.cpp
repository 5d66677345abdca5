/// \file
/// The answer does not depend on the threads, and a warm step allocates nothing.
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

#include "catch.hpp"
#include "passes/schemes.hpp"

namespace {

std::atomic<bool> counting = false;
std::atomic<int> allocations = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  if (counting.load(std::memory_order_relaxed)) ++allocations;
  size = (size + alignment - 1) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, size)) return p;
  throw std::bad_alloc();
}

}  // namespace

// Replaced for the whole program; they count only while the flag is up.
void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, std::size_t(alignment)); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace {

using namespace schemes;

/// Every number of the particles after 30 steps of a shaken body that flies at a wall, with sorts on the way.
template <class Scheme, class Executor>
auto after_30_steps(const Executor& executor) {
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename Scheme::Shape{},
                typename Scheme::Transfer{},
                typename Scheme::Update{},
                timestep::Cfl{.courant = 0.4},
                executor,
                boundary::Periodic{.axis = axis::x, .from = -5 * h, .to = 5 * h},
                boundary::Symmetry{.side = side::y_max, .at = 5 * h},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                aluminium};
  const geometry::Box<3> block{.lower = {-5 * h, -5 * h, 0}, .upper = {5 * h, 5 * h, 9 * h}};
  const geometry::Ball<3> hole{.centre = {0, 0, 4 * h}, .radius = 2 * h};
  solver.fill(block - hole, aluminium, {.per_axis = 2, .velocity = {2000, 100, -300}});
  shake(solver.particles(), 20);
  solver.refresh();
  for (int i = 0; i < 30; ++i) solver.step();
  CHECK(solver.sorts() > 1);
  auto all = columns(solver);
  for (const auto& part : solver.ledger().impulse) all.insert(all.end(), part.c, part.c + 3);
  all.insert(all.end(), {solver.time(), solver.ledger().work, solver.ledger().wall_loss});
  return all;
}

}  // namespace

TEMPLATE_TEST_CASE("any number of threads gives the same bits", "[solver][execution]", schemes::QuadraticApicUsl,
                   schemes::LinearFlipMusl, schemes::CubicFlipMusl, schemes::ContiguousGimpFlipMusl) {
  const auto serial = after_30_steps<TestType>(execution::Serial{});
  for (int threads : {1, 2, 3, 5}) {
    CAPTURE(threads);
    CHECK(same_bits(after_30_steps<TestType>(execution::Threads(threads)), serial));
  }
}

/// Metal in a channel: it moves through the blocks, but never to more of them than before.
TEMPLATE_TEST_CASE("a warm step allocates nothing, with a sort or without", "[solver][execution]",
                   schemes::QuadraticApicUsl, schemes::LinearFlipMusl, schemes::CubicFlipMusl,
                   schemes::ContiguousGimpFlipMusl) {
  const int threads = GENERATE(1, 2);
  Solver solver{grid::Cartesian<3>{.spacing = h},
                typename TestType::Shape{},
                typename TestType::Transfer{},
                typename TestType::Update{},
                timestep::Cfl{.courant = 0.4},
                execution::Threads(threads),
                boundary::Periodic{.axis = axis::x, .from = 0, .to = 8 * h},
                boundary::Symmetry{.side = side::y_min, .at = 0},
                boundary::Symmetry{.side = side::y_max, .at = 3 * h},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                boundary::Symmetry{.side = side::z_max, .at = 3 * h},
                load::BodyForce<3>{{0, 0, -1e9}},
                aluminium};
  solver.fill(geometry::Box<3>{.lower = {0, 0, 0}, .upper = {8 * h, 3 * h, 3 * h}}, aluminium,
              {.velocity = {4000, 0, 0}, .jitter = 0.3});
  for (int i = 0; i < 100; ++i) solver.step();
  const std::size_t sorts = solver.sorts();
  allocations = 0;
  counting = true;
  for (int i = 0; i < 50; ++i) solver.step();
  counting = false;
  CHECK(allocations == 0);
  CHECK(solver.sorts() > sorts);
}
