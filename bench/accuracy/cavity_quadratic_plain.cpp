#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_quadratic_plain(const Wanted& wanted) {
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "flip", "usl", transfer::Flip{.blend = 1});
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "flip0.99", "usl",
                                                   transfer::Flip{.blend = 0.99});
  run_cavity<shape::QuadraticBSpline, update::Musl>(wanted, "quadratic", "flip0.99", "musl",
                                                    transfer::Flip{.blend = 0.99});
  run_cavity<shape::QuadraticBSpline, update::Usl>(wanted, "quadratic", "fmpm", "usl", transfer::Fmpm{});
}
