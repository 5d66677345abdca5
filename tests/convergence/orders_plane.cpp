#include "convergence/orders_plane.hpp"

orders::Methods orders::plane() {
  Methods all;
  add_plane<shape::Linear>(all, "linear", "FLIP", transfer::Flip{});
  add_plane<shape::QuadraticBSpline>(all, "quadratic", "FLIP", transfer::Flip{});
  return all;
}
