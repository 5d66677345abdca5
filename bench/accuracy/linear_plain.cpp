#include "families.hpp"
#include "problems.hpp"

void accuracy::linear_plain(const Wanted& wanted) { plain<shape::Linear>(wanted, "linear"); }
