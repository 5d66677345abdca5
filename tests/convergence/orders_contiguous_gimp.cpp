#include "convergence/orders_bar.hpp"

orders::Methods orders::contiguous_gimp() { return on_line<mote::shape::ContiguousGimp>("cpGIMP"); }
