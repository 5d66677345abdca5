#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_quadratic_flip", &line_of<shape::QuadraticBSpline, transfer::Flip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
