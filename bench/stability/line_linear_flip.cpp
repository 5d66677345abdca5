#include "report.hpp"

namespace stability {

static const Registered registered("line_linear_flip",
                                   &line_of<shape::Linear, transfer::Flip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
