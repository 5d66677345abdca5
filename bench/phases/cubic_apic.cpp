#include "phases.hpp"

void bench::add_cubic_apic() { add_rows<mote::shape::CubicBSpline, mote::transfer::Apic>("cubic/apic"); }
