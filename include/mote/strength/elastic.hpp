/// \file
/// Elastic shear.
#pragma once

#include <mote/strength/concept.hpp>

namespace mote::strength {

/// Hypoelastic shear, s' = 2 G dev(D) in the Jaumann rate. Needs field::DeviatoricStress.
struct Elastic {
  using role = mote::role::Strength;
  using particle_fields = fields<field::DeviatoricStress>;

  double shear_modulus;  ///< G, Pa, > 0

  void validate() const { require(shear_modulus > 0, "the shear modulus is ", shear_modulus, " Pa; it must be > 0"); }

  template <class V, class T>
  void update(V& values, const Kinematics<T>& k) const {
    get<field::DeviatoricStress>(values) = elastic_predictor(values, k, shear_modulus);
  }

  friend bool operator==(const Elastic&, const Elastic&) = default;
};

}  // namespace mote::strength
