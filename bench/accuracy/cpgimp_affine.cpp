#include "families.hpp"
#include "problems.hpp"

void accuracy::cpgimp_affine(const Wanted& wanted) { affine<shape::ContiguousGimp>(wanted, "cpgimp"); }
