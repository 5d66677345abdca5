#include "convergence/orders_bar.hpp"

orders::Methods orders::quadratic() { return on_line<mote::shape::QuadraticBSpline>("quadratic"); }
