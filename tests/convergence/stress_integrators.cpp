// Stress integrators on a strain path with a corner and a curve, against the rate equations integrated by Runge and
// Kutta.
#include <cmath>
#include <cstdio>
#include <mote/strength/von_mises_mixed.hpp>
#include <mote/strength/von_mises_mixed_exponential.hpp>
#include <string>

#include "catch.hpp"
#include "convergence/strain_path.hpp"

namespace {

using namespace mote;
using namespace strain_path;

const std::vector<int> steps{20, 40, 80, 160, 320, 640};

template <class Strength>
std::vector<double> errors(const char* name, const Strength& strength, const Metal& metal) {
  const Path path;
  const Reference reference(path, metal, steps.back());
  REQUIRE(reference.least > -1e-12);  // the reference assumes that nothing unloads
  REQUIRE(reference.drift < 1e-9);    // and stays on the yield surface
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
