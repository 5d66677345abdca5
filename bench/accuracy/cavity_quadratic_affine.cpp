#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_quadratic_affine(const Wanted& wanted) {
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "apic", "usl", transfer::Apic{});
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "aflip", "usl", transfer::AffineFlip{});
}
