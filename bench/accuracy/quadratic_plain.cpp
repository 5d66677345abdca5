#include "families.hpp"
#include "problems.hpp"

void accuracy::quadratic_plain(const Wanted& wanted) { plain<shape::QuadraticBSpline>(wanted, "quadratic"); }
