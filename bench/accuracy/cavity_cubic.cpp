#include "cavity.hpp"
#include "families.hpp"

void accuracy::cavity_cubic(const Wanted& wanted) {
  run_cavity<shape::CubicBSpline, update::Usl>(wanted, "cubic", "aflip", "usl", transfer::AffineFlip{});
}
