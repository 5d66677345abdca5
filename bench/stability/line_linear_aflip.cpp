#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_linear_aflip", &line_of<shape::Linear, transfer::AffineFlip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
