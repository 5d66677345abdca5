/// \file
/// The phases of a step: each a sweep over tiles or blocks. An update policy (update/) puts them in order.
#pragma once

#include <tuple>

#include <mote/passes/gather.hpp>
#include <mote/passes/sharpen.hpp>
#include <mote/passes/state.hpp>

namespace mote::passes {

/// The phases, and the state that they work on.
template <class Shape, class Transfer, class T, int D, class Execution, class Sleep, class Loads, class Materials>
class Phases : public State<Shape, Transfer, T, D, Execution, Sleep, Loads, Materials> {
  using Base = State<Shape, Transfer, T, D, Execution, Sleep, Loads, Materials>;
  using Base::accumulators_, Base::blocks_, Base::block_ledgers_, Base::conduction_, Base::conducts, Base::disorder_,
      Base::domain_, Base::dt_, Base::executor_, Base::frame_, Base::frame_velocity_, Base::ledger_, Base::loads_,
      Base::loads_surfaces, Base::orbits_, Base::reports_, Base::sleeper_, Base::surface_, Base::tiling_, Base::time_,
      Base::transfer_;
  using Base::awake, Base::idle, Base::follow, Base::for_each_awake_tile, Base::for_each_block,
      Base::for_each_plane_block, Base::for_each_tile, Base::grid_velocity, Base::hold;

 public:
  using Base::Base, Base::for_each_body;

  /// A step of length dt starts at `time`.
  void begin(double time, double dt) {
    time_ = time;
    dt_ = dt;
    frame_velocity_ = grid_velocity(time + 0.5 * dt);
    if constexpr (conducts)
      if (const double due = conduction_.due(dt); due > 0) conduct(due);
  }
  /// It is done.
  void end() {
    for (std::uint32_t t = 0; t < reports_.size(); ++t)
      if (awake(t)) disorder_ += double(reports_[t].windows) - double(reports_[t].fresh);
    if constexpr (Sleep::sleeps) sleeper_.pass(dt_);
    if (domain_.mover()) follow();
  }

  /// Mass and momentum of all particles, per tile.
  void scatter_momentum() {
    for_each_awake_tile([&](auto& body, std::uint32_t t) {
      scatter_momentum_of_tile<Shape, Transfer>(body, tiling_.tiles[t], frame_, accumulators_.data());
    });
  }

  /// Velocities of all nodes before forces and loads, within the boundaries.
  void find_velocity() {
    executor_.for_each(blocks_.index.size(), [&](std::size_t b) {
      if (idle(b)) return blocks_.clear_mass(b);
      divide_block(std::uint32_t(b), tiling_, accumulators_.data(), Shape::support, blocks_);
    });
    hold(blocks_.velocity, frame_velocity_);
    if constexpr (sharpens<Transfer> == Sharpens::grid) sharpen(blocks_.velocity, blocks_.velocity);
  }

  /// Stress of the particles.
  void strain() { gather_all<Task::strain>(); }

  /// Mass, momentum and internal force of all particles, per tile.
  void scatter_momentum_and_force() {
    for_each_awake_tile([&](auto& body, std::uint32_t t) {
      scatter_tile<Shape, Transfer>(body, tiling_.tiles[t], frame_, accumulators_.data());
    });
  }

  /// Velocities of all nodes after forces, loads and boundaries, sharpened as the transfer wants it.
  void update_grid() {
    block_ledgers_.assign(blocks_.index.size() + orbits_.blocks(), {});
    executor_.for_each(blocks_.index.size(), [&](std::size_t b) {
      if (idle(b)) return blocks_.clear_mass(b);
      block_ledgers_[b] = accelerate_block(std::uint32_t(b), tiling_, accumulators_.data(), Shape::support, blocks_,
                                           frame_, loads_, time_, dt_);
    });
    if constexpr (loads_surfaces) load_surfaces();
    for_each_plane_block([&](std::size_t i) {
      block_ledgers_[blocks_.index.size() + i] = hold_to_planes(i, orbits_, blocks_, transfer_.kept(), frame_velocity_);
    });
    for (const auto& l : block_ledgers_) ledger_ += l;
    if constexpr (sharpens<Transfer> == Sharpens::grid) ledger_ += sharpen(blocks_.velocity, blocks_.velocity);
    if constexpr (sharpens<Transfer> == Sharpens::change) ledger_ += sharpen_change();
    if constexpr (sharpens<Transfer> == Sharpens::incoming) {
      for_each_block([&](std::uint32_t b) { copy_block<D>(b, blocks_.velocity, blocks_.sharp); });
      ledger_ += sharpen(blocks_.previous, blocks_.sharp);
    }
  }

  /// Velocity, position and stress of the particles from one grid velocity.
  void gather_velocity_and_deform() { gather_all<Task::velocity_and_deform>(); }

  /// Velocity and position of the particles.
  void gather_velocity_and_move() { gather_all<Task::velocity_and_move>(); }

  /// Velocity of the particles, and its momentum back to the tiles.
  void gather_velocity_and_remap() { gather_all<Task::velocity_and_remap>(); }

  /// The velocity field of the remapped momentum, within the boundaries.
  void constrain_remapped() {
    for_each_block([&](std::uint32_t b) { remap_block(b, tiling_, accumulators_.data(), Shape::support, blocks_); });
    hold(blocks_.remapped, frame_velocity_);
    if constexpr (sharpens<Transfer> == Sharpens::grid) sharpen(blocks_.remapped, blocks_.remapped);
  }

  /// Position from the grid velocity, stress from the remapped one.
  void deform() { gather_all<Task::deform>(); }

 private:
  /// Forces on the particles' surfaces.
  void load_surfaces() {
    std::size_t number = 0;
    for_each_body([&](const auto& body) {
      surface_.template add<Shape>(number++, body, loads_, domain_, blocks_, frame_, time_);
    });
    ledger_ += surface_.push(blocks_, frame_, loads_, time_, dt_);
  }

  /// Temperatures of the particles, by conduction for the time `due`.
  void conduct(double due) {
    const auto all = [&](const auto& f) {
      this->for_each_tile([&](auto& body, std::uint32_t t) { f(body, tiling_.tiles[t]); });
    };
    conduction_.template conduct<Shape>(due, all, executor_, tiling_, blocks_, frame_, accumulators_.data());
  }

  /// Adds to a node field what its like loses on the way to the particles and back. \return impulses of the planes
  GridLedger<D> sharpen(const AlignedVector<T>& v, AlignedVector<T>& sharp) {
    if (transfer_.order == 1) return {};
    for_each_block([&](std::uint32_t b) { copy_block<D>(b, v, blocks_.residual); });
    GridLedger<D> given = sharpen_by_residual(sharp);
    given.work = given.piston_work;  // v is no change by forces
    return given;
  }
  /// The same for the change of velocity in this step, with the work that its forces do on the corrections.
  GridLedger<D> sharpen_change() {
    if (transfer_.order == 1) return {};
    for_each_block(
        [&](std::uint32_t b) { subtract_blocks<D>(b, blocks_.velocity, blocks_.previous, blocks_.residual); });
    return sharpen_by_residual(blocks_.velocity);
  }
  GridLedger<D> sharpen_by_residual(AlignedVector<T>& sharp) {
    // this->: g++ 12 falls over what a generic lambda calls in a base without it
    const auto tiles = [&](const auto& f) { this->for_each_awake_tile(f); };
    const auto blocks = [&](const auto& f) { return this->sum_over_blocks(f); };
    const auto planes = [&](AlignedVector<T>& residual) { return hold(residual, {}); };
    GridLedger<D> given = passes::sharpen<Shape>(tiles, blocks, planes, transfer_.order, tail(transfer_), sharp,
                                                 tiling_, blocks_, frame_, accumulators_.data());
    for (const auto& impulse : given.impulse) given.piston_work += dot(impulse, frame_velocity_);
    given.work += given.piston_work;
    return given;
  }

  template <Task task>
  void gather_all() {
    for_each_awake_tile([&](auto& body, std::uint32_t t) {
      TileReport r = gather_tile<task, Shape>(body, transfer_, tiling_.tiles[t], tiling_.links, blocks_, frame_, dt_,
                                              accumulators_.data());
      if constexpr (moves(task)) {
        r.fresh = reports_[t].fresh > 0 ? reports_[t].fresh : r.windows;
        reports_[t] = r;
        this->look(body, t);
      }
    });
  }
};

}  // namespace mote::passes
