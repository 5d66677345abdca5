#include "families.hpp"
#include "problems.hpp"

void accuracy::linear_affine(const Wanted& wanted) { affine<shape::Linear>(wanted, "linear"); }
