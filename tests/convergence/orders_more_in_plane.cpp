#include "convergence/orders_plane.hpp"

orders::Methods orders::more_in_plane() {
  Methods all;
  add_plane<shape::QuadraticBSpline>(all, "quadratic", "APIC", transfer::Apic{});
  add_plane<shape::QuadraticBSpline>(all, "quadratic", "AFLIP", transfer::AffineFlip{});
  add_plane<shape::QuadraticBSpline>(all, "quadratic", "AFLIP(1)", transfer::AffineFlip{.order = 1});
  add_plane<shape::ContiguousGimp>(all, "cpGIMP", "FLIP", transfer::Flip{});
  return all;
}
