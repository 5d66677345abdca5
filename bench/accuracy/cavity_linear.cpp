#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_linear(const Wanted& wanted) {
  run_cavity<shape::Linear, update::Musl>(wanted, "linear", "flip", "musl", transfer::Flip{.blend = 1});
  run_cavity<shape::Linear, update::Musl>(wanted, "linear", "flip0.99", "musl", transfer::Flip{.blend = 0.99});
}
