/// \file
/// Material: an equation of state, a strength, a heat and a viscosity as one value.
#pragma once

#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>
#include <mote/eos/concept.hpp>
#include <mote/heat/none.hpp>
#include <mote/strength/none.hpp>
#include <mote/viscosity/none.hpp>

namespace mote {

namespace detail {

/// Stands where an equation of state is missing, so that the prose below is the first error.
struct MissingEos {
  double rho0 = 1;
};

}  // namespace detail

/// A constitutive model, assembled from parts in any order; what is left out costs nothing:
///
///     const mote::Material aluminium{
///         mote::eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
///         mote::strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
///         mote::heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};
///
/// It knows no particles and no grid. A host code calls it on its own state:
///
///     auto state = aluminium.initial<double, 3>();     // Values with the fields that this material needs
///     aluminium.update(state, a);                      // a = dt L, a 3 x 3 increment of the displacement gradient
///     auto sigma = aluminium.stress(state);            // Cauchy stress, Pa, tension positive
///
/// Closure: the energy above the equation of state's reference curve is the specific plastic work (Xu et al.).
template <class Eos, class Strength, class Heat, class Viscosity>
class Material {
  template <class R, class... Parts>
  static constexpr int n = count_of<R, Parts...>;

  template <class V, class T>
  static constexpr bool plastic_for() {
    if constexpr (StrengthFor<Strength, V>)
      return !std::is_void_v<decltype(std::declval<const Strength&>().update(std::declval<V&>(),
                                                                             std::declval<Kinematics<T>>()))>;
    else
      return false;
  }

  using base_fields = union_of<fields<field::VolumeRatio>, particle_fields_of<Eos>, particle_fields_of<Strength>,
                               particle_fields_of<Heat>>;
  using Example = Values<double, 3, base_fields>;

  static_assert(mote::Eos<Eos> || std::is_same_v<Eos, detail::MissingEos>,
                "mote: the equation of state lacks a member; eos/concept.hpp lists them");
  static_assert(StrengthFor<Strength, Example>, "mote: the strength lacks a member; strength/concept.hpp lists them");
  static_assert(HeatFor<Heat, Example, Eos>, "mote: the heat policy lacks a member; heat/concept.hpp lists them");

 public:
  using role = mote::role::Material;

  /// Whether the strength dissipates; then the specific plastic work is stored.
  static constexpr bool plastic = plastic_for<Example, double>();

  using particle_fields = union_of<base_fields, std::conditional_t<plastic, fields<field::PlasticWork>, fields<>>>;

  template <class T, int D = 3>
  using State = Values<T, D, particle_fields>;

  Eos eos;
  [[no_unique_address]] Strength strength;
  [[no_unique_address]] Heat heat;
  [[no_unique_address]] Viscosity viscosity;

  template <class... Parts>
  explicit constexpr Material(const Parts&... parts)
      : eos(detail::pick<mote::role::Eos, Eos>(parts...)),
        strength(detail::pick<mote::role::Strength, Strength>(parts...)),
        heat(detail::pick<mote::role::Heat, Heat>(parts...)),
        viscosity(detail::pick<mote::role::Viscosity, Viscosity>(parts...)) {
    static_assert(n<mote::role::Eos, Parts...> == 1, "mote: a material needs exactly one equation of state");
    static_assert(n<mote::role::Strength, Parts...> <= 1, "mote: a material takes at most one strength");
    static_assert(n<mote::role::Heat, Parts...> <= 1, "mote: a material takes at most one heat policy");
    static_assert(std::is_same_v<Viscosity, mote::viscosity::None>,
                  "mote: no viscosity but viscosity::None is available yet");
    static_assert(
        (has_any_role<Parts, mote::role::Eos, mote::role::Strength, mote::role::Heat, mote::role::Viscosity> && ...),
        "mote: a material takes an equation of state, a strength, a heat policy and a viscosity only");
    const auto check = [](const auto& part) {
      if constexpr (requires { part.validate(); }) part.validate();
    };
    (check(parts), ...);
  }

  friend bool operator==(const Material&, const Material&) requires(
      std::equality_comparable<Eos>&& std::equality_comparable<Strength>&& std::equality_comparable<Heat>&&
          std::equality_comparable<Viscosity>) = default;

  /// Density at rest, kg/m^3.
  double rho0() const { return eos.rho0; }

  /// Sets the material's fields to the unstressed state at rest.
  template <class V>
  void initialise(V& values) const {
    set_initial(values, particle_fields{});
    if constexpr (requires { strength.initialise(values); }) strength.initialise(values);
    if constexpr (requires { heat.initialise(values); }) heat.initialise(values);
  }
  template <class T, int D = 3>
  State<T, D> initial() const {
    State<T, D> values;
    initialise(values);
    return values;
  }

  /// Moves the state over one step. \param a the increment dt L of the displacement gradient (row i: component i of the
  /// velocity; column j: derivative along j), dimensionless.
  template <class V, class T>
  void update(V& values, const Mat<T, 3>& a) const {
    if constexpr (is_pack<T> && scalar_only()) {
      update_by_lane(values, a);
    } else {
      const Kinematics<T> k(a);
      T& x = get<field::VolumeRatio>(values);
      const T x_old = x;
      x = x * k.volume_factor;
      if constexpr (plastic) {
        // per current volume -> per mass, with the mid-step volume
        const T work = strength.update(values, k) * (T(0.5 / eos.rho0) * (x_old + x));
        get<field::PlasticWork>(values) += work;
        heat.update(values, eos, x_old, x, work);
      } else {
        strength.update(values, k);
        heat.update(values, eos, x_old, x, T(0));
      }
    }
  }

  /// Pressure, Pa, positive in compression.
  template <class V>
  auto pressure(const V& values) const {
    using T = typename V::number;
    T p = eos.pressure(get<field::VolumeRatio>(values), excess_energy(values));
    if constexpr (requires { strength.stress(values); }) p -= T(1.0 / 3) * trace(strength.stress(values));
    return p;
  }

  /// Cauchy stress, Pa, tension positive.
  template <class V>
  SymTensor<typename V::number> stress(const V& values) const {
    using T = typename V::number;
    const T p = pressure(values);
    if constexpr (requires { strength.stress(values); })
      return add_diagonal(deviator(strength.stress(values)), T(-p));
    else if constexpr (carries<V, field::DeviatoricStress>)
      return add_diagonal(get<field::DeviatoricStress>(values), T(-p));
    else
      return {{-p, -p, -p, T(0), T(0), T(0)}};
  }

  /// Square of the longitudinal sound speed, m^2/s^2: c_bulk^2 + 4 G/(3 rho), or what the strength makes of c_bulk^2.
  template <class V>
  auto sound_speed2(const V& values) const {
    using T = typename V::number;
    const T x = get<field::VolumeRatio>(values);
    T c2 = eos.bulk_sound_speed2(x, excess_energy(values));
    if constexpr (requires { strength.wave_modulus(values, x); })
      c2 = strength.wave_modulus(values, T(eos.rho0) * c2) * T(1 / eos.rho0);
    else if constexpr (requires { strength.shear_modulus; })
      c2 += T(4.0 / 3 * strength.shear_modulus / eos.rho0) * x;
    return c2;
  }

  /// Recoverable specific energy, J/kg: the work along the reference curve and the elastic shear |s|^2/(4 G rho), or
  /// what the strength says for the latter.
  template <class V>
  auto elastic_energy(const V& values) const {
    using T = typename V::number;
    const T x = get<field::VolumeRatio>(values);
    T e = eos.reference_energy(x);
    if constexpr (requires { strength.elastic_energy(values); }) {
      e += strength.elastic_energy(values) * T(1 / eos.rho0);
    } else if constexpr (carries<V, field::DeviatoricStress> && requires { strength.shear_modulus; }) {
      const auto& s = get<field::DeviatoricStress>(values);
      e += T(0.25 / (strength.shear_modulus * eos.rho0)) * x * ddot(s, s);
    }
    return e;
  }

  /// Whether the equation of state covers the state (per lane for packs).
  template <class V>
  auto admissible(const V& values) const {
    return eos.admissible(get<field::VolumeRatio>(values));
  }

 private:
  static constexpr bool scalar_only() {
    if constexpr (requires { Strength::scalar_only; })
      return Strength::scalar_only;
    else
      return false;
  }

  template <class V>
  static auto excess_energy(const V& values) {
    using T = typename V::number;
    if constexpr (carries<V, field::PlasticWork>)
      return get<field::PlasticWork>(values);
    else
      return T(0);
  }

  template <class V, class... Tags>
  static void set_initial(V& values, fields<Tags...>) {
    using T = typename V::number;
    const auto set = [&]<class Tag>(Tag) {
      double first = 0;
      if constexpr (requires { Tag::initial; }) first = Tag::initial;
      for (int i = 0; i < count<Tag, V::dimension>(); ++i) component<Tag>(get<Tag>(values), i) = T(first);
    };
    (set(Tags{}), ...);
  }

  template <class V, class T>
  void update_by_lane(V& values, const Mat<T, 3>& a) const {
    using S = Scalar<T>;
    for (int l = 0; l < lanes; ++l) {
      Values<S, V::dimension, particle_fields> one;
      copy_lane<V::dimension>(one, values, l, particle_fields{});
      Mat<S, 3> b{};
      for (int i = 0; i < 9; ++i) b.c[i] = lane(a.c[i], l);
      update(one, b);
      copy_back<V::dimension>(values, one, l, particle_fields{});
    }
  }
  template <int D, class To, class From, class... Tags>
  static void copy_lane(To& to, const From& from, int l, fields<Tags...>) {
    const auto copy = [&]<class Tag>(Tag) {
      for (int i = 0; i < count<Tag, D>(); ++i)
        component<Tag>(get<Tag>(to), i) = lane(component<Tag>(get<Tag>(from), i), l);
    };
    (copy(Tags{}), ...);
  }
  template <int D, class To, class From, class... Tags>
  static void copy_back(To& to, const From& from, int l, fields<Tags...>) {
    const auto copy = [&]<class Tag>(Tag) {
      for (int i = 0; i < count<Tag, D>(); ++i)
        component<Tag>(get<Tag>(to), i).set(l, component<Tag>(get<Tag>(from), i));
    };
    (copy(Tags{}), ...);
  }
  /// How many numbers the value of a field holds in registers.
  template <class Tag, int D>
  static constexpr int count() {
    return std::is_same_v<typename Tag::shape, shape_of::Symmetric> ? 6 : Tag::shape::template components<D>;
  }
};

template <class... Parts>
Material(const Parts&...) -> Material<typename detail::FirstOf<role::Eos, detail::MissingEos, Parts...>::type,
                                      typename detail::FirstOf<role::Strength, strength::None, Parts...>::type,
                                      typename detail::FirstOf<role::Heat, heat::None, Parts...>::type,
                                      typename detail::FirstOf<role::Viscosity, viscosity::None, Parts...>::type>;

}  // namespace mote
