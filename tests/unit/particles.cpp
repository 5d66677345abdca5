/// \file
/// Particle columns.
#include <mote/particles/particles.hpp>

#include "catch.hpp"

namespace {

using namespace mote;

using Some = fields<field::Velocity, field::DeviatoricStress, field::Id>;

/// n particles whose numbers all differ.
template <int D>
Particles<double, D, Some> numbered(std::size_t n) {
  Particles<double, D, Some> particles;
  particles.resize(n);
  double next = 1;
  particles.for_each_column([&](auto& column) {
    for (auto& value : column) value = std::remove_reference_t<decltype(value)>(next++);
  });
  return particles;
}

template <int D>
std::vector<double> numbers(Particles<double, D, Some>& particles) {
  std::vector<double> all;
  particles.for_each_column([&](const auto& column) { all.insert(all.end(), column.begin(), column.end()); });
  return all;
}

}  // namespace

TEST_CASE("particles take the bytes of their fields and no more", "[particles]") {
  STATIC_REQUIRE(Particles<double, 3, Some>::bytes_per_particle == 3 * 8 + 6 * 8 + 4);
  STATIC_REQUIRE(Particles<double, 2, Some>::bytes_per_particle == 2 * 8 + 4 * 8 + 4);
  STATIC_REQUIRE(Particles<float, 1, Some>::bytes_per_particle == 1 * 4 + 3 * 4 + 4);
}

TEST_CASE("each component of a field has a column of its own", "[particles]") {
  auto particles = numbered<3>(10);
  CHECK(particles.size() == 10);
  CHECK(particles.column<field::Velocity>(2).size() == 10);
  particles.column<field::Velocity>(1)[4] = -5;
  CHECK(particles.get<field::Velocity>(4)[1] == -5);
  CHECK(std::as_const(particles).column<field::Velocity>(1)[4] == -5);
}

TEST_CASE("what is set is got", "[particles]") {
  auto particles = numbered<3>(3);
  particles.set<field::Velocity>(1, Vec<double, 3>{7, 8, 9});
  CHECK(particles.get<field::Velocity>(1) == Vec<double, 3>{7, 8, 9});
  CHECK(particles.get<field::Velocity>(0) == Vec<double, 3>{1, 4, 7});
}

TEST_CASE("a plane-strain tensor is stored with four numbers and read with six", "[particles]") {
  auto particles = numbered<2>(1);
  particles.set<field::DeviatoricStress>(0, SymTensor<double>{{1, 2, 3, 4, 0, 0}});
  const auto s = particles.get<field::DeviatoricStress>(0);
  for (int c = 0; c < 6; ++c) CHECK(s.c[c] == (c < 4 ? c + 1 : 0));
}

TEST_CASE("setting everything leaves the id alone", "[particles]") {
  auto particles = numbered<3>(2);
  const auto id = particles.column<field::Id>()[1];
  particles.set_all(1, Values<double, 3, Some>{});
  CHECK(particles.column<field::Id>()[1] == id);
  CHECK(particles.get<field::Velocity>(1) == Vec<double, 3>{});
}

TEST_CASE("a pack is loaded lane by lane, and repeats the last particle beyond the end", "[particles]") {
  const int n = GENERATE(range(1, lanes + 1));
  const auto particles = numbered<2>(11);
  Values<Pack<double>, 2, fields<field::Velocity, field::DeviatoricStress>> values;
  particles.load(2, n, values);
  for (int l = 0; l < lanes; ++l) {
    const auto p = std::size_t(2 + std::min(l, n - 1)), lane = std::size_t(l);
    CHECK(get<field::Velocity>(values)[1][lane] == particles.column<field::Velocity>(1)[p]);
    CHECK(get<field::DeviatoricStress>(values).c[3][lane] == particles.column<field::DeviatoricStress>(3)[p]);
    CHECK(get<field::DeviatoricStress>(values).c[4][lane] == 0);
  }
}

TEST_CASE("a pack is stored to its particles only", "[particles]") {
  const int n = GENERATE(range(1, lanes + 1));
  auto particles = numbered<3>(12);
  const auto before = particles;
  Values<Pack<double>, 3, fields<field::Velocity>> values;
  for (int c = 0; c < 3; ++c) get<field::Velocity>(values)[c] = Pack<double>([&](int l) { return -10.0 * c - l; });
  particles.store(3, n, values, fields<field::Velocity>{});
  for (std::size_t p = 0; p < 12; ++p)
    for (int c = 0; c < 3; ++c) {
      const bool stored = p >= 3 && p < std::size_t(3 + n);
      const double old = before.column<field::Velocity>(c)[p];
      CHECK(particles.column<field::Velocity>(c)[p] == (stored ? -10.0 * c - double(p - 3) : old));
    }
}

TEST_CASE("loading and storing a pack changes nothing", "[particles]") {
  auto particles = numbered<3>(lanes);
  const auto before = numbers(particles);
  Values<Pack<double>, 3, fields<field::Velocity, field::DeviatoricStress>> values;
  particles.load(0, lanes, values);
  particles.store(0, lanes, values, fields<field::DeviatoricStress, field::Velocity>{});
  CHECK(numbers(particles) == before);
}

TEST_CASE("growing keeps the particles that are there", "[particles]") {
  auto particles = numbered<3>(4);
  const auto first = particles.get<field::Velocity>(2);
  particles.reserve(1000);
  particles.resize(500);
  CHECK(particles.size() == 500);
  CHECK(particles.get<field::Velocity>(2) == first);
}
