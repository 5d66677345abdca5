#include "phases.hpp"

void bench::add_quadratic_flip() { add_rows<mote::shape::QuadraticBSpline, mote::transfer::Flip>("quadratic/flip"); }
