#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_quadratic_apic", &line_of<shape::QuadraticBSpline, transfer::Apic, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
