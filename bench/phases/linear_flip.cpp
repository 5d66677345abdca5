#include "phases.hpp"

void bench::add_linear_flip() { add_rows<mote::shape::Linear, mote::transfer::Flip>("linear/flip"); }
