/// \file
/// A material's states along random paths, and how two of them compare, whatever fields they hold.
#pragma once

#include <array>
#include <mote/material.hpp>
#include <mote/verify/tools.hpp>
#include <string_view>

namespace mote::verify::detail {

using Matrix = Mat<double, 3>;
using Tensor = SymTensor<double>;

inline double magnitude(const Tensor& s) { return std::sqrt(ddot(s, s)); }
inline double magnitude(const Matrix& a) {
  double sum = 0;
  for (const double c : a.c) sum += c * c;
  return std::sqrt(sum);
}
/// k n^T
inline Matrix outer(const Vec<double, 3>& k, const Vec<double, 3>& n) {
  Matrix a{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a(i, j) = k[i] * n[j];
  return a;
}
/// Q - I of a turn about n, without the round-off of cos - 1.
inline Matrix turning(const Vec<double, 3>& n, double angle) {
  const Matrix w{0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0};
  const double half = std::sin(angle / 2);
  return std::sin(angle) * w + (2 * half * half) * (w * w);
}

/// A material with what its checks need: scales, states, increments. Only initial(), update(), stress() and the fields
/// move it, so that a strength may store what it likes.
template <class M>
struct Subject {
  using State = typename M::template State<double>;

  const M& material;
  double c2;       ///< m^2/s^2, squared sound speed at rest, the scale of energies
  double modulus;  ///< rho0 c^2, Pa, the scale of stresses
  Step step;       ///< of a Courant number of 0.4

  explicit Subject(const M& m) : material(m), step{1, 1} {
    const State rest = m.template initial<double>();
    c2 = m.sound_speed2(rest);
    if (!(c2 > 0 && std::isfinite(c2))) c2 = std::max(magnitude(m.stress(rest)) / m.rho0(), 1e-30);
    modulus = m.rho0() * c2;
    step.dt = 0.4 / std::sqrt(c2);
  }

  State rest() const { return material.template initial<double>(); }
  State moved(State state, const Matrix& a) const {
    material.update(state, a, step);
    return state;
  }
  /// After an increment of nothing: what is viscous has died out.
  State settled(const State& state) const { return moved(state, Matrix{}); }

  /// Without the viscous pressure.
  Tensor stress(const State& state) const {
    Tensor s = material.stress(state);
    if constexpr (M::viscous) s = add_diagonal(s, get<field::ViscousPressure>(state));
    return s;
  }
  double flow(const State& state) const {
    if constexpr (M::plastic)
      return get<field::PlasticWork>(state);
    else
      return 0;
  }

  /// `after` with the dissipated work, and its heat, of `before`.
  static State without_heat(State after, const State& before) {
    if constexpr (M::plastic) {
      const double work = get<field::PlasticWork>(after) - get<field::PlasticWork>(before);
      get<field::PlasticWork>(after) -= work;
      if constexpr (carries<State, field::InternalEnergy>) get<field::InternalEnergy>(after) -= work;
    }
    return after;
  }

  /// Round-off of a stress: 256 operations of numbers of the size of the stress and of the modulus, since strains are
  /// known to round-off of 1. A rotation by up to 120 degrees, whose mid-point gradient is up to 2 tan 60 and has a
  /// condition number of 4, takes half of that.
  double noise(const Tensor& s) const { return 256 * eps * (modulus + magnitude(s)); }

  /// From far below to far above what metals yield at; brings the volume back when it has gone 10% away.
  Matrix increment(Random& random, const State& state, double largest) const {
    Matrix a = random.matrix(largest * std::pow(10, random.between(-4, 0)));
    const double x = get<field::VolumeRatio>(state), next = x * det(Matrix::identity() + a);
    if (next > 0.9 && next < 1.1) return a;
    const double back = std::cbrt(1 / x) - 1 - (a(0, 0) + a(1, 1) + a(2, 2)) / 3;
    for (int i = 0; i < 3; ++i) a(i, i) += back;
    return a;
  }
  /// After up to seven increments, settled.
  State somewhere(Random& random, int number) const {
    State state = rest();
    for (int i = 0; i < number % 8; ++i) state = moved(state, increment(random, state, 0.03));
    return settled(state);
  }

  /// The absolute size of a field's round-off: of its value, and of what its unit says (strains: 1).
  template <class Tag>
  double scale(double value) const {
    const std::string_view unit = Tag::unit;
    return std::abs(value) + (unit == "Pa" ? modulus : unit == "J/kg" ? c2 : unit == "1" ? 1 : 0);
  }
  template <class F>
  static void for_each_field(const F& f) {
    [&]<class... Tags>(fields<Tags...>) { (f(Tags{}), ...); }(typename M::particle_fields{});
  }
  template <class Tag>
  static constexpr int numbers =
      std::is_same_v<typename Tag::shape, shape_of::Symmetric> ? 6 : Tag::shape::template components<3>;

  /// Stress turned by q, and all that is a scalar, unchanged.
  void see_turned(Worst& worst, const State& a, const Matrix& q, const State& b, const std::string& where) const {
    const Tensor expected = rotate(q, stress(a)), found = stress(b);
    worst.see(magnitude(found - expected), noise(expected), [&] { return "Pa, stress, " + where; });
    for_each_field([&]<class Tag>(Tag) {
      if constexpr (std::is_same_v<typename Tag::shape, shape_of::Scalar>)
        // the mid-point inverse of a turn by 2.1 rad has a condition of 2, and turns both sides of a tensor: 4 times 256
        worst.see(std::abs(get<Tag>(b) - get<Tag>(a)), 1024 * eps * scale<Tag>(get<Tag>(a)),
                  [&] { return text(Tag::unit, ", ", Tag::name, ", ", where); });
    });
  }
};

}  // namespace mote::verify::detail
