#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_cubic_flip", &line_of<shape::CubicBSpline, transfer::Flip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
