#include "phases.hpp"

void bench::add_cubic_flip() { add_rows<mote::shape::CubicBSpline, mote::transfer::Flip>("cubic/flip"); }
