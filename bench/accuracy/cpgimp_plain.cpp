#include "families.hpp"
#include "problems.hpp"

void accuracy::cpgimp_plain(const Wanted& wanted) { plain<shape::ContiguousGimp>(wanted, "cpgimp"); }
