#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_quadratic_affine(const Wanted& wanted) {
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "apic", "usl", transfer::Apic{});
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "aflip", "usl", transfer::AffineFlip{});
  // what each of its parts does
  const auto part = [&](const char* name, double blend, int order) {
    run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", name, "usl",
                                                     transfer::AffineFlip{.blend = blend, .order = order}, {1});
  };
  part("aflip_0_1", 0, 1);
  part("aflip_0_2", 0, 2);
  part("aflip_0.9_1", 0.9, 1);
  part("aflip_0.9_3", 0.9, 3);
  part("aflip_1_2", 1, 2);
  if (wanted("cavity_100", "quadratic", "apic", "usl") && wanted("cavity_100", "quadratic", "aflip", "usl"))
    compare_cost<shape::QuadraticBSpline, update::Usl>("quadratic aflip over apic", transfer::Apic{},
                                                       transfer::AffineFlip{});
}
