#include "families.hpp"
#include "problems.hpp"

void accuracy::quadratic_sharpened(const Wanted& wanted) { sharpened<shape::QuadraticBSpline>(wanted, "quadratic"); }
