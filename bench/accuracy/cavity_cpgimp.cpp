#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_cpgimp(const Wanted& wanted) {
  run_cavity<shape::ContiguousGimp, update::Usl>(wanted, "cpgimp", "flip0.99", "usl", transfer::Flip{.blend = 0.99});
  run_cavity<shape::ContiguousGimp, update::Usl>(wanted, "cpgimp", "aflip", "usl", transfer::AffineFlip{});
}
