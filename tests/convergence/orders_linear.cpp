#include "convergence/orders_bar.hpp"

orders::Methods orders::linear() { return on_line<mote::shape::Linear>("linear"); }
