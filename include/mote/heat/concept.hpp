/// \file
/// What a heat policy offers: how the temperature follows volume change and plastic work.
#pragma once

#include <mote/core/error.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>
#include <mote/eos/concept.hpp>

namespace mote {

/// A heat policy offers update(values, eos, x_old, x_new, work): x = V/V0 before and after the step, and the specific
/// plastic work of the step, J/kg, with energy::Full the viscous work too. `eos` has reference_heating(x), zero with
/// energy::Full, and mote::gamma_over_volume(eos, x). A policy that has `conductivity`, `specific_heat` and `every`
/// besides (their meaning is in heat/conducting.hpp) has its temperature conducted on the grid.
template <class H, class V, class E>
concept HeatFor = HasRole<H, role::Heat> && requires(const H& h, V v, const E& e, typename V::number x) {
  h.update(v, e, x, x, x);
};

}  // namespace mote
