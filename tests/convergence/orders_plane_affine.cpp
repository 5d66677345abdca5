#include "convergence/orders_plane.hpp"

orders::Methods orders::plane_affine() {
  Methods all;
  add_plane<shape::QuadraticBSpline>(all, "quadratic", "APIC", transfer::Apic{});
  add_plane<shape::QuadraticBSpline>(all, "quadratic", "AFLIP", transfer::AffineFlip{});
  add_plane<shape::CubicBSpline>(all, "cubic", "FLIP", transfer::Flip{});
  return all;
}
