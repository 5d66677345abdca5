#include "report.hpp"

namespace stability {

static const Registered registered("plane_quadratic_flip", &plane_of<shape::QuadraticBSpline, transfer::Flip>);

}  // namespace stability
