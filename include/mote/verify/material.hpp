/// \file
/// Whether a material, above all its strength, is one.
#pragma once

#include <mote/verify/states.hpp>
#include <mote/verify/work.hpp>

namespace mote::verify {

namespace detail {

template <class S, class V>
concept StatesYield = requires(const S& s, const V& v) {
  { s.yield_stress(v) } -> std::convertible_to<double>;
};
template <class S>
concept HasYield = requires(const S& s) {
  { s.yield } -> std::convertible_to<double>;
};

/// The checks of one material. Bounds are round-off (Subject::noise), or what differences and steps leave, measured by
/// doing them twice.
template <class M>
class MaterialChecks {
  using State = typename Subject<M>::State;
  Subject<M> subject_;
  static constexpr int states = 200;

  static std::string in_state(int i) { return text("state ", i); }
  const M& material() const { return subject_.material; }

 public:
  explicit MaterialChecks(const M& m) : subject_(m) {}

  /// A rigid turn turns the stress and changes no scalar; and a turn before an increment, turned along, is one after
  /// it: F and Q F give stresses that differ by Q. Of any symmetry, since only the motion is turned.
  Row objectivity() const {
    Worst worst;
    Random random(1);
    for (int i = 0; i < states; ++i) {
      const State state = subject_.somewhere(random, i), still = subject_.settled(state);
      const Matrix turn = turning(random.direction(), random.between(0.1, 2.1)), q = Matrix::identity() + turn;
      subject_.see_turned(worst, still, q, subject_.moved(state, turn), "a rigid turn of " + in_state(i));
      // settled before and after, so that a viscous pressure enters both in the same way
      const Matrix a = subject_.increment(random, state, 0.1);
      const State turned_last = subject_.moved(subject_.moved(still, a), turn);
      const State turned_first = subject_.settled(subject_.moved(subject_.moved(state, turn), q * a * transpose(q)));
      subject_.see_turned(worst, turned_last, Matrix::identity(), turned_first,
                          "turn and increment exchanged in " + in_state(i));
    }
    return worst.row("objectivity");
  }

  /// An increment of nothing: a state that moves was left outside its own yield surface, or decays per call.
  Row rest() const {
    Worst worst;
    Random random(2);
    for (int i = 0; i < states; ++i) {
      const State state = subject_.somewhere(random, i);
      const State flowed = subject_.moved(state, subject_.increment(random, state, 0.1));
      const State once = subject_.settled(flowed), expected = M::viscous ? once : flowed;
      subject_.see_turned(worst, expected, Matrix::identity(), subject_.settled(once), in_state(i));
    }
    return worst.row("an increment of nothing changes nothing");
  }

  /// sqrt(3/2) |s - alpha| <= the yield stress, where the strength tells it: by yield_stress(values), or by `yield`
  /// and, with field::PlasticStrain, `hardening`.
  Row yield() const {
    const char* name = "yield surface is respected";
    using S = decltype(material().strength);
    if constexpr (!StatesYield<std::remove_cvref_t<S>, State> && !HasYield<std::remove_cvref_t<S>>) {
      return only_reported(name, 0, "not checked: the strength has neither yield_stress(values) nor a yield");
    } else {
      Worst worst;
      Random random(3);
      for (int i = 0; i < states; ++i) {
        State state = subject_.somewhere(random, i);
        state = subject_.moved(state, subject_.increment(random, state, 0.1));
        Tensor s = deviator(subject_.stress(state));
        if constexpr (carries<State, field::BackStress>) s = s - get<field::BackStress>(state);
        const double stress = std::sqrt(1.5) * magnitude(s), limit = yield_stress(state);
        worst.see(std::max(stress - limit, 0.0), subject_.noise(s) + 64 * eps * limit,
                  [&] { return text("Pa above it, ", in_state(i), ": ", stress, " beyond ", limit); });
      }
      return worst.row(name);
    }
  }

  Row dissipation() const {
    const char* name = "plastic work does not fall";
    if constexpr (!M::plastic) {
      return only_reported(name, 0, "not checked: the strength returns no work");
    } else {
      Worst worst;
      Random random(4);
      for (int i = 0; i < states; ++i) {
        const State state = subject_.somewhere(random, i);
        const Matrix a = subject_.increment(random, state, 0.1);
        const State after = subject_.moved(state, a);
        // stress times the strain that cancels, and the sum itself
        const double noise = 256 * eps * (magnitude(subject_.stress(after)) / material().rho0() + subject_.flow(state));
        worst.see(std::max(subject_.flow(state) - subject_.flow(after), 0.0), noise,
                  [&] { return text("J/kg, ", in_state(i), " (", subject_.flow(state), " J/kg)"); });
      }
      return worst.row(name);
    }
  }

  /// Along rays of increments, halved towards the largest change.
  Row smoothness() const {
    Worst worst;
    Random random(5);
    for (int i = 0; i < 40; ++i) {
      const State state = subject_.somewhere(random, i);
      const Matrix a = subject_.increment(random, state, 0.1);
      const auto stress = [&](double t) { return subject_.stress(subject_.moved(state, t * a)); };
      const auto distance = [](const Tensor& u, const Tensor& v) { return magnitude(u - v); };
      for (int part = 0; part < 16; ++part) {
        const Jump jump = find_jump(stress, part / 16.0, (part + 1) / 16.0, distance);
        worst.see(jump.size, jump.allowed(subject_.noise(stress(1))),
                  [&] { return text("Pa, ", in_state(i), " at ", jump.at, " of an increment of ", magnitude(a)); });
      }
    }
    return worst.row("stress is continuous in the increment");
  }

  /// rho0/x c^2 along n of the wave that moves along k, Pa, by differences of the traction: that of loading or that of
  /// unloading, whichever is stiffer.
  ///
  /// At fixed dissipated work, as energy/ has the sound speed. Heat that presses while metal flows in compression adds
  /// up to (gamma |s|)^2/(8 G), two millionths of aluminium's stiffness.
  Slope stiffness(const State& state, const Vec<double, 3>& k, const Vec<double, 3>& n) const {
    const Matrix pull = outer(k, n);
    const auto traction = [&](double e) {
      const Tensor s = subject_.stress(subject_.without_heat(subject_.moved(state, e * pull), state));
      double sum = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += k[i] * s(i, j) * n[j];
      return sum;
    };
    const double noise = subject_.noise(subject_.stress(state));
    const Slope there = slope_to(traction, 0, 1e-6, noise), back = slope_to(traction, 0, -1e-6, noise);
    return there.value > back.value ? there : back;
  }

  /// At rest the sound speed is that of longitudinal waves: equality.
  Row sound_at_rest() const {
    Worst worst;
    Random random(6);
    const State rest = subject_.rest();
    const double said = material().sound_speed2(rest);
    for (int i = 0; i < 20; ++i) {
      const auto n = random.direction();
      const Slope by = stiffness(rest, n, n);
      worst.see(std::abs(said - by.value / material().rho0()), by.error / material().rho0(), [&] {
        return text("m^2/s^2, at rest: ", said, ", differences of the stress ", by.value / material().rho0());
      });
    }
    return worst.row("sound speed at rest is that of the stress");
  }

  /// The time step trusts sound_speed2: no wave, longitudinal or transverse, may be faster.
  Row sound_everywhere() const {
    Worst worst;
    Random random(7);
    for (int i = 0; i < states; ++i) {
      const State state = subject_.somewhere(random, i);
      const double said = material().sound_speed2(state), per = get<field::VolumeRatio>(state) / material().rho0();
      const auto n = random.direction(), other = random.direction();
      Vec<double, 3> across{n[1] * other[2] - n[2] * other[1], n[2] * other[0] - n[0] * other[2],
                            n[0] * other[1] - n[1] * other[0]};
      across *= 1 / std::max(norm(across), 1e-30);
      for (const auto& k : {n, across}) {
        const Slope by = stiffness(state, k, n);
        worst.see(std::max(per * by.value - said, 0.0), per * by.error + 64 * eps * std::abs(said), [&] {
          return text("m^2/s^2 above it, ", in_state(i), ": ", said, ", differences of the stress ", per * by.value);
        });
      }
    }
    return worst.row("no wave is faster than the sound speed");
  }

  /// One increment of eight states against the same with numbers, all fields and all that the solver asks for.
  Row packs() const {
    Worst worst;
    Random random(10);
    for (int round = 0; round < 40; ++round) {
      std::array<State, lanes> one;
      typename M::template State<Pack<double>> pack;
      Mat<Pack<double>, 3> all{};
      std::array<Matrix, lanes> a;
      for (int l = 0; l < lanes; ++l) {
        const auto i = std::size_t(l);
        one[i] = subject_.somewhere(random, round + l);
        a[i] = subject_.increment(random, one[i], 0.1);
      }
      for (int c = 0; c < 9; ++c) all.c[c] = Pack<double>([&](int l) { return a[std::size_t(l)].c[c]; });
      for_each_number([&]<class Tag>(Tag, int c) {
        component<Tag>(get<Tag>(pack), c) =
            Pack<double>([&](int l) { return component<Tag>(get<Tag>(one[std::size_t(l)]), c); });
      });
      material().update(pack, all, subject_.step);
      for (int l = 0; l < lanes; ++l) {
        State& number = one[std::size_t(l)];
        material().update(number, a[std::size_t(l)], subject_.step);
        see_lane(worst, pack, number, l, round);
      }
    }
    return worst.row("packs are numbers, lane by lane");
  }

  /// q >= 0, none in expansion; and the time step's speed is not below that of sound.
  void viscosity(Report& report) const {
    if constexpr (M::viscous) {
      Worst pressure, speed;
      Random random(11);
      for (int i = 0; i < states; ++i) {
        const State state = subject_.somewhere(random, i);
        const Matrix a = subject_.increment(random, state, 0.05);
        const State after = subject_.moved(state, a);
        const double q = get<field::ViscousPressure>(after), rate = trace(Kinematics<double>(a).strain);
        pressure.see(rate > 0 ? std::abs(q) : std::max(-q, 0.0), 16 * eps * subject_.modulus,
                     [&] { return text("Pa, ", in_state(i), ": ", q, " at a change of volume of ", rate); });
        const double c2 = material().sound_speed2(after), signal2 = material().signal_speed2(after);
        speed.see(std::max(c2 - signal2, 0.0), 64 * eps * c2,
                  [&] { return text("m^2/s^2, ", in_state(i), ": ", signal2, " below ", c2); });
      }
      report.rows.push_back(pressure.row("viscous pressure only resists compression"));
      report.rows.push_back(speed.row("signal speed is not below that of sound"));
    }
  }

 private:
  double yield_stress(const State& state) const {
    const auto& strength = material().strength;
    if constexpr (StatesYield<std::remove_cvref_t<decltype(strength)>, State>) {
      return strength.yield_stress(state);
    } else {
      double limit = strength.yield;
      if constexpr (carries<State, field::PlasticStrain> && requires { strength.hardening * 1.0; })
        limit += strength.hardening * get<field::PlasticStrain>(state);
      return limit;
    }
  }

  template <class F>
  static void for_each_number(const F& f) {
    Subject<M>::for_each_field([&]<class Tag>(Tag tag) {
      for (int c = 0; c < Subject<M>::template numbers<Tag>; ++c) f(tag, c);
    });
  }

  template <class V>
  void see_lane(Worst& worst, const V& pack, const State& number, int l, int round) const {
    const auto see = [&](double packed, double expected, double scale, const char* what) {
      worst.see(std::abs(packed - expected), 256 * eps * scale,
                [&] { return text(what, " in lane ", l, ", round ", round, ": ", packed, " instead of ", expected); });
    };
    for_each_number([&]<class Tag>(Tag, int c) {
      const double expected = component<Tag>(get<Tag>(number), c);
      see(lane(component<Tag>(get<Tag>(pack), c), l), expected, subject_.template scale<Tag>(expected), Tag::name);
    });
    const auto s = material().stress(pack);
    const Tensor expected = material().stress(number);
    for (int c = 0; c < 6; ++c) see(lane(s.c[c], l), expected.c[c], subject_.modulus + magnitude(expected), "stress");
    const double c2 = material().signal_speed2(number), e = material().elastic_energy(number);
    see(lane(material().signal_speed2(pack), l), c2, subject_.c2 + std::abs(c2), "signal speed squared");
    see(lane(material().elastic_energy(pack), l), e, subject_.c2 + std::abs(e), "elastic energy");
  }
};

}  // namespace detail

/// Checks a material, whatever history its strength stores, along random paths of increments up to 10%, with volumes
/// within some 10%: objectivity, rest, yield surface, dissipation, continuity, sound speed against differences of the
/// stress, work against elastic and plastic energy on straight, closed and flowing paths, packs, viscosity.
///
///     std::cout << mote::verify::material(metal);
///
/// The yield surface is looked at if the strength has yield_stress(values), Pa, or `yield` (and `hardening`, Pa per
/// equivalent plastic strain). The equation of state has checks of its own, verify::eos(metal.eos).
template <class M>
Report material(const M& m) {
  static_assert(std::is_same_v<typename M::role, role::Material>,
                "mote: verify::material takes a Material; put a strength into one, beside an equation of state");
  const detail::MaterialChecks<M> checks(m);
  Report report{"material",
                {checks.objectivity(), checks.rest(), checks.yield(), checks.dissipation(), checks.smoothness(),
                 checks.sound_at_rest(), checks.sound_everywhere()}};
  detail::WorkChecks<M>(m).append_to(report);
  report.rows.push_back(checks.packs());
  checks.viscosity(report);
  return report;
}

}  // namespace mote::verify
