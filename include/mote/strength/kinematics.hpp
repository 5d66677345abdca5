/// \file
/// The increment of motion that a strength policy receives.
#pragma once

#include <mote/core/tensor.hpp>

namespace mote {

/// One step's motion of a particle: rotation and strain, from the increment A = dt L of the displacement gradient.
///
/// G = A (I + A/2)^-1 is the gradient with respect to the mid-point configuration; `strain` is its symmetric part and
/// `rotation` the Cayley transform (I - w/2)^-1 (I + w/2) of its skew part w, so that a rigid rotation A = Q - I gives
/// strain = 0 and rotation = Q exactly. Source: Hughes and Winget, IJNME 15 (1980) 1862.
template <class T>
struct Kinematics {
  Mat<T, 3> rotation;   ///< orthogonal
  SymTensor<T> strain;  ///< mid-point strain increment, in the unrotated mid-point frame
  T volume_factor;      ///< J_new / J_old = det(I + A)
  Mat<T, 3> increment;  ///< A itself: F_new = (I + A) F_old

  // inlined, so that who does not read the increment does not copy it
  [[gnu::always_inline]] explicit Kinematics(const Mat<T, 3>& a) : increment(a) {
    const Mat<T, 3> eye = Mat<T, 3>::identity();
    volume_factor = det(eye + a);
    const Mat<T, 3> g = a * inverse(eye + T(0.5) * a);
    strain = sym(g);
    // half the axial vector of w
    const Vec<T, 3> t{T(0.25) * (g(2, 1) - g(1, 2)), T(0.25) * (g(0, 2) - g(2, 0)), T(0.25) * (g(1, 0) - g(0, 1))};
    const T tt = dot(t, t), s = T(2) / (T(1) + tt);
    // I + s (t^ + t^ t^),  t^ t^ = t t^T - (t.t) I
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) rotation(i, j) = s * t[i] * t[j];
    for (int i = 0; i < 3; ++i) {
      rotation(i, i) += T(1) - s * tt;
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      rotation(k, j) += s * t[i];
      rotation(j, k) -= s * t[i];
    }
  }
};

}  // namespace mote
