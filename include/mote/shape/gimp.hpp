/// \file
/// GIMP: hat functions averaged over the particle's own domain.
#pragma once

#include <algorithm>

#include <mote/shape/concept.hpp>

namespace mote::shape {

/// GIMP with domains of constant size ("uniform"): w_i is the mean of the hat of node i over [x - l, x + l], with a
/// half size l per axis, field::HalfSize. fill() sets it to half a particle distance, spacing / (2 per_axis); it stays
/// that.
///
/// With l <= h/2 a domain lies in two cells at most, so three nodes per axis suffice, those of the quadratic B-spline.
/// l = h/2 (per_axis = 1) is the quadratic B-spline, l -> 0 the linear hat. The gradient is continuous, its slope at
/// most 1/(l h): the smaller l, the nearer to the cell-crossing noise of hats, and (grad w)^2/w <= 1/(l h).
///
/// Outside [1e-6 h, h/2] the kernel takes the nearer end; the column keeps what it holds. That is met by
/// ContiguousGimp in strong tension: beyond h/2 (a stretch of `per_axis`) domains leave gaps between each other.
/// Weights still sum to one and reproduce linear functions, but nodes between two particles may be left without mass:
/// the body tears where the mesh says so (numerical fracture), as with B-splines.
///
/// With transfer::Apic the inertia depends on place and size, so C = sum v (x) grad w as with hats; angular momentum is
/// then not conserved to round-off. Source: Bardenhagen, Kober, CMES 5 (2004) 477.
struct Gimp {
  using role = mote::role::Shape;
  using particle_fields = fields<field::HalfSize>;
  static constexpr int support = 3;
  static constexpr double first = 0.5;
  static constexpr double inertia = 0;

  /// \param half the half size l in cells
  template <class T>
  static void values(const T& f, const T& half, T* w) {
    using std::max;
    // The hat of node 0 is 1 - x below the middle node and 0 above it. Its integral over the part `below` of the
    // domain's length is that part times the hat's mean there: g if all is below, else half of its length, below l.
    const Split<T> s(f, half);
    w[0] = s.below * max(s.g, T(s.below * s.l));
    w[2] = s.above * max(T(-s.g), T(s.above * s.l));
    w[1] = T(1) - w[0] - w[2];
  }
  template <class T>
  static void slopes(const T& f, const T& half, T* d) {
    const Split<T> s(f, half);
    d[0] = -s.below;
    d[1] = s.below - s.above;
    d[2] = s.above;
  }

 private:
  /// How the middle node divides the domain.
  template <class T>
  struct Split {
    T l, g;          ///< half size; from the particle to the middle node
    T below, above;  ///< parts of the domain

    Split(const T& f, const T& half) {
      using std::max, std::min;
      l = max(T(1e-6), min(T(0.5), half));
      g = T(1) - f;
      below = max(T(0), min(T(1), T(T(0.5) + T(0.5) * g / l)));
      above = T(1) - below;
    }
  };
};

/// GIMP with domains that follow the deformation ("contiguous particle"), so that neighbours' domains keep touching:
/// along each axis l <- l (1 + dt L_aa), the stretch along that axis. In motion along the axes l = l0 F_aa, and the
/// product of the half sizes follows the volume. A domain stays a box with sides along the axes: shear does not slant
/// it, and a rigid spin leaves it as it is (F_aa itself would shrink it to nothing at a quarter turn).
///
/// See Gimp for the kernel and its limits. Sources: Bardenhagen, Kober, CMES 5 (2004) 477; Wallstedt, Guilkey,
/// J. Comput. Phys. 227 (2008) 9628.
struct ContiguousGimp : Gimp {
  /// \param a the increment dt L of the displacement gradient
  template <class V, class T, int D>
  static void deform(V& values, const Mat<T, D>& a) {
    auto& half = get<field::HalfSize>(values);
    for (int i = 0; i < D; ++i) half[i] = half[i] * (T(1) + a(i, i));
  }
};

}  // namespace mote::shape
