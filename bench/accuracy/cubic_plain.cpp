#include "families.hpp"
#include "problems.hpp"

void accuracy::cubic_plain(const Wanted& wanted) { plain<shape::CubicBSpline>(wanted, "cubic"); }
