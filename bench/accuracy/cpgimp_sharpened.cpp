#include "families.hpp"
#include "problems.hpp"

void accuracy::cpgimp_sharpened(const Wanted& wanted) { sharpened<shape::ContiguousGimp>(wanted, "cpgimp"); }
