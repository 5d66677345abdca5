/// \file
/// What a material whose elastic part has an energy must do: stress from energy, waves no faster than it says.
#pragma once

#include <algorithm>
#include <mote/core/spectral.hpp>
#include <mote/material.hpp>

#include "unit/strength/checks.hpp"

namespace checks {

/// The state after a gradient F, in one increment from rest.
template <class M>
auto at(const M& material, const Matrix& f) {
  auto state = material.template initial<double>();
  material.update(state, f - Matrix::identity());
  return state;
}

/// A gradient of stretches between exp(-size) and exp(size), turned before and after.
inline Matrix some_gradient(Random& random, double size) {
  const Matrix q = Kinematics<double>(random.matrix(2)).rotation, r = Kinematics<double>(random.matrix(2)).rotation;
  Matrix d{};
  for (int i = 0; i < 3; ++i) d(i, i) = std::exp(random(size));
  return q * d * r;
}

/// rho0 d(energy) = J sigma : d for every small displacement gradient d on top of F.
template <class M>
void stress_from_energy(const M& material, double size, double modulus) {
  Random random;
  for (int n = 0; n < 100; ++n) {
    const Matrix f = some_gradient(random, size), d = random.matrix(1);
    const double h = 1e-5, rho0 = material.rho0();
    const auto energy = [&](double e) {
      return material.elastic_energy(at(material, (Matrix::identity() + e * d) * f));
    };
    const auto state = at(material, f);
    const double expected = det(f) * ddot(material.stress(state), sym(d));
    INFO("gradient " << n);
    // fourth-order differences
    const double slope = rho0 * (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
    REQUIRE(slope == Approx(expected).margin(1e-8 * modulus));
    // and the pressure is minus the mean stress
    REQUIRE(material.pressure(state) == Approx(-trace(material.stress(state)) / 3).margin(1e-12 * modulus));
  }
}

inline Matrix full(const Tensor& t) {
  Matrix m{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = t(i, j);
  return m;
}

/// The acoustic tensor over the density along n, by differences of the traction.
template <class M>
Tensor acoustic_tensor(const M& material, const Matrix& f, const Vec<double, 3>& n) {
  const double h = 1e-5, density = material.rho0() / det(f);
  Matrix q{};
  for (int k = 0; k < 3; ++k) {
    const auto traction = [&](double e) {
      Matrix a = Matrix::identity();  // I + e (k-th unit vector) n
      for (int j = 0; j < 3; ++j) a(k, j) += e * n[j];
      const auto sigma = material.stress(at(material, a * f));
      return det(a) * (full(sigma) * (transpose(inverse(a)) * n));
    };
    const Vec<double, 3> d = (traction(h) - traction(-h)) * (1 / (2 * h * density));
    for (int i = 0; i < 3; ++i) q(i, k) = d[i];
  }
  return sym(q);
}

/// No plane wave is faster than sound_speed2, and the fastest not much slower. \return the largest and the smallest
/// ratio of the fastest wave (over some directions) and what the material says, squared.
template <class M>
std::pair<double, double> wave_ratios(const M& material, double size) {
  Random random;
  double largest = 0, smallest = 1e300;
  for (int n = 0; n < 200; ++n) {
    const Matrix f = some_gradient(random, size);
    const double said = material.sound_speed2(at(material, f));
    const auto axes = spectral(rotate(f, Tensor{1, 1, 1, 0, 0, 0})).vectors;
    double fastest = 0;
    for (int k = 0; k < 20; ++k) {
      Vec<double, 3> way{random(1), random(1), random(1)};
      if (k < 3) way = {axes(0, k), axes(1, k), axes(2, k)};  // principal axes too
      way *= 1 / norm(way);
      const auto s = spectral(acoustic_tensor(material, f, way));
      fastest = std::max({fastest, s.values[0], s.values[1], s.values[2]});
    }
    largest = std::max(largest, fastest / said);
    smallest = std::min(smallest, fastest / said);
  }
  return {largest, smallest};
}

}  // namespace checks
