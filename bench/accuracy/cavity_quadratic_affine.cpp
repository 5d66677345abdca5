#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_quadratic_affine(const Wanted& wanted) {
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "apic", "usl", transfer::Apic{});
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "aflip", "usl", transfer::AffineFlip{});
  // what each of its parts does
  const auto part = [&](const char* name, const transfer::AffineFlip& transfer) {
    run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", name, "usl", transfer, {1});
  };
  part("aflip_b0", {.blend = 0});
  part("aflip_b0.9", {.blend = 0.9});
  part("aflip_b1", {.blend = 1});
  part("aflip_1", {.order = 1});
  part("aflip_3", {.order = 3});
  part("aflip_tail_1", {.tail = 1});
  if (wanted("cavity_100", "quadratic", "apic", "usl") && wanted("cavity_100", "quadratic", "aflip", "usl"))
    compare_cost<shape::QuadraticBSpline, update::Usl>("quadratic aflip over apic", transfer::Apic{},
                                                       transfer::AffineFlip{});
}
