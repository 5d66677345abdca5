/// \file
/// verify::transfer: what the library has passes, and each check fails on a transfer that is wrong in that.
#include <mote/verify/transfer.hpp>

#include <mote/shape/linear.hpp>
#include <mote/transfer/affine_flip.hpp>
#include <mote/transfer/apic.hpp>
#include <mote/transfer/flip.hpp>
#include <mote/transfer/fmpm.hpp>
#include <mote/transfer/xpic.hpp>

#include "fails.hpp"

namespace {

using namespace mote;

enum class Fault { none, limiter, damped, transposed, kept, forces, packs };

/// FLIP that carries the gradient, with one mistake.
struct Faulty {
  using role = mote::role::Transfer;
  using particle_fields = fields<field::Affine>;
  static constexpr bool affine = true, increment = true, gradient = true;
  Fault fault;

  double kept() const { return fault == Fault::kept ? 0.9 : 0.95; }

  template <class V, class T, int D>
  void update(V& values, const GridVelocity<T, D>& grid) const {
    using std::min;
    auto& v = get<field::Velocity>(values);
    auto& c = get<field::Affine>(values);
    Vec<T, D> beside = v + grid.increment - grid.pic;
    if (fault == Fault::forces) beside += grid.increment;  // counts the forces twice
    if (fault == Fault::limiter)                           // clips what is fast
      for (int i = 0; i < D; ++i) beside[i] = min(beside[i], T(1));
    v = grid.pic * T(fault == Fault::damped ? 0.999 : 1) + T(0.95) * beside;
    c = grid.affine;
    if (fault == Fault::transposed) c = transpose(c);
    if (fault == Fault::packs && !is_pack<T>) c = c * T(1.01);
  }
};

void fails(Fault fault, const std::vector<std::string>& checks) {
  verdict::fails(verify::transfer(Faulty{fault}), checks);
}

}  // namespace

TEST_CASE("verify::transfer passes all transfers of the library", "[verify]") {
  verdict::passes(verify::transfer(transfer::Flip{}));
  verdict::passes(verify::transfer(transfer::Flip{.blend = 0}));
  verdict::passes(verify::transfer(transfer::Apic{}));
  verdict::passes(verify::transfer(transfer::Apic{}, shape::Linear{}));
  verdict::passes(verify::transfer(transfer::AffineFlip{}));
  verdict::passes(verify::transfer(transfer::Xpic{}));
  verdict::passes(verify::transfer(transfer::Fmpm{.order = 3}));
  verdict::passes(verify::transfer(Faulty{Fault::none}));
}

TEST_CASE("verify::transfer: each check fails on its own mistake", "[verify]") {
  fails(Fault::limiter, {"linear momentum is conserved"});
  fails(Fault::transposed, {"an affine field is preserved"});
  fails(Fault::kept, {"kept() is what a particle keeps"});
  fails(Fault::forces, {"what moves with the grid takes its velocity"});
  fails(Fault::packs, {"packs are numbers, lane by lane"});
  // who does not keep a constant keeps neither an affine field nor momentum, nor is he PIC
  fails(Fault::damped, {"what moves with the grid takes its velocity", "a constant field is preserved",
                        "an affine field is preserved", "linear momentum is conserved"});
}

TEST_CASE("verify::transfer reports angular momentum", "[verify]") {
  const auto spin = [](const auto& x) {
    for (const auto& row : verify::transfer(x).rows)
      if (row.check == "angular momentum") return row.measured;
    return -1.0;
  };
  CHECK(spin(transfer::Apic{}) < 1e-12);
  CHECK(spin(transfer::Flip{.blend = 0}) > 1e-3);
}
