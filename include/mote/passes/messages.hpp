/// \file
/// What a NumericalError says of a particle.
#pragma once

#include <cmath>
#include <string>

#include <mote/passes/body.hpp>

namespace mote::passes {

template <class T, int D>
std::string listed(const Vec<T, D>& v) {
  std::string all;
  for (int a = 0; a < D; ++a) all += text(a ? ", " : "", v[a]);
  return all;
}

template <class B>
std::string describe(const B& body, std::size_t p, std::size_t step) {
  return text("particle ", body.particles.template column<field::Id>()[p], " at (",
              listed(body.particles.template get<field::Position>(p)), ") m, in step ", step);
}

template <class B>
std::string describe_lost(const B& body, std::size_t p, const char* why, std::size_t step) {
  return text("mote: ", describe(body, p, step), ", ", why,
              ". Try a smaller Courant number, update::Musl or transfer::Apic, or look at the frames before");
}

template <class B>
std::string describe_failed(const B& body, std::size_t p, std::size_t step) {
  const auto v = body.particles.template get<field::Velocity>(p);
  if (!std::isfinite(norm(v)))
    return text("mote: ", describe(body, p, step), ", has the velocity (", listed(v),
                ") m/s. Try a smaller Courant number, update::Musl or transfer::Apic");
  return text(
      "mote: ", describe(body, p, step), ", has V/V0 = ", body.particles.template column<field::VolumeRatio>()[p],
      ", which its equation of state does not cover. Try a smaller Courant number, a finer grid or a lower speed");
}

/// The fastest particle of all bodies.
template <class Phases>
std::string describe_fastest(const Phases& phases, std::size_t step) {
  std::string found;
  double largest = -1;
  phases.for_each_body([&](const auto& body) {
    for (std::size_t p = 0; p < body.particles.size(); ++p) {
      const double v = double(norm(body.particles.template get<field::Velocity>(p)));
      if (v > largest || v != v) {
        largest = v;
        found = text(describe(body, p, step), " moves at ", v, " m/s");
      }
      if (v != v) return;
    }
  });
  return found;
}

}  // namespace mote::passes
