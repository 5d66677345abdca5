#include "report.hpp"

namespace stability {

static const Registered registered("plane_linear_flip", &plane_of<shape::Linear, transfer::Flip>);

}  // namespace stability
