#include "convergence/orders_plane.hpp"

orders::Methods orders::cubic_in_plane() {
  Methods all;
  add_plane<shape::CubicBSpline>(all, "cubic", "FLIP", transfer::Flip{});
  add_plane<shape::CubicBSpline>(all, "cubic", "APIC", transfer::Apic{});
  add_plane<shape::CubicBSpline>(all, "cubic", "AFLIP", transfer::AffineFlip{});
  return all;
}
