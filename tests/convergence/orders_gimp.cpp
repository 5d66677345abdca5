#include "convergence/orders_bar.hpp"

orders::Methods orders::gimp() { return on_line<mote::shape::Gimp>("GIMP"); }
