#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_cubic_apic", &line_of<shape::CubicBSpline, transfer::Apic, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
