/// \file
/// The table of what was compiled.
#include <algorithm>
#include <mote/core/error.hpp>

#include "result.hpp"

namespace cavity {

namespace {

template <std::size_t... N>
const Combination* find(const Options& o, const std::array<Combination, N>&... tables) {
  const Combination* found = nullptr;
  const auto look = [&](const Combination& c) {
    if (c.shape == o.shape && c.transfer == o.transfer && c.update == o.update && c.precision == o.precision &&
        c.conducts == (o.conductivity > 0))
      found = &c;
  };
  (std::for_each(tables.begin(), tables.end(), look), ...);
  return found;
}

}  // namespace

const Combination& find_combination(const Options& o) {
  const auto* found =
      find(o, linear_flip, linear_apic, linear_aflip, gimp_flip, quadratic_flip, quadratic_apic, quadratic_aflip,
           cubic_flip, cubic_apic, cubic_aflip, linear_xpic, quadratic_xpic, quadratic_fmpm, usf, linear_flip_float,
           quadratic_apic_float, quadratic_aflip_float, cubic_aflip_float, conducting);
  if (found) return *found;
  if (o.conductivity > 0)
    throw BadOption(mote::text(
        "--conductivity ", o.conductivity, " is not available with --shape ", to_string(o.shape), " --transfer ",
        to_string(o.transfer), " --update ", to_string(o.update), " --precision ", to_string(o.precision),
        "; it is with quadratic aflip usl, quadratic apic usl, quadratic flip usl and linear flip musl in double"));
  if ((o.shape == Shape::gimp || o.shape == Shape::cpgimp) && o.transfer != Transfer::flip)
    throw BadOption(mote::text("--transfer ", to_string(o.transfer), " is not available with --shape ",
                               to_string(o.shape), "; it needs --transfer flip"));
  if (o.precision == Precision::double_)
    throw BadOption(
        mote::text("--transfer ", to_string(o.transfer), " is not available with --shape ", to_string(o.shape),
                   " --update ", to_string(o.update),
                   "; flip, apic and aflip are with linear, quadratic and cubic, flip with gimp and cpgimp, all with usl or musl; "
                   "else there are linear flip usf, "
                   "quadratic flip usf, quadratic apic usf, linear xpic musl, quadratic xpic usl, "
                   "quadratic xpic usf and quadratic fmpm usl"));
  throw BadOption(
      mote::text("--precision ", to_string(o.precision), " is not available with --shape ", to_string(o.shape),
                 " --transfer ", to_string(o.transfer), " --update ", to_string(o.update),
                 "; it is with quadratic aflip usl, quadratic apic usl, cubic aflip usl and linear flip musl"));
}

}  // namespace cavity
