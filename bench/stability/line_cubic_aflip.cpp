#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_cubic_aflip", &line_of<shape::CubicBSpline, transfer::AffineFlip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
