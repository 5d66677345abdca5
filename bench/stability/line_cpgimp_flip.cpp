#include "report.hpp"

namespace stability {

static const Registered registered(
    "line_cpgimp_flip", &line_of<shape::ContiguousGimp, transfer::Flip, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
