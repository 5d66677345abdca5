#include "families.hpp"
#include "problems.hpp"

void accuracy::quadratic_affine(const Wanted& wanted) { affine<shape::QuadraticBSpline>(wanted, "quadratic"); }
