/// \file
/// Whether an equation of state agrees with itself.
#pragma once

#include <mote/core/pack.hpp>
#include <mote/eos/concept.hpp>
#include <mote/verify/tools.hpp>

namespace mote::verify {

/// Volume ratios x = V/V0 in which an equation of state is looked at.
struct Volumes {
  double from = 0;  ///< > 0; 0: a tenth of the way from the smallest admissible x to 1
  double to = 1.5;  ///< > 1
};

namespace detail {

/// The checks of one equation of state. Round-off counts as of numbers of the size of P and of x dP/dx, since x is
/// known to round-off only; 64 of it, for what a formula of some dozen operations and two powers may add up.
template <class E>
class EosChecks {
  const E& eos_;
  Volumes range_;
  double excess_;  ///< J/kg, small beside the energy of sound speed
  static constexpr int cells = 100;

  static std::string at(double x) { return text("V/V0 = ", x); }
  double cell(int i) const { return range_.from * std::pow(range_.to / range_.from, double(i) / cells); }

  /// dP/dx at an excess that moves with x.
  Slope pressure_slope(double x, double excess, double d_excess) const {
    const auto p = [&](double y) { return double(eos_.pressure(y, excess + d_excess * (y - x))); };
    const double h = 1e-4 * x;
    return slope(p, x, h, 64 * eps * (std::abs(p(x)) + x * std::abs(p(x + h) - p(x - h)) / (2 * h)));
  }
  Slope internal_energy_slope(double x) const {
    const auto e = [&](double y) { return double(eos_.internal_energy(y)); };
    const double p = eos_.pressure(x, 0.0), stiffness = x * pressure_slope(x, 0, 0).value;
    return slope(e, x, 1e-4 * x, 64 * eps * (std::abs(e(x)) + x * (std::abs(p) + std::abs(stiffness)) / eos_.rho0));
  }
  /// Where a limit holds the pressure, whatever x: there a sound speed may be that of the state before the limit, and
  /// the reference curve may go on beneath it.
  static bool held(const Slope& dp) { return std::abs(dp.value) <= dp.error; }

  void compare_sound(Worst& worst, double x, double excess, double c2, const Slope& dp) const {
    const double by_differences = -x * x / eos_.rho0 * dp.value, difference = by_differences - c2;
    worst.see(held(dp) && !(difference > 0) ? 0 * c2 : std::abs(difference),
              x * x / eos_.rho0 * dp.error + 64 * eps * std::abs(c2), [&] {
                return text(at(x), ", excess ", excess, " J/kg: ", c2, " m^2/s^2, differences ", by_differences);
              });
  }

 public:
  EosChecks(const E& eos, const Volumes& range) : eos_(eos), range_(range) {
    require(range.from >= 0 && range.from < 1 && range.to > 1 && range.to < 100, "the volumes to verify are from ",
            range.from, " to ", range.to, "; they must lie around 1, from >= 0 to < 100");
    if (range.from == 0) {
      double lower = 0, upper = 1;
      for (int i = 0; i < 60; ++i) (eos.admissible(0.5 * (lower + upper)) ? upper : lower) = 0.5 * (lower + upper);
      range_.from = lower + 0.1 * (1 - lower);
    }
    const double c2 = std::abs(eos.bulk_sound_speed2(1.0, 0.0));
    excess_ = c2 > 0 && std::isfinite(c2) ? 0.02 * c2 : 1;
  }

  /// Covers x = 1 and an interval around it, refuses x <= 0 and nan, and is finite where it covers. Counts what is not.
  Row admissible() const {
    double wrong = 0;
    std::string where;
    const auto count = [&](bool ok, double x, const char* what) {
      if (!ok && wrong++ == 0) where = at(x) + what;
    };
    count(eos_.admissible(1.0), 1, " is not admissible");
    for (const double x : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
      count(!eos_.admissible(x), x, " is admissible");
    for (int i = 0; i <= cells; ++i) {
      const double x = cell(i);
      count(eos_.admissible(x), x, " is not admissible, but smaller and larger volumes are");
      count(std::isfinite(double(eos_.pressure(x, 0.0))), x, ": the pressure is not finite");
      count(std::isfinite(double(eos_.bulk_sound_speed2(x, 0.0))), x, ": the sound speed is not finite");
      count(std::isfinite(double(eos_.reference_energy(x))), x, ": the reference energy is not finite");
    }
    return {"admissible range", wrong, 0, wrong == 0, where};
  }

  Row continuity() const {
    Worst worst;
    for (int i = 0; i < cells; ++i)
      for (const double excess : {0.0, excess_}) {
        const double a = cell(i), b = cell(i + 1);
        const auto p = [&](double x) { return double(eos_.pressure(x, excess)); };
        const Jump jump = find_jump(p, a, b, [](double u, double v) { return std::abs(u - v); });
        const double noise = 64 * eps * (std::abs(p(a)) + std::abs(p(b)) + b / (b - a) * jump.whole);
        worst.see(jump.size, jump.allowed(noise), [&] { return text("Pa, ", at(jump.at)); });
      }
    return worst.row("pressure is continuous");
  }

  /// Zero at x = 1, and over each cell -int P dV by Simpson's rule; what halving the cell changes is fifteen times the
  /// error that is left where P is smooth, and as much as it where P has a kink.
  Row reference_energy() const {
    Worst worst;
    const double rho0 = eos_.rho0;
    const auto p = [&](double x) { return double(eos_.pressure(x, 0.0)); };
    const auto e = [&](double x) { return double(eos_.reference_energy(x)); };
    const auto simpson = [&](double a, double b) { return (b - a) / 6 * (p(a) + 4 * p(0.5 * (a + b)) + p(b)); };
    const auto noise = [&](double x) {
      const double stiffness = std::abs(p(x * 1.001) - p(x * 0.999)) / 0.002;
      return 64 * eps * (std::abs(e(x)) + x * (std::abs(p(x)) + stiffness) / rho0);
    };
    worst.see(std::abs(e(1)), noise(1), [&] { return text("J/kg, ", at(1)); });
    for (int i = 0; i < cells; ++i) {
      const double a = cell(i), b = cell(i + 1), m = 0.5 * (a + b);
      const double once = simpson(a, b), twice = simpson(a, m) + simpson(m, b);
      worst.see(std::abs(e(b) - e(a) + twice / rho0), std::abs(once - twice) / rho0 + noise(a) + noise(b),
                [&] { return text("J/kg, from ", at(a), " to ", b); });
    }
    return worst.row("reference energy is the work -int P dV");
  }

  Row sound_speed() const {
    Worst worst;
    Random random(1);
    for (int i = 0; i < 4 * cells; ++i) {
      const double x = random.between(range_.from * 1.001, range_.to), excess = i % 2 ? excess_ : 0;
      compare_sound(worst, x, excess, eos_.bulk_sound_speed2(x, excess), pressure_slope(x, excess, 0));
    }
    return worst.row("sound speed is that of the pressure");
  }

  /// At fixed entropy, for energy::Full: the excess changes by -P dV less what internal_energy rises.
  Row isentropic_sound_speed() const {
    Worst worst;
    Random random(2);
    for (int i = 0; i < 4 * cells; ++i) {
      const double x = random.between(range_.from * 1.001, range_.to), excess = i % 2 ? excess_ : 0;
      const Slope reference = internal_energy_slope(x);
      const double d_excess = -eos_.pressure(x, excess) / eos_.rho0 - reference.value;
      Slope dp = pressure_slope(x, excess, d_excess);
      const double by_energy = eos_.pressure(x, 2 * excess_) - eos_.pressure(x, excess_);
      dp.error += std::abs(by_energy / excess_) * reference.error;
      compare_sound(worst, x, excess, isentropic_sound_speed2(eos_, x, excess), dp);
    }
    return worst.row("isentropic sound speed is that of the pressure");
  }

  /// dP/dE = rho0 (V0 gamma/V) / V0 on the reference curve.
  Row gamma() const {
    Worst worst;
    Random random(3);
    for (int i = 0; i < cells; ++i) {
      const double x = random.between(range_.from * 1.001, range_.to);
      const auto p = [&](double excess) { return double(eos_.pressure(x, excess)); };
      const Slope by = slope_to(p, 0, 0.01 * excess_, 64 * eps * std::abs(p(0)));
      const double said = eos_.rho0 * gamma_over_volume(eos_, x);
      worst.see(std::abs(said - by.value), by.error + 64 * eps * std::abs(said),
                [&] { return text("kg/m^3, ", at(x), ": ", said, ", differences ", by.value); });
    }
    return worst.row("gamma/V is dP/dE");
  }

  Row internal_energy() const {
    Worst worst;
    Random random(4);
    for (int i = 0; i < cells; ++i) {
      const double x = random.between(range_.from * 1.001, range_.to), p = eos_.pressure(x, 0.0);
      const Slope dp = pressure_slope(x, 0, 0);
      if (held(dp) && p != 0) continue;
      const Slope by = internal_energy_slope(x);
      const double said = eos_.reference_heating(x) - p / eos_.rho0;
      worst.see(std::abs(said - by.value), by.error,
                [&] { return text("J/kg, ", at(x), ": ", said, ", differences ", by.value); });
    }
    return worst.row("internal energy is heat less work");
  }

  /// One formula for numbers and packs, up to how the compiler fuses products.
  Row packs() const {
    Worst worst;
    Random random(5);
    for (int i = 0; i < cells; ++i) {
      const Pack<double> x([&](int) { return random.between(range_.from, range_.to); });
      const Pack<double> excess([&](int l) { return l % 2 ? excess_ : 0; });
      const Pack<double> p = eos_.pressure(x, excess), c2 = eos_.bulk_sound_speed2(x, excess),
                         e = eos_.reference_energy(x), h = eos_.reference_heating(x);
      const auto in_range = eos_.admissible(x);
      for (int l = 0; l < lanes; ++l) {
        const double y = lane(x, l), f = lane(excess, l), speed2 = eos_.bulk_sound_speed2(y, f);
        const double pressure = eos_.pressure(y, f), noise = std::abs(pressure) / eos_.rho0 + std::abs(speed2 / y);
        const auto see = [&](double packed, double number, const char* what) {
          worst.see(std::abs(packed - number), 64 * eps * (std::abs(number) + noise),
                    [&] { return text(what, " in lane ", l, ", ", at(y), ": ", packed, " instead of ", number); });
        };
        see(lane(p, l) / eos_.rho0, pressure / eos_.rho0, "P/rho0");
        see(lane(c2, l), speed2, "sound speed squared");
        see(lane(e, l), eos_.reference_energy(y), "reference energy");
        see(lane(h, l), eos_.reference_heating(y), "reference heating");
        see(in_range[std::size_t(l)] ? 1 : 0, eos_.admissible(y) ? 1 : 0, "admissible");
      }
    }
    return worst.row("packs are numbers, lane by lane");
  }
};

}  // namespace detail

/// Checks an equation of state: admissible range, continuity of P, reference energy = -int P dV, sound speeds and
/// gamma against differences of P, internal_energy (if it has one), packs.
///
///     std::cout << mote::verify::eos(Murnaghan{...});
///
/// Where P does not depend on x (eos::TensionCutoff), a sound speed may be above that of the pressure, not below. An
/// equation of state that is sound in a range only names it. Throws InputError for impossible volumes.
template <class E>
Report eos(const E& e, const Volumes& range = {}) {
  static_assert(mote::Eos<E>, "mote: the equation of state lacks a member; eos/concept.hpp lists them");
  const detail::EosChecks<E> checks(e, range);
  Report report{"eos",
                {checks.admissible(), checks.continuity(), checks.reference_energy(), checks.sound_speed(),
                 checks.gamma(), checks.packs()}};
  if constexpr (HasInternalEnergy<E>) {
    report.rows.push_back(checks.internal_energy());
    report.rows.push_back(checks.isentropic_sound_speed());
  }
  return report;
}

}  // namespace mote::verify
