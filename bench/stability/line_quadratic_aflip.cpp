#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_quadratic_aflip",
    &line_of<shape::QuadraticBSpline, transfer::AffineFlip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
