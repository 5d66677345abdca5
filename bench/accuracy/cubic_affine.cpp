#include "families.hpp"
#include "problems.hpp"

void accuracy::cubic_affine(const Wanted& wanted) { affine<shape::CubicBSpline>(wanted, "cubic"); }
