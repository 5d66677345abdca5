/// \file
/// What a shape function offers: a one-dimensional kernel; the solver takes tensor products of it.
#pragma once

#include <concepts>

#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>

namespace mote {

/// Whether a kernel depends on the particle's own size: it declares field::HalfSize.
template <class S>
inline constexpr bool sized = contains<particle_fields_of<S>, field::HalfSize>;

namespace detail {
/// Whether S has weights and slopes, from a place and, if it wants one, a half size.
template <class S, class... Half>
concept HasWeights = requires(double f, Half... half, double* out) {
  S::values(f, half..., out);
  S::slopes(f, half..., out);
};
}  // namespace detail

/// With xi = (x - origin)/h, lowest node b = floor(xi - S::first) and f = xi - b in [first, first + 1):
///
/// S::support             nodes per axis that a particle touches
/// S::first               offset of the lowest node, see above
/// S::inertia             sum_i w_i (i - f)^2 where it does not depend on f, else 0 (D = inertia h^2 of APIC)
/// S::values(f, w)        w[i], i < support: the kernel at node b + i
/// S::slopes(f, d)        d[i] = d w[i]/d xi
///
/// A kernel that depends on the particle's size declares `particle_fields = fields<field::HalfSize>` and takes the half
/// size in cells, S::values(f, half, w) and S::slopes(f, half, d). One whose size follows the motion has
/// S::deform(values, a) too, which moves field::HalfSize with the increment a = dt L.
///
/// The weights sum to one and reproduce linear functions, sum_i w_i (i - f) = 0: the scatter gives the middle node of
/// three or more what the others leave, so its weight must not be small where the sum is not.
template <class S>
concept Shape = HasRole<S, role::Shape> && requires {
  { S::support } -> std::convertible_to<int>;
  { S::first } -> std::convertible_to<double>;
  { S::inertia } -> std::convertible_to<double>;
}
&&(sized<S> ? detail::HasWeights<S, double> : detail::HasWeights<S>);

}  // namespace mote
