#include "report.hpp"

namespace stability {

static const Registered registered("line_linear_apic",
                                   &line_of<shape::Linear, transfer::Apic, update::Usl, update::Musl, update::Usf>);

}  // namespace stability
