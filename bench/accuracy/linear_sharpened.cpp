#include "families.hpp"
#include "problems.hpp"

void accuracy::linear_sharpened(const Wanted& wanted) { sharpened<shape::Linear>(wanted, "linear"); }
