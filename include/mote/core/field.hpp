/// \file
/// Fields: what a particle carries, each a tag with a name, a unit and a shape; and Values, the fields of one particle
/// (or of one pack of particles) in registers.
///
/// A part lists the fields that it reads and writes (`using particle_fields = fields<field::PlasticStrain>;`). Particle
/// storage holds the union over all parts and nothing else. Your own field is a struct like those below.
#pragma once

#include <cstdint>
#include <type_traits>

#include <mote/core/tensor.hpp>

namespace mote {

/// Shapes: how many numbers a field has in D dimensions, and the value that policies see.
namespace shape_of {
struct Scalar {
  template <int D>
  static constexpr int components = 1;
  template <class T, int D>
  using value = T;
};
struct Vector {
  template <int D>
  static constexpr int components = D;
  template <class T, int D>
  using value = Vec<T, D>;
};
struct Matrix {
  template <int D>
  static constexpr int components = D* D;
  template <class T, int D>
  using value = Mat<T, D>;
};
/// Symmetric tensor; in plane strain xx, yy, zz, xy are stored, in uniaxial strain xx, yy, zz. Values are always full.
struct Symmetric {
  template <int D>
  static constexpr int components = D == 1 ? 3 : (D == 2 ? 4 : 6);
  template <class T, int D>
  using value = SymTensor<T>;
};
}  // namespace shape_of

namespace field {

/// Where the particle is, m. Between sorts it may lie a few cells beyond a periodic boundary.
struct Position {
  using shape = shape_of::Vector;
  static constexpr const char *name = "position", *unit = "m";
};
struct Velocity {
  using shape = shape_of::Vector;
  static constexpr const char *name = "velocity", *unit = "m/s";
};
/// Mass, kg (kg/m in two dimensions, kg/m^2 in one).
struct Mass {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "mass", *unit = "kg";
};
/// The particle's number, from 0 in the order of filling; it never changes.
struct Id {
  using shape = shape_of::Scalar;
  using stored = std::uint32_t;
  static constexpr const char *name = "id", *unit = "1";
};
/// The affine velocity matrix C of APIC and affine FLIP: the velocity near the particle is v + C (x - x_p).
struct Affine {
  using shape = shape_of::Matrix;
  static constexpr const char *name = "affine", *unit = "1/s";
};
/// Half the edges of the box that a particle stands for, along the axes (GIMP).
struct HalfSize {
  using shape = shape_of::Vector;
  static constexpr const char *name = "half_size", *unit = "m";
};
/// J = V/V0, the current over the initial volume.
struct VolumeRatio {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "volume_ratio", *unit = "1";
  static constexpr double initial = 1;
};
/// The deviatoric stress s, tension positive.
struct DeviatoricStress {
  using shape = shape_of::Symmetric;
  static constexpr const char *name = "deviatoric_stress", *unit = "Pa";
};
/// The back stress alpha of kinematic hardening, the centre of the yield surface; a deviator, tension positive.
struct BackStress {
  using shape = shape_of::Symmetric;
  static constexpr const char *name = "back_stress", *unit = "Pa";
};
/// The left Cauchy-Green tensor b = F F^T, the identity at rest (a policy that declares it sets it so in `initialise`).
struct LeftCauchyGreen {
  using shape = shape_of::Symmetric;
  static constexpr const char *name = "left_cauchy_green", *unit = "1";
};
/// Equivalent plastic strain, int sqrt(2/3) |de_p|.
struct PlasticStrain {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "plastic_strain", *unit = "1";
};
/// Specific plastic work, J/kg.
struct PlasticWork {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "plastic_work", *unit = "J/kg";
};
/// Specific internal energy without the elastic shear energy, J/kg.
struct InternalEnergy {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "internal_energy", *unit = "J/kg";
};
/// Shock viscosity q of the last step, Pa, positive in compression.
struct ViscousPressure {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "viscous_pressure", *unit = "Pa";
};
/// Specific work that the shock viscosity has dissipated, J/kg.
struct ViscousWork {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "viscous_work", *unit = "J/kg";
};
struct Temperature {
  using shape = shape_of::Scalar;
  static constexpr const char *name = "temperature", *unit = "K";
};

}  // namespace field

/// A list of field tags.
template <class... Tags>
struct fields {
  static constexpr int size = int(sizeof...(Tags));
};

namespace detail {

template <class List, class... Tags>
struct Append {
  using type = List;
};
template <class... Known, class Tag, class... Rest>
struct Append<fields<Known...>, Tag, Rest...>
    : std::conditional_t<(std::is_same_v<Known, Tag> || ...), Append<fields<Known...>, Rest...>,
                         Append<fields<Known..., Tag>, Rest...>> {};

template <class... Lists>
struct Union {
  using type = fields<>;
};
template <class... Tags>
struct Union<fields<Tags...>> : Append<fields<>, Tags...> {};
template <class... Tags, class... More, class... Lists>
struct Union<fields<Tags...>, fields<More...>, Lists...>
    : Union<typename Append<fields<>, Tags..., More...>::type, Lists...> {};

template <class P>
struct ParticleFieldsOf {
  using type = fields<>;
};
template <class P>
requires requires { typename P::particle_fields; }
struct ParticleFieldsOf<P> {
  using type = typename P::particle_fields;
};

template <class T, class Tag, int D>
struct Slot {
  typename Tag::shape::template value<T, D> value;
};

}  // namespace detail

/// The union of field lists, each tag once, in the order of first mention.
template <class... Lists>
using union_of = typename detail::Union<Lists...>::type;

/// The fields that a part declares, or none.
template <class P>
using particle_fields_of = typename detail::ParticleFieldsOf<P>::type;

template <class List, class Tag>
inline constexpr bool contains = false;
template <class... Tags, class Tag>
inline constexpr bool contains<fields<Tags...>, Tag> = (std::is_same_v<Tags, Tag> || ...);

/// The values of some fields of one particle (T a number) or of a pack of particles (T a Pack).
///
/// Read and write one with get<field::Velocity>(values).
template <class T, int D, class List>
struct Values;
template <class T, int D, class... Tags>
struct Values<T, D, fields<Tags...>> : detail::Slot<T, Tags, D>... {
  using number = T;
  static constexpr int dimension = D;
  using list = fields<Tags...>;
};

template <class Tag, class T, int D>
constexpr auto& get(detail::Slot<T, Tag, D>& slot) {
  return slot.value;
}
template <class Tag, class T, int D>
constexpr const auto& get(const detail::Slot<T, Tag, D>& slot) {
  return slot.value;
}

/// Whether a Values type carries a field.
template <class V, class Tag>
inline constexpr bool carries = contains<typename std::remove_cvref_t<V>::list, Tag>;

/// Copies the listed fields from one set of values to another.
template <class To, class From, class... Tags>
constexpr void set_fields(To& to, const From& from, fields<Tags...>) {
  ((get<Tags>(to) = get<Tags>(from)), ...);
}

/// The numbers of a field's value one after the other, as they are stored.
template <class Tag, class Value>
constexpr auto& component(Value& value, int i) {
  if constexpr (std::is_same_v<typename Tag::shape, shape_of::Scalar>)
    return value;
  else
    return value.c[i];
}

/// How many numbers the value of a field holds in registers.
template <class Tag, int D>
inline constexpr int components_of_value =
    std::is_same_v<typename Tag::shape, shape_of::Symmetric> ? 6 : Tag::shape::template components<D>;

/// Sets fields to their tags' `initial`, or to zero.
template <class V, class... Tags>
void set_initial(V& values, fields<Tags...>) {
  using T = typename V::number;
  const auto set = [&]<class Tag>(Tag) {
    double first = 0;
    if constexpr (requires { Tag::initial; }) first = Tag::initial;
    for (int i = 0; i < components_of_value<Tag, V::dimension>; ++i) component<Tag>(get<Tag>(values), i) = T(first);
  };
  (set(Tags{}), ...);
}

}  // namespace mote
