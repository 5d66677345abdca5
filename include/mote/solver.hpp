/// \file
/// Solver: parts in any order, assembled into an explicit material point method.
#pragma once

#include <algorithm>
#include <limits>

#include <mote/assembly.hpp>
#include <mote/execution/concept.hpp>
#include <mote/execution/serial.hpp>
#include <mote/fill.hpp>
#include <mote/material.hpp>
#include <mote/passes/phases.hpp>
#include <mote/passes/sort.hpp>
#include <mote/shape/concept.hpp>
#include <mote/sleep/concept.hpp>
#include <mote/sleep/never.hpp>
#include <mote/timestep/concept.hpp>
#include <mote/transfer/concept.hpp>
#include <mote/update/concept.hpp>
#include <mote/update/usl.hpp>

namespace mote {

/// How long a run lasts.
struct Run {
  double until;  ///< s
  std::size_t max_steps = std::numeric_limits<std::size_t>::max();
};

/// An explicit material point method, assembled from parts in any order (roles in core/role.hpp):
///
///   needed     grid, shape function, transfer, time step, one or more materials
///   optional   update order (update::Usl), execution (execution::Serial), sleep (sleep::Never), boundaries, loads
///
/// A boundary may be a std::optional, and none where it is empty: full or quarter domain, say, in one type of solver.
///
/// What a step guarantees: the answer does not depend on the executor or its number of threads, to the last bit.
/// Columns keep their place unless a sort was due; sorts() counts those. A step that throws NumericalError (also from a
/// worker thread) leaves the columns as the failed step left them, to be looked at or written; further steps throw
/// UsageError until the columns have been mended and refresh() accepts them. One solver must not be used from two
/// threads at once; two solvers may run side by side.
template <class Grid, class Shape, class Transfer, class Update, class Timestep, class Execution, class Sleep,
          class Boundaries, class Loads, class Materials>
class Solver {
  static_assert(!std::is_same_v<Grid, detail::MissingGrid>,
                "mote: no grid given; add e.g. grid::Cartesian<3>{.spacing = h}");
  static_assert(!std::is_same_v<Shape, detail::Missing>,
                "mote: no shape function given; add e.g. shape::QuadraticBSpline{}");
  static_assert(!std::is_same_v<Transfer, detail::Missing>, "mote: no transfer given; add e.g. transfer::Apic{}");
  static_assert(!std::is_same_v<Timestep, detail::Missing>, "mote: no time step given; add e.g. timestep::Cfl{}");
  static_assert(std::tuple_size_v<Materials> > 0,
                "mote: no material given; add e.g. a Material{eos::..., strength::...}");
  static_assert(mote::Shape<Shape> || std::is_same_v<Shape, detail::Missing>,
                "mote: the shape function lacks a member; shape/concept.hpp lists them");
  static_assert(mote::Transfer<Transfer> || std::is_same_v<Transfer, detail::Missing>,
                "mote: the transfer lacks a member; transfer/concept.hpp lists them");
  static_assert(mote::Update<Update>, "mote: the update order lacks a member; update/concept.hpp lists them");
  static_assert(mote::Timestep<Timestep> || std::is_same_v<Timestep, detail::Missing>,
                "mote: the time step policy lacks a member; timestep/concept.hpp lists them");
  static_assert(mote::Execution<Execution>, "mote: the executor lacks a member; execution/concept.hpp lists them");
  static_assert(mote::Sleep<Sleep>, "mote: the sleep policy lacks a member; sleep/concept.hpp lists them");
  static_assert(!Sleep::sleeps || std::tuple_size_v<Loads> == 0,
                "mote: material at rest does not stay there under a load; take sleep::Never with loads");
  static_assert(!(Sleep::sleeps && detail::moves<Boundaries>),
                "mote: the grid goes with a piston, but not with what sleeps; take sleep::Never with boundary::Piston");
  static_assert(detail::are_boundaries<Boundaries>, "mote: a boundary lacks a member; boundary/concept.hpp lists them");
  static_assert(detail::are_loads<Loads, Grid::dimension>,
                "mote: a load does not fit the grid's dimension, or has no "
                "acceleration(position, time), or side, where(position) and traction(position, time)");

 public:
  static constexpr int dimension = Grid::dimension;
  static constexpr int bodies = std::tuple_size_v<Materials>;  ///< one of each material
  using number = typename Grid::number;
  using shape = Shape;
  using transfer = Transfer;

 private:
  static constexpr int D = dimension;
  using T = number;
  using Phases = passes::Phases<Shape, Transfer, T, D, Execution, Sleep, Loads, Materials>;

  Update update_;
  Timestep timestep_;
  Phases phases_;
  passes::Sorter<D> sorter_;
  double time_ = 0, last_dt_ = 0;
  std::size_t steps_ = 0, sorts_ = 0, next_id_ = 0;
  double first_dt_ = 0, seconds_ = 0;
  bool sorted_ = false, failed_ = false;

 public:
  /// Throws InputError if a part's numbers are out of range, or the boundaries do not fit the grid or each other.
  template <class... Parts>
  explicit Solver(const Parts&... parts)
      : update_((detail::validate(parts), ..., detail::pick<role::Update, Update>(parts...))),
        timestep_(detail::pick<role::Timestep, Timestep>(parts...)),
        phases_(detail::pick<role::Grid, Grid>(parts...), detail::pick<role::Transfer, Transfer>(parts...),
                detail::pick<role::Execution, Execution>(parts...), detail::pick<role::Sleep, Sleep>(parts...),
                detail::pick_all<role::Boundary>(parts...), detail::pick_all<role::Load>(parts...),
                detail::pick_all<role::Material>(parts...), Update::remaps) {
    static_assert((detail::has_solver_role<Parts> && ...),
                  "mote: a solver takes parts with a role (grid, shape, transfer, update, time step, execution, sleep, "
                  "boundary, load, material); equations of state and strengths go into a Material");
    static_assert(count_of<role::Grid, Parts...> <= 1, "mote: a solver takes one grid");
    static_assert(count_of<role::Shape, Parts...> <= 1, "mote: a solver takes one shape function");
    static_assert(count_of<role::Transfer, Parts...> <= 1, "mote: a solver takes one transfer");
    static_assert(count_of<role::Update, Parts...> <= 1, "mote: a solver takes one update order");
    static_assert(count_of<role::Timestep, Parts...> <= 1, "mote: a solver takes one time step policy");
    static_assert(count_of<role::Execution, Parts...> <= 1, "mote: a solver takes one executor");
    static_assert(count_of<role::Sleep, Parts...> <= 1, "mote: a solver takes one sleep policy");
  }
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Puts particles of a material where the region is; see Fill for the options. Throws InputError if the solver has no
  /// material of these numbers, the region is empty or wholly outside the domain, or the options are out of range. What
  /// a user's velocity or load throws passes; then nothing has been added. \return how many
  template <geometry::Region R, class M>
  std::size_t fill(const R& region, const M& material, const Fill<D>& how = {}) {
    static_assert(Phases::template holds<M>, "mote: fill() was given a material that the solver does not hold");
    auto& body = phases_.body_of(material, "fill()");
    const std::size_t first = body.particles.size();
    const std::size_t added = append_fill<T>(body, region, material, how, phases_.frame(), phases_.domain(), next_id_);
    if constexpr (passes::surface_fields<Loads, D>::size > 0) {
      try {
        passes::mark_surfaces(body, first, phases_.loads(),
                              geometry::Lattice<D>{spacing(), how.per_axis, phases_.frame().origin}, domain());
      } catch (...) {  // of the load's where(x)
        body.particles.resize(first);
        throw;
      }
    }
    next_id_ += added;
    sorted_ = false;
    return added;
  }

  /// One step of the length that the time step policy gives, and at most `limit` seconds. \return its length, s
  double step(double limit = std::numeric_limits<double>::infinity()) {
    require(limit > 0, "a step is limited to ", limit, " s; it must be > 0");
    const Settled afterwards{*this};
    const double dt = take_step(limit, false);
    settle();
    return dt;
  }

  /// Steps until `run.until`, and shows the solver to each observer: at the start, whenever one is due, and at the end.
  /// Steps land on the observers' times. All are called after each step; one that looks at particles only when it is
  /// due may say `static constexpr bool only_when_due = true;`, and what sleeps is not brought up to date for it in
  /// between. One that reads nodes() says `needs_nodes`: nobody sleeps in the step to its time and to `run.until`.
  /// Throws InputError if `run.until` does not lie ahead, besides what step() and the observers throw.
  template <class... Observers>
  void run(const Run& run, Observers&&... observers) {
    require(run.until > time_, "the run lasts until ", run.until, " s; it must lie after the present time, ", time_,
            " s");
    const Settled afterwards{*this};
    prepare();
    (observers.begin(*this, run), ...);
    for (std::size_t n = 0; time_ < run.until && n < run.max_steps; ++n) {
      double due = run.until;
      ((due = std::min(due, observers.due())), ...);
      advance_towards(due, ((detail::needs_nodes<Observers> && std::min(observers.due(), run.until) <= due) || ...));
      if (((!detail::only_when_due<Observers> || observers.due() <= time_) || ...)) settle();
      (observers.observe(*this), ...);
    }
    settle();
    (observers.end(*this), ...);
  }

  /// Sorts particles and surveys their speeds. Call it after writing columns from outside; step() does so by itself after
  /// fill(). Throws NumericalError if a particle lies where it cannot be, or in a state that it cannot have.
  void refresh() { sort(); }

  double time() const { return time_; }        ///< s
  double last_dt() const { return last_dt_; }  ///< s
  std::size_t steps() const { return steps_; }
  double seconds() const { return seconds_; }   ///< wall time spent in steps so far, s
  std::size_t sorts() const { return sorts_; }  ///< after one, particles have changed their places in the columns
  double spacing() const { return phases_.frame().spacing; }  ///< m
  std::size_t size() const { return phases_.size(); }         ///< particles of all bodies

  /// The columns of body i, in the order of the materials given.
  template <int I = 0>
  auto& particles() {
    return phases_.template body<I>().particles;
  }
  template <int I = 0>
  const auto& particles() const {
    return phases_.template body<I>().particles;
  }
  /// The columns of the body of a material. Throws InputError if the solver has no material of these numbers.
  template <class M>
  auto& particles(const M& material) {
    return phases_.body_of(material, "particles()").particles;
  }
  template <class M>
  const auto& particles(const M& material) const {
    return phases_.body_of(material, "particles()").particles;
  }
  template <int I = 0>
  const auto& material() const {
    return phases_.template body<I>().material;
  }
  /// Calls f(material, particles) for each body, in the order of the materials given.
  template <class F>
  void for_each_body(F&& f) const {
    phases_.for_each_body([&](const auto& body) { f(body.material, body.particles); });
  }

  const grid::Domain<D>& domain() const { return phases_.domain(); }
  const passes::Frame<T, D>& frame() const { return phases_.frame(); }
  /// Part of the particles that were awake in the last step.
  double active_fraction() const {
    if constexpr (Sleep::sleeps) return phases_.sleeper().active();
    return 1;
  }
  /// Calls f(velocity) for each tile that slept through the last step: what its nodes carry, which nodes() lacks.
  template <class F>
  void for_each_sleeping_tile(const F& f) const {
    if constexpr (Sleep::sleeps) phases_.sleeper().for_each_sleeping(f);
  }
  /// Node fields of the last step, of what was awake; no node has mass between a sort and the next step.
  const grid::Blocks<T, D>& nodes() const { return phases_.blocks(); }
  /// Sums over all steps so far of what only the grid knows.
  const passes::GridLedger<D>& ledger() const { return phases_.ledger(); }
  const Execution& executor() const { return phases_.executor(); }

  /// Bytes per particle of the columns of body i.
  template <int I = 0>
  static constexpr int bytes_per_particle =
      std::remove_reference_t<decltype(std::declval<Solver&>().template particles<I>())>::bytes_per_particle;

 private:
  /// Brings all positions up to date in the end, also where a step throws; what the executor throws then is lost to it.
  struct Settled {
    Solver& solver;
    ~Settled() {
      try {
        solver.settle();
      } catch (...) {
      }
    }
  };
  void settle() {
    if constexpr (Sleep::sleeps) {
      const detail::Timed timed{seconds_};
      phases_.settle();
    }
  }

  double take_step(double limit, bool everyone) {
    const detail::Timed timed{seconds_};
    prepare();
    if constexpr (Sleep::sleeps)
      if (phases_.rouse(everyone)) sort(), phases_.rouse(everyone);
    const double dt = next_dt(limit);
    failed_ = true;  // until the step is done
    phases_.begin(time_, dt);
    update_(phases_);
    phases_.end();
    time_ += dt;
    last_dt_ = dt;
    ++steps_;
    phases_.check(steps_);
    if (phases_.sort_due()) sorted_ = false;  // at the start of the next step: until then nodes() is this step's
    failed_ = false;
    return dt;
  }

  void prepare() {
    if (failed_)
      throw UsageError(
          "mote: the solver failed in an earlier step; mend its columns and call refresh(), or start anew");
    if (size() == 0) throw UsageError("mote: there are no particles; call fill() before the first step");
    if (!sorted_) sort();
  }

  void sort() {
    failed_ = true;
    phases_.sort(sorter_, steps_);
    failed_ = false;
    sorted_ = true;
    ++sorts_;
  }

  double next_dt(double limit) {
    const double dt = timestep_(spacing(), phases_.max_speed());
    if (first_dt_ == 0) first_dt_ = dt;
    if (!(dt > 1e-6 * first_dt_)) {
      settle();
      throw NumericalError(text("mote: the time step has collapsed to ", dt, " s in step ", steps_ + 1,
                                " (it began with ", first_dt_, " s): a particle is much too fast or too stiff; ",
                                passes::describe_fastest(phases_, steps_ + 1),
                                ". Try a smaller Courant number, update::Musl or transfer::Apic"));
    }
    return std::min(dt, limit);
  }

  /// One step that lands on `due` or leaves at least half a step to it.
  void advance_towards(double due, bool everyone) {
    const double left = due - time_;
    const double dt = timestep_(spacing(), phases_.max_speed());
    if (left <= dt * (1 + 1e-9)) {
      take_step(left, everyone);
      time_ = due;
    } else {
      take_step(left < 2 * dt ? 0.5 * left : dt, false);
    }
  }
};

template <class... Parts>
Solver(const Parts&...) -> Solver<
    detail::First<role::Grid, detail::MissingGrid, Parts...>, detail::First<role::Shape, detail::Missing, Parts...>,
    detail::First<role::Transfer, detail::Missing, Parts...>, detail::First<role::Update, update::Usl, Parts...>,
    detail::First<role::Timestep, detail::Missing, Parts...>,
    detail::First<role::Execution, execution::Serial, Parts...>, detail::First<role::Sleep, sleep::Never, Parts...>,
    detail::AllOf<role::Boundary, Parts...>, detail::AllOf<role::Load, Parts...>,
    detail::AllOf<role::Material, Parts...>>;

}  // namespace mote
