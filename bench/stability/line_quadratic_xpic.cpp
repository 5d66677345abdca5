#include "report.hpp"

namespace stability {

static const Registered registered("line_quadratic_xpic",
                                   &line_of<shape::QuadraticBSpline, transfer::Xpic, update::Usl>);

}  // namespace stability
