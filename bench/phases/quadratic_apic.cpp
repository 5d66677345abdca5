#include "phases.hpp"

void bench::add_quadratic_apic() { add_rows<mote::shape::QuadraticBSpline, mote::transfer::Apic>("quadratic/apic"); }
