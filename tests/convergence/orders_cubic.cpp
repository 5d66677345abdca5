#include "convergence/orders_bar.hpp"

orders::Methods orders::cubic() { return on_line<mote::shape::CubicBSpline>("cubic"); }
