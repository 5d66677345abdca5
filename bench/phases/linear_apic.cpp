#include "phases.hpp"

// No MUSL: C of linear hats feeds the noise of tiny nodes back (update/musl.hpp).
void bench::add_linear_apic() { add_rows<mote::shape::Linear, mote::transfer::Apic, false>("linear/apic"); }
