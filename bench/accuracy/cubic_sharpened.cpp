#include "families.hpp"
#include "problems.hpp"

void accuracy::cubic_sharpened(const Wanted& wanted) { sharpened<shape::CubicBSpline>(wanted, "cubic"); }
