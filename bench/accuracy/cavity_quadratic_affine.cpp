#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_quadratic_affine(const Wanted& wanted) {
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "apic", "usl", transfer::Apic{});
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "aflip", "usl", transfer::AffineFlip{});
  // what each of its parts does
  const auto part = [&](const char* name, double blend, double affine_blend) {
    run_cavity<shape::QuadraticBSpline, update::Usl>(
        wanted, "quadratic", name, "usl", transfer::AffineFlip{.blend = blend, .affine_blend = affine_blend}, {1});
  };
  part("aflip_0_0", 0, 0);
  part("aflip_0.95_0", 0.95, 0);
  part("aflip_1_1", 1, 1);
  if (wanted("cavity_100", "quadratic", "apic", "usl") && wanted("cavity_100", "quadratic", "aflip", "usl"))
    compare_cost<shape::QuadraticBSpline, update::Usl>("quadratic aflip over apic", transfer::Apic{},
                                                       transfer::AffineFlip{});
}
