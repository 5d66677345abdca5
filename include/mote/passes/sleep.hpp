/// \file
/// Sleep: which tiles rest through a step, and how they move meanwhile.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <mote/passes/body.hpp>
#include <mote/passes/neighbours.hpp>
#include <mote/sleep/concept.hpp>

namespace mote::passes {

/// What is known of a tile's rest. Nodes and cells count from its block.
template <class T, int D>
struct Rest {
  Vec<T, D> velocity{};         ///< of its first particle, m/s
  double tolerance = 0;         ///< of velocities, m/s
  double pending = 0;           ///< time that its positions lag behind, s
  Vec<double, D> from{}, to{};  ///< range of its lowest nodes before they are rounded down
  std::array<bool, D> held{};   ///< velocity components that a plane within its reach makes odd
  bool quiet = false;           ///< no particle is disturbed
  bool asleep = false, woken = false;

  double shift(int axis, double spacing) const { return double(velocity[axis]) * pending / spacing; }
};

/// Nobody sleeps, and nothing is stored.
template <class Policy, class T, int D, bool = Policy::sleeps>
class Sleeper {
 public:
  explicit Sleeper(const Policy&) {}
};

/// Which tiles sleep.
///
/// A tile is quiet if no particle is disturbed beside the velocity of its first, and if that velocity has no component
/// that a plane within its reach would turn. A quiet tile sleeps while all tiles that may share a node with it until
/// the next sort are quiet and have its velocity, to the tolerance. This is enough: every tile that shares a node with
/// a disturbed tile is awake, so the nodes that disturbed particles touch have their whole mass and force; a node that
/// only quiet tiles share carries their velocity and no force, whatever part of its mass sleeps. A wave that enters a
/// tile disturbs it before it leaves it on the other side, and wakes the tiles there before the next step.
///
/// A sleeping tile has an empty range of lowest nodes: it reaches no node, and what it last brought is not summed. Its
/// positions follow when somebody looks (settle), its report stays. All decisions are taken in the order of tiles.
template <class Policy, class T, int D>
class Sleeper<Policy, T, D, true> {
  Policy policy_;
  std::vector<Rest<T, D>> rests_;
  Neighbours<D> neighbours_;
  std::vector<char> idle_;  // per block: no tile that is awake is linked to it
  double active_ = 1;
  bool unsettled_ = false;

 public:
  explicit Sleeper(const Policy& policy) : policy_(policy) {}

  bool asleep(std::uint32_t tile) const { return rests_[tile].asleep; }
  bool idle(std::uint32_t block) const { return idle_[block]; }
  bool unsettled() const { return unsettled_; }
  /// Part of the particles that were awake in the last step.
  double active() const { return active_; }

  /// Calls f(velocity) for each tile that slept through the last step.
  template <class F>
  void for_each_sleeping(const F& f) const {
    for (const auto& rest : rests_)
      if (rest.asleep) f(rest.velocity);
  }

  void clear() { rests_.clear(); }

  /// Everybody awake, and neighbours anew: after a sort and its links.
  void reset(const Tiling<D>& tiling, const grid::Domain<D>& domain, int support) {
    reserve_amply(rests_, tiling.tiles.size());
    rests_.assign(tiling.tiles.size(), {});
    reserve_amply(idle_, tiling.block_links_begin.size());
    idle_.assign(tiling.block_links_begin.size(), false);
    if (!policy_.enabled) return;
    neighbours_.find(tiling);
    for (std::size_t t = 0; t < rests_.size(); ++t)
      for (int a = 0; a < D; ++a)
        for (int end = 0; end < 2; ++end)
          if (const auto& plane = domain.plane(a, end); plane && reaches(tiling.tiles[t], a, *plane, support))
            for (std::size_t c = 0; c < std::size_t(D); ++c) rests_[t].held[c] |= plane->odd[c];
  }

  /// Whether an awake tile is quiet; stops at the first pack that is not.
  template <class Shape, class B>
  [[gnu::flatten, gnu::noinline]] void look(const B& body, std::uint32_t number, const Tile<D>& tile,
                                            const Frame<T, D>& frame) {
    if (!policy_.enabled) return;
    Rest<T, D>& rest = rests_[number];
    rest.quiet = false;
    rest.velocity = body.particles.template get<field::Velocity>(tile.first);
    const TileFrame<T, D> in_tile = frame.of_block(tile.block);
    Extent extent;
    Values<Pack<T>, D, union_of<fields<field::Position>, observed<B>>> p{};  // a tile is never empty
    for (std::uint32_t i = 0; i < tile.count; i += lanes) {
      body.particles.load(tile.first + i, std::min(lanes, int(tile.count - i)), p);
      const auto found = policy_.disturbance(body.material, p, rest.velocity, frame.spacing);
      if (!all_of(found <= Pack<T>(T(policy_.tolerance)))) return;
      extent.include(in_tile.in_cells(get<field::Position>(p)));
    }
    rest.tolerance = policy_.tolerance * std::sqrt(double(lane(body.material.sound_speed2(p), 0)));
    for (int c = 0; c < D; ++c)
      if (rest.held[std::size_t(c)] && std::abs(double(rest.velocity[c])) > rest.tolerance) return;
    extent.put(rest, Shape::first);
    rest.quiet = true;
  }

  /// Who sleeps through the next step; nobody, if `everyone` is to wake. \return whether somebody wakes
  bool decide(Tiling<D>& tiling, bool everyone) {
    if (!policy_.enabled) return false;
    bool somebody = false;
    std::size_t awake = 0, all = 0;
    std::fill(idle_.begin(), idle_.end(), true);
    for (std::uint32_t t = 0; t < tiling.tiles.size(); ++t) {
      const bool sleeps = !everyone && may_sleep(t);
      Tile<D>& tile = tiling.tiles[t];
      Rest<T, D>& rest = rests_[t];
      somebody |= rest.woken = rest.asleep && !sleeps;
      rest.asleep = sleeps;
      all += tile.count;
      if (sleeps) {
        tile.lo.fill(127), tile.hi.fill(-128);  // reaches no node
      } else {
        awake += tile.count;
        for (std::uint32_t k = tile.links_begin; k < tile.links_end; ++k) idle_[tiling.links[k].block] = false;
      }
    }
    active_ = double(awake) / double(all);
    return somebody;
  }

  /// Brings a tile that wakes to where it is.
  template <class Shape, class B>
  void wake(B& body, std::uint32_t number, Tile<D>& tile, const Frame<T, D>& frame) {
    Rest<T, D>& rest = rests_[number];
    if (!rest.woken) return;
    move(body, rest, tile);
    rest.woken = false;
    rest.pending = 0;
    Extent extent;
    const TileFrame<T, D> in_tile = frame.of_block(tile.block);
    for_each_pack(tile, [&](std::size_t first, int n) {
      Values<Pack<T>, D, fields<field::Position>> p;
      body.particles.load(first, n, p);
      extent.include(in_tile.in_cells(get<field::Position>(p)));
    });
    extent.put(rest, Shape::first);
    for (std::size_t a = 0; a < std::size_t(D); ++a) {
      tile.lo[a] = std::int8_t(std::clamp(std::floor(rest.from[int(a)]), -128.0, 127.0));
      tile.hi[a] = std::int8_t(std::clamp(std::floor(rest.to[int(a)]), -128.0, 127.0));
    }
  }

  /// A step of length dt has passed.
  void pass(double dt) {
    for (auto& rest : rests_)
      if (rest.asleep) rest.pending += dt, unsettled_ = true;
  }

  /// Brings a sleeping tile to where it is; settled() says that all were.
  template <class B>
  void settle(B& body, std::uint32_t number, const Tile<D>& tile, const Frame<T, D>& frame) {
    Rest<T, D>& rest = rests_[number];
    if (!rest.asleep || rest.pending == 0) return;
    move(body, rest, tile);
    for (int a = 0; a < D; ++a)
      rest.from[a] += rest.shift(a, frame.spacing), rest.to[a] += rest.shift(a, frame.spacing);
    rest.pending = 0;
  }
  void settled() { unsettled_ = false; }

  /// Whether a sleeping tile has drifted beyond what it is linked to.
  bool strayed(const std::vector<Tile<D>>& tiles, double spacing) const {
    for (std::size_t t = 0; t < tiles.size(); ++t)
      for (int a = 0; rests_[t].asleep && a < D; ++a) {
        const double shift = rests_[t].shift(a, spacing);
        if (std::floor(rests_[t].from[a] + shift) < tiles[t].least[std::size_t(a)] ||
            std::floor(rests_[t].to[a] + shift) > tiles[t].most[std::size_t(a)])
          return true;
      }
    return false;
  }

 private:
  /// The fields that a disturbance may depend on.
  template <class B>
  using observed =
      union_of<fields<field::Velocity>, particle_fields_of<typename B::Material>,
               std::conditional_t<contains<typename B::list, field::Affine>, fields<field::Affine>, fields<>>>;

  /// Extremes of positions in cells.
  struct Extent {
    Vec<Pack<T>, D> least = Vec<Pack<T>, D>::filled(Pack<T>(T(1e30))),
                    most = Vec<Pack<T>, D>::filled(Pack<T>(T(-1e30)));

    void include(const Vec<Pack<T>, D>& xi) {
      for (int a = 0; a < D; ++a) least[a] = min(least[a], xi[a]), most[a] = max(most[a], xi[a]);
    }
    void put(Rest<T, D>& rest, double first) const {
      for (int a = 0; a < D; ++a) {
        rest.from[a] = double(T(-largest(Pack<T>(-least[a])) - T(first)));
        rest.to[a] = double(T(largest(most[a]) - T(first)));
      }
    }
  };

  /// Whether a tile may reach nodes that a plane changes.
  static bool reaches(const Tile<D>& tile, int axis, const grid::Plane<D>& plane, int support) {
    const std::int32_t first = tile.block[axis] * grid::block_edge + lowest,
                       last = first - lowest + highest + support - 1;
    return first <= plane.node + ghosts(support) && last >= plane.node - ghosts(support);
  }

  bool may_sleep(std::uint32_t t) const {
    const Rest<T, D>& mine = rests_[t];
    if (!mine.quiet) return false;
    for (const std::uint32_t n : neighbours_.of(t)) {
      const Rest<T, D>& other = rests_[n];
      if (!other.quiet) return false;
      for (int c = 0; c < D; ++c)
        if (std::abs(double(mine.velocity[c] - other.velocity[c])) > std::min(mine.tolerance, other.tolerance))
          return false;
    }
    return true;
  }

  /// x += v times what is pending, each particle with its own velocity.
  template <class B>
  static void move(B& body, const Rest<T, D>& rest, const Tile<D>& tile) {
    for (int a = 0; a < D; ++a) {
      T* x = body.particles.template column<field::Position>(a).data() + tile.first;
      const T* v = body.particles.template column<field::Velocity>(a).data() + tile.first;
      for (std::uint32_t i = 0; i < tile.count; ++i) x[i] += T(double(v[i]) * rest.pending);
    }
  }
};

}  // namespace mote::passes
