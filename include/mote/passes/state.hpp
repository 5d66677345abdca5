/// \file
/// The state of a computation: bodies, tiles, nodes, who is awake, and what happens to them between steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include <mote/passes/conduction.hpp>
#include <mote/passes/grid_update.hpp>
#include <mote/passes/images.hpp>
#include <mote/passes/messages.hpp>
#include <mote/passes/scatter.hpp>
#include <mote/passes/sleep.hpp>
#include <mote/passes/sort.hpp>
#include <mote/passes/traction.hpp>

namespace mote::passes {

/// What the phases of a step work on.
template <class Shape, class Transfer, class T, int D, class Execution, class Sleep, class Loads, class Materials>
class State;

template <class Shape, class Transfer, class T, int D, class Execution, class Sleep, class Loads, class... Materials>
class State<Shape, Transfer, T, D, Execution, Sleep, Loads, std::tuple<Materials...>> {
  template <class M>
  using BodyOf = Body<M, T, D, Transfer, Shape, surface_fields<Loads, D>>;
  using Bodies = std::tuple<BodyOf<Materials>...>;
  static_assert(
      can_be_told_apart<Materials...>,
      "mote: two materials of one solver have the same C++ type and no operator==, so fill() cannot tell them "
      "apart; add a defaulted operator== to their parts");

 protected:
  static constexpr bool loads_surfaces = surface_fields<Loads, D>::size > 0;
  static constexpr bool conducts = (Conducts<Materials> || ...);
  static_assert(!(conducts && Sleep::sleeps),
                "mote: heat flows in material at rest too; take sleep::Never with heat::Conducting");

  Frame<T, D> frame_;
  Transfer transfer_;
  Execution executor_;
  grid::Domain<D> domain_;
  Loads loads_;
  Bodies bodies_;
  Tiling<D> tiling_;
  [[no_unique_address]] Sleeper<Sleep, T, D> sleeper_;
  [[no_unique_address]] Conduction<T, D, conducts> conduction_;
  [[no_unique_address]] Surface<Loads, D> surface_;
  Linker<T, D> linker_;
  Orbits<D> orbits_;
  grid::Blocks<T, D> blocks_;
  AlignedVector<T> accumulators_;
  std::vector<TileReport> reports_;
  std::vector<GridLedger<D>> block_ledgers_;
  std::vector<double> block_sums_;
  GridLedger<D> ledger_;
  bool remaps_;
  double disorder_ = 0;  ///< windows since the last sort beyond what the sorted particles took
  double time_ = 0, dt_ = 0;
  Vec<double, D> frame_velocity_{};  ///< velocity of the grid in this step, m/s

 public:
  template <class Grid, class Boundaries>
  State(const Grid& grid, const Transfer& transfer, const Execution& executor, const Sleep& sleep,
        const Boundaries& boundaries, const Loads& loads, const std::tuple<Materials...>& materials, bool remaps)
      : frame_{grid.spacing, grid.origin},
        transfer_(transfer),
        executor_(executor),
        domain_(grid.spacing, grid.origin, boundaries),
        loads_(loads),
        bodies_(std::apply(
            [](const auto&... m) {
              return Bodies{{m, {}, 0, 0}...};
            },
            materials)),
        sleeper_(sleep),
        conduction_(grid.spacing, Shape::support, materials),
        remaps_(remaps) {
    require_distinct(materials);
  }

  /// Whether a particle has drifted out of its tile's reach, so that a sort is due.
  bool strayed() const {
    if constexpr (Sleep::sleeps)
      if (sleeper_.strayed(tiling_.tiles, frame_.spacing)) return true;
    return std::any_of(tiling_.tiles.begin(), tiling_.tiles.end(), [](const auto& t) { return t.strayed(); });
  }

  /// Whether a sort is due: because a particle has strayed, or because it pays. Particles that left their cells cost
  /// windows; a sort is due when these have cost as much as a sort since the last one. A window costs about 3.4 ns per
  /// node of the kernel and a sort 50 ns per particle (measured with quadratic splines), hence 15.
  bool sort_due() const {
    constexpr int nodes = D == 1 ? Shape::support : (D == 2 ? 1 : Shape::support) * Shape::support * Shape::support;
    return disorder_ * nodes > 15 * double(size()) || strayed();
  }

  /// Decides who sleeps through the next step; nobody, if `everyone` is to wake. \return whether a sort is due first
  bool rouse(bool everyone) requires Sleep::sleeps {
    if (sleeper_.decide(tiling_, everyone))
      for_each_tile(
          [&](auto& body, std::uint32_t t) { sleeper_.template wake<Shape>(body, t, tiling_.tiles[t], frame_); });
    return strayed();
  }

  /// Brings the positions of those who sleep up to date.
  void settle() {
    if constexpr (Sleep::sleeps) {
      if (!sleeper_.unsettled()) return;
      for_each_tile([&](auto& body, std::uint32_t t) { sleeper_.settle(body, t, tiling_.tiles[t], frame_); });
      sleeper_.settled();
    }
  }

  /// Particles into cell order, tiles, links and blocks anew.
  template <class S>
  void sort(S& sorter, std::size_t step) {
    settle();
    disorder_ = 0;
    if constexpr (Sleep::sleeps) sleeper_.clear();
    tiling_.tiles.clear();
    for_each_body([&](auto& body) {
      const auto lost = [&](std::size_t p, const char* why) {
        throw NumericalError(describe_lost(body, p, why, step));
      };
      sorter.template operator()<Shape>(body, tiling_.tiles, frame_, domain_, executor_, lost);
    });
    linker_(tiling_, blocks_, domain_, Shape::support, Shape::first);
    orbits_.find(blocks_, domain_, Shape::support, Shape::inertia);
    allocate();
    if constexpr (Sleep::sleeps) sleeper_.reset(tiling_, domain_, Shape::support);
    const auto frame_velocity = cast<T>(grid_velocity(time_ + dt_));
    for_each_tile([&](auto& body, std::uint32_t t) {
      reports_[t] = survey_tile<Shape>(body, tiling_.tiles[t], frame_, frame_velocity);
      look(body, t);
    });
    if (std::any_of(tiling_.tiles.begin(), tiling_.tiles.end(), [](const auto& t) { return t.unlinked(); }))
      throw NumericalError(
          "mote: the number type does not resolve positions to a cell; put the grid's origin nearer to the particles, "
          "or take double");
    if constexpr (loads_surfaces) {
      surface_.clear(blocks_.nodes());
      for_each_body([&](const auto& body) { surface_.find(body, loads_); });
    }
    check(step);
  }

  /// Throws NumericalError if a particle has left the range of its equation of state, or of numbers.
  void check(std::size_t step) const {
    for_each_body([&](const auto& body) {
      for (std::uint32_t t = body.tiles_begin; t < body.tiles_end; ++t)
        if (reports_[t].failed != TileReport::fine)
          throw NumericalError(describe_failed(body, reports_[t].failed, step));
    });
  }

  double max_speed() const {
    double s = 0;
    for (const auto& r : reports_) s = std::max(s, r.max_speed);
    return s;
  }

  // ---- what others may look at

  const Frame<T, D>& frame() const { return frame_; }
  const Loads& loads() const { return loads_; }
  const grid::Domain<D>& domain() const { return domain_; }
  const grid::Blocks<T, D>& blocks() const { return blocks_; }
  const GridLedger<D>& ledger() const { return ledger_; }
  const Execution& executor() const { return executor_; }
  const Tiling<D>& tiling() const { return tiling_; }
  const Sleeper<Sleep, T, D>& sleeper() const { return sleeper_; }

  template <class M>
  static constexpr bool holds = (std::is_same_v<M, Materials> || ...);
  /// The body whose material has this type and these numbers. Throws InputError if there is none.
  template <class M>
  auto& body_of(const M& material, const char* caller) {
    return find_body<BodyOf<M>>(bodies_, material, caller);
  }
  template <class M>
  const auto& body_of(const M& material, const char* caller) const {
    return find_body<const BodyOf<M>>(bodies_, material, caller);
  }
  template <int I>
  auto& body() {
    return std::get<std::size_t(I)>(bodies_);
  }
  template <int I>
  const auto& body() const {
    return std::get<std::size_t(I)>(bodies_);
  }
  template <class F>
  void for_each_body(F&& f) {
    visit(bodies_, f, std::index_sequence_for<Materials...>{});
  }
  template <class F>
  void for_each_body(F&& f) const {
    visit(bodies_, f, std::index_sequence_for<Materials...>{});
  }
  std::size_t size() const {
    std::size_t n = 0;
    for_each_body([&](const auto& body) { n += body.particles.size(); });
    return n;
  }

 protected:
  template <class F>
  void for_each_tile(const F& f) {
    for_each_body([&](auto& body) {
      executor_.for_each(body.tiles_end - body.tiles_begin,
                         [&](std::size_t i) { f(body, body.tiles_begin + std::uint32_t(i)); });
    });
  }

  bool awake(std::uint32_t tile) const {
    if constexpr (Sleep::sleeps) return !sleeper_.asleep(tile);
    return true;
  }
  /// Whether nobody who is awake can reach a block.
  bool idle(std::size_t block) const {
    if constexpr (Sleep::sleeps) return sleeper_.idle(std::uint32_t(block));
    return false;
  }

  template <class F>
  void for_each_awake_tile(const F& f) {
    for_each_tile([&](auto& body, std::uint32_t t) {
      if (awake(t)) f(body, t);
    });
  }

  template <class F>
  void for_each_block(const F& f) {
    executor_.for_each(blocks_.index.size(), [&](std::size_t b) {
      if (!idle(b)) f(std::uint32_t(b));
    });
  }

  template <class F>
  void for_each_plane_block(const F& f) {
    executor_.for_each(orbits_.blocks(), [&](std::size_t i) {
      if (!idle(orbits_.block(i))) f(i);
    });
  }

  /// Holds a node field to the planes, which move with frame_velocity (differences of velocities: with none). \return
  /// what impulses that takes
  GridLedger<D> hold(AlignedVector<T>& field, const Vec<double, D>& frame_velocity) {
    block_ledgers_.assign(orbits_.blocks(), {});
    for_each_plane_block(
        [&](std::size_t i) { block_ledgers_[i] = hold_field(i, orbits_, field, blocks_, frame_velocity); });
    GridLedger<D> given;
    for (const auto& l : block_ledgers_) given += l;
    return given;
  }

  /// The sum of f(block) over blocks that are awake, in their order.
  template <class F>
  double sum_over_blocks(const F& f) {
    block_sums_.assign(blocks_.index.size(), 0);
    for_each_block([&](std::uint32_t b) { block_sums_[b] = f(b); });
    return std::accumulate(block_sums_.begin(), block_sums_.end(), 0.0);
  }

  /// The grid goes with a plane that moves.
  Vec<double, D> grid_velocity(double time) const {
    Vec<double, D> v{};
    if (const auto& mover = domain_.mover()) {
      v[mover->side.axis] = mover->velocity(time);
      if (!std::isfinite(v[mover->side.axis]))
        throw NumericalError(text("mote: the piston's velocity is ", v[mover->side.axis], " m/s at time ", time, " s"));
    }
    return v;
  }
  /// Moves the grid to where its plane is after the step; the particles' places on it change.
  void follow() {
    const int axis = domain_.mover()->side.axis;
    frame_.origin[axis] += frame_velocity_[axis] * dt_;
    domain_.move(axis, frame_.origin[axis]);
    const auto frame_velocity = cast<T>(grid_velocity(time_ + dt_));
    for_each_tile([&](auto& body, std::uint32_t t) {
      const TileReport r = survey_tile<Shape>(body, tiling_.tiles[t], frame_, frame_velocity);
      reports_[t].max_speed = r.max_speed, reports_[t].failed = r.failed;
    });
  }

  template <class B>
  void look(const B& body, std::uint32_t t) {
    if constexpr (Sleep::sleeps) sleeper_.template look<Shape>(body, t, tiling_.tiles[t], frame_);
  }

 private:
  /// Room for the fields of all nodes, tiles and blocks, whose numbers have changed.
  void allocate() {
    blocks_.allocate(remaps_, sharpens<Transfer> == Sharpens::incoming, sharpens<Transfer> != Sharpens::nothing);
    if constexpr (conducts) conduction_.allocate(blocks_, domain_, Shape::support);
    std::fill(blocks_.mass.begin(), blocks_.mass.end(), T(0));
    reports_.resize(tiling_.tiles.size());
    const std::size_t numbers = tiling_.place_buffers(Shape::support) * MomentumAndForce<T, D>::width;
    reserve_amply(accumulators_, numbers);
    accumulators_.resize(numbers);
    reserve_amply(block_ledgers_, blocks_.index.size() + orbits_.blocks());
    if constexpr (sharpens<Transfer> != Sharpens::nothing) reserve_amply(block_sums_, blocks_.index.size());
  }

  /// As std::apply would, which asks of each f whether it may throw and so compiles it twice.
  template <class All, class F, std::size_t... i>
  static void visit(All& bodies, F& f, std::index_sequence<i...>) {
    (f(std::get<i>(bodies)), ...);
  }
};

}  // namespace mote::passes
