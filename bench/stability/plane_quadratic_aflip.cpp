#include "report.hpp"

namespace stability {

static const Registered registered("plane_quadratic_aflip", &plane_of<shape::QuadraticBSpline, transfer::AffineFlip>);

}  // namespace stability
