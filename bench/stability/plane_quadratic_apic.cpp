#include "report.hpp"

namespace stability {

static const Registered registered("plane_quadratic_apic", &plane_of<shape::QuadraticBSpline, transfer::Apic>);

}  // namespace stability
