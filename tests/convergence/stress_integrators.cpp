// Stress integrators on a strain path with a corner and a curve, against the rate equations integrated by Runge and
// Kutta.
#include <cmath>
#include <cstdio>
#include <mote/strength/von_mises_mixed.hpp>
#include <mote/strength/von_mises_mixed_exponential.hpp>
#include <numbers>
#include <vector>

#include "catch.hpp"

namespace {

using namespace mote;
using Tensor = SymTensor<double>;

constexpr double g = 25.94e9, yield = 120e6;
double magnitude(const Tensor& a) { return std::sqrt(ddot(a, a)); }

/// Deviatoric strain as a function of time: straight to `size` times the yield strain (t = 0 to 1), there a corner of a
/// right angle, then half a turn about the origin (t = 1 to 2).
struct Path {
  double size = 5;
  double radius = size * std::sqrt(2.0 / 3) * yield / (2 * g);  // |e| at the corner

  static Tensor in_plane(double a, double b) {
    const double u = a / std::sqrt(6), v = b / std::sqrt(2);
    return {{2 * u, -u, -u, v, 0, 0}};
  }
  Tensor strain(double t) const {
    if (t <= 1) return in_plane(radius * t, 0);
    const double phi = std::numbers::pi * (t - 1);
    return in_plane(radius * std::cos(phi), radius * std::sin(phi));
  }
  /// On the leg that begins at t = 0 or 1.
  Tensor rate(double t, int leg) const {
    if (leg == 0) return in_plane(radius, 0);
    const double phi = std::numbers::pi * (t - 1), w = std::numbers::pi * radius;
    return in_plane(-w * std::sin(phi), w * std::cos(phi));
  }
  double yields_at() const { return 1 / size; }
};

struct Metal {
  double isotropic, kinematic;
};

/// What the rate equations move: stress, back stress, equivalent plastic strain.
struct Point {
  Tensor s, back;
  double eps;
};

/// Runge-Kutta integration of the rate equations with the consistency condition; shares no code with the policies.
class Reference {
  Path path_;
  Metal metal_;

  Point rate(double t, int leg, const Point& p) const {
    const Tensor relative = p.s - p.back, n = relative * (1 / magnitude(relative)), e = path_.rate(t, leg);
    const double k = 2 * g + (2.0 / 3) * (metal_.isotropic + metal_.kinematic), along = ddot(n, e);
    least_ = std::min(least_, along / magnitude(e));
    const double flow = 2 * g * along / k;
    return {2 * g * (e - flow * n), (2.0 / 3 * metal_.kinematic * flow) * n, std::sqrt(2.0 / 3) * flow};
  }
  static Point sum(const Point& p, double h, const Point& r) {
    return {p.s + h * r.s, p.back + h * r.back, p.eps + h * r.eps};
  }
  void advance(Point& p, double from, double to, int leg) const {
    const int n = 40;
    const double h = (to - from) / n;
    for (int i = 0; i < n; ++i) {
      const double t = from + i * h;
      const Point a = rate(t, leg, p), b = rate(t + h / 2, leg, sum(p, h / 2, a)),
                  c = rate(t + h / 2, leg, sum(p, h / 2, b)), d = rate(t + h, leg, sum(p, h, c));
      p = sum(sum(sum(sum(p, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
  }

 public:
  std::vector<Point> states;  ///< at n + 1 equal times
  mutable double least_ = 1;  ///< smallest n : e'/|e'|: above zero the metal flows all the time
  double drift = 0;           ///< from the yield surface, relative

  Reference(const Path& path, const Metal& metal, int n) : path_(path), metal_(metal) {
    const double start = path.yields_at();
    Point p{};
    bool flows = false;
    states.push_back(p);
    for (int i = 0; i < n; ++i) {
      const double from = 2.0 * i / n, to = 2.0 * (i + 1) / n;
      const int leg = i >= n / 2;
      if (to > start) {
        if (!flows) p.s = 2 * g * path.strain(std::max(from, start));
        advance(p, flows ? from : std::max(from, start), to, leg);
        flows = true;
        const double limit = std::sqrt(2.0 / 3) * (yield + metal.isotropic * p.eps);
        drift = std::max(drift, std::abs(magnitude(p.s - p.back) / limit - 1));
      } else {
        p.s = 2 * g * path.strain(to);
      }
      states.push_back(p);
    }
  }
};

/// The displacement increment whose mid-point strain is `e`, without rotation.
Mat<double, 3> stretch(const Tensor& e) {
  Mat<double, 3> m{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = e(i, j);
  return m * inverse(Mat<double, 3>::identity() - 0.5 * m);
}

/// Largest |s - s_ref| on the way over the first yield radius, sqrt(2/3) Y.
template <class Strength>
double error(const Strength& strength, const Path& path, const Reference& reference, int steps) {
  Values<double, 3, union_of<typename Strength::particle_fields, fields<field::VolumeRatio>>> state{};
  get<field::VolumeRatio>(state) = 1;
  const std::size_t every = (reference.states.size() - 1) / std::size_t(steps);
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    const double from = 2.0 * i / steps, to = 2.0 * (i + 1) / steps;
    const Kinematics<double> k(stretch(path.strain(to) - path.strain(from)));
    strength.update(state, k);
    const Tensor& exact = reference.states[std::size_t(i + 1) * every].s;
    largest = std::max(largest, magnitude(get<field::DeviatoricStress>(state) - exact));
  }
  return largest / (std::sqrt(2.0 / 3) * yield);
}

const std::vector<int> steps{20, 40, 80, 160, 320, 640};

template <class Strength>
std::vector<double> errors(const char* name, const Strength& strength, const Metal& metal) {
  const Path path;
  const Reference reference(path, metal, steps.back());
  REQUIRE(reference.least_ > -1e-12);  // the reference assumes that nothing unloads
  REQUIRE(reference.drift < 1e-9);     // and stays on the yield surface
  std::vector<double> all;
  for (const int n : steps) all.push_back(error(strength, path, reference, n));
  std::printf("%-42s", name);
  for (const double e : all) std::printf(" %9.2e", e);
  std::printf("  order %.2f\n", std::log2(all[all.size() - 2] / all.back()));
  return all;
}

double order(const std::vector<double>& e, std::size_t i) { return std::log2(e[i] / e[i + 1]); }
constexpr std::size_t at_160 = 3;

}  // namespace

TEST_CASE("stress integrators: radial return is of order 1, the exponential map of order 2", "[convergence]") {
  using namespace strength;
  struct Case {
    const char* name;
    Metal metal;
  };
  const auto [name, metal] =
      GENERATE(Case{"perfect", {0, 0}}, Case{"isotropic 5 GPa", {5e9, 0}}, Case{"kinematic 5 GPa", {0, 5e9}},
               Case{"both 5 GPa", {5e9, 5e9}}, Case{"the paper's 0.384 GPa", {384e6, 0}});
  const auto label = [n = name](const char* what) { return std::string(what) + ", " + n; };
  const auto radial = errors(
      label("radial return").c_str(),
      VonMisesMixed{
          .shear_modulus = g, .yield = yield, .hardening = metal.isotropic, .kinematic_hardening = metal.kinematic},
      metal);
  const auto exponential = errors(
      label("exponential map").c_str(),
      VonMisesMixedExponential{
          .shear_modulus = g, .yield = yield, .hardening = metal.isotropic, .kinematic_hardening = metal.kinematic},
      metal);
  for (std::size_t i = at_160 - 1; i + 1 < steps.size(); ++i) {
    INFO(name << ", " << steps[i] << " to " << steps[i + 1] << " steps");
    CHECK(order(radial, i) == Approx(1).margin(0.1));
    CHECK(order(exponential, i) == Approx(2).margin(0.1));
  }
  CHECK(exponential[at_160] * 20 < radial[at_160]);
}
