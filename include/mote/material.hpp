/// \file
/// Material: an equation of state, a strength, a heat, a viscosity and an energy closure as one value.
#pragma once

#include <mote/core/by_lane.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>
#include <mote/core/role.hpp>
#include <mote/energy/plastic.hpp>
#include <mote/eos/concept.hpp>
#include <mote/heat/none.hpp>
#include <mote/strength/none.hpp>
#include <mote/viscosity/concept.hpp>
#include <mote/viscosity/none.hpp>

namespace mote {

namespace detail {

/// Stands where an equation of state is missing, so that the prose below is the first error.
struct MissingEos {
  double rho0 = 1;
};

/// The equation of state as a heat policy sees it where the heat of a shock comes from work, not from the curve.
template <class Eos>
struct WithoutReferenceHeating {
  const Eos& eos;

  template <class T>
  T reference_heating(const T&) const {
    return T(0);
  }
  template <class T>
  T gamma_over_volume(const T& x) const {
    return mote::gamma_over_volume(eos, x);
  }
};

}  // namespace detail

/// What a viscosity needs to know of a step.
struct Step {
  double dt;       ///< s, > 0
  double spacing;  ///< of the grid, m
};

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
/// Closure: by default the energy above the equation of state's reference curve is the specific plastic work (Xu et
/// al.); energy::Full is the complete energy equation.
template <class Eos, class Strength, class Heat, class Viscosity, class Energy = mote::energy::Plastic>
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
                               particle_fields_of<Heat>, particle_fields_of<Energy>>;
  using Example = Values<double, 3, base_fields>;

  static_assert(mote::Eos<Eos> || std::is_same_v<Eos, detail::MissingEos>,
                "mote: the equation of state lacks a member; eos/concept.hpp lists them");
  static_assert(StrengthFor<Strength, Example>, "mote: the strength lacks a member; strength/concept.hpp lists them");
  static_assert(HeatFor<Heat, Example, Eos>, "mote: the heat policy lacks a member; heat/concept.hpp lists them");
  static_assert(std::is_same_v<Viscosity, mote::viscosity::None> || mote::Viscosity<Viscosity>,
                "mote: the viscosity lacks a member; viscosity/concept.hpp lists them");
  static_assert(EnergyFor<Energy, Example, Eos>,
                "mote: the energy closure lacks a member; energy/concept.hpp lists them");
  static_assert(!Energy::complete || HasInternalEnergy<Eos> || std::is_same_v<Eos, detail::MissingEos>,
                "mote: the complete energy equation needs an equation of state with internal_energy(x)");

 public:
  using role = mote::role::Material;

  /// Whether the strength dissipates; then the specific plastic work is stored.
  static constexpr bool plastic = plastic_for<Example, double>();

  /// Whether there is a shock viscosity; then it and its specific work are stored.
  static constexpr bool viscous = !std::is_same_v<Viscosity, mote::viscosity::None>;

  using particle_fields =
      union_of<base_fields, std::conditional_t<plastic, fields<field::PlasticWork>, fields<>>,
               std::conditional_t<viscous, fields<field::ViscousPressure, field::ViscousWork>, fields<>>>;

  template <class T, int D = 3>
  using State = Values<T, D, particle_fields>;

  Eos eos;
  [[no_unique_address]] Strength strength;
  [[no_unique_address]] Heat heat;
  [[no_unique_address]] Viscosity viscosity;
  [[no_unique_address]] Energy energy;

  template <class... Parts>
  explicit constexpr Material(const Parts&... parts)
      : eos(detail::pick<mote::role::Eos, Eos>(parts...)),
        strength(detail::pick<mote::role::Strength, Strength>(parts...)),
        heat(detail::pick<mote::role::Heat, Heat>(parts...)),
        viscosity(detail::pick<mote::role::Viscosity, Viscosity>(parts...)),
        energy(detail::pick<mote::role::Energy, Energy>(parts...)) {
    static_assert(n<mote::role::Eos, Parts...> == 1, "mote: a material needs exactly one equation of state");
    static_assert(n<mote::role::Strength, Parts...> <= 1, "mote: a material takes at most one strength");
    static_assert(n<mote::role::Heat, Parts...> <= 1, "mote: a material takes at most one heat policy");
    static_assert(n<mote::role::Viscosity, Parts...> <= 1, "mote: a material takes at most one viscosity");
    static_assert(n<mote::role::Energy, Parts...> <= 1, "mote: a material takes at most one energy closure");
    static_assert((has_any_role<Parts, mote::role::Eos, mote::role::Strength, mote::role::Heat, mote::role::Viscosity,
                                mote::role::Energy> &&
                   ...),
                  "mote: a material takes an equation of state, a strength, a heat policy, a viscosity and an energy "
                  "closure only");
    const auto check = [](const auto& part) {
      if constexpr (requires { part.validate(); }) part.validate();
    };
    (check(parts), ...);
  }

  friend bool operator==(const Material&, const Material&) requires(
      std::equality_comparable<Eos>&& std::equality_comparable<Strength>&& std::equality_comparable<Heat>&&
          std::equality_comparable<Viscosity>&& std::equality_comparable<Energy>) = default;

  /// Density at rest, kg/m^3.
  double rho0() const { return eos.rho0; }

  /// Sets the material's fields to the unstressed state at rest.
  template <class V>
  void initialise(V& values) const {
    set_initial(values, particle_fields{});
    if constexpr (requires { strength.initialise(values); }) strength.initialise(values);
    if constexpr (requires { heat.initialise(values); }) heat.initialise(values);
    if constexpr (requires { energy.initialise(values, eos); }) energy.initialise(values, eos);
  }
  template <class T, int D = 3>
  State<T, D> initial() const {
    State<T, D> values;
    initialise(values);
    return values;
  }

  /// Moves the state over one step. \param a the increment dt L of the displacement gradient (row i: component i of the
  /// velocity; column j: derivative along j), dimensionless.
  /// \param step its length and the grid spacing; only a viscosity looks at them
  template <class V, class T>
  void update(V& values, const Mat<T, 3>& a, const Step& step) const {
    if constexpr (is_pack<T> && scalar_only()) {
      update_by_lane(values, a, step);
    } else {
      const Kinematics<T> k(a);
      T& x = get<field::VolumeRatio>(values);
      const T x_old = x;
      T viscous_work(0);
      if constexpr (viscous) viscous_work = update_viscosity(values, k, step);
      x = x * k.volume_factor;
      if constexpr (plastic) {
        // per current volume -> per mass, with the mid-step volume
        const T work = strength.update(values, k) * (T(0.5 / eos.rho0) * (x_old + x));
        get<field::PlasticWork>(values) += work;
        update_energy(values, x_old, x, work, viscous_work);
      } else {
        strength.update(values, k);
        update_energy(values, x_old, x, T(0), viscous_work);
      }
    }
  }
  /// The same for a material without viscosity.
  template <class V, class T>
  void update(V& values, const Mat<T, 3>& a) const {
    static_assert(!viscous && sizeof(V) > 0,
                  "mote: a material with a viscosity needs to know the step: update(values, a, {.dt = ..., .spacing = "
                  "...})");
    update(values, a, Step{1, 1});
  }

  /// Pressure, Pa, positive in compression, without the shock viscosity.
  template <class V>
  auto pressure(const V& values) const {
    using T = typename V::number;
    T p = eos.pressure(get<field::VolumeRatio>(values), energy.excess(values, eos));
    if constexpr (requires { strength.stress(values); }) p -= T(1.0 / 3) * trace(strength.stress(values));
    return p;
  }

  /// Cauchy stress, Pa, tension positive, with the shock viscosity.
  template <class V>
  SymTensor<typename V::number> stress(const V& values) const {
    using T = typename V::number;
    T p = pressure(values);
    if constexpr (viscous) p += get<field::ViscousPressure>(values);
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
    T c2 = energy.bulk_sound_speed2(values, eos);
    if constexpr (requires { strength.wave_modulus(values, x); })
      c2 = strength.wave_modulus(values, T(eos.rho0) * c2) * T(1 / eos.rho0);
    else if constexpr (requires { strength.shear_modulus; })
      c2 += T(4.0 / 3 * strength.shear_modulus / eos.rho0) * x;
    return c2;
  }

  /// Square of the speed that the time step has to allow for, m^2/s^2: of sound, or more with a viscosity.
  template <class V>
  auto signal_speed2(const V& values) const {
    const auto c2 = sound_speed2(values);
    if constexpr (viscous)
      return viscosity.signal_speed2(density(values), c2, get<field::ViscousPressure>(values));
    else
      return c2;
  }

  /// Recoverable specific energy, J/kg: what the pressure took up (energy/concept.hpp; by default the work along the
  /// reference curve) and the elastic shear |s|^2/(4 G rho), or what the strength says for the latter.
  template <class V>
  auto elastic_energy(const V& values) const {
    using T = typename V::number;
    const T x = get<field::VolumeRatio>(values);
    T e = energy.pressure_work(values, eos);
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
  auto density(const V& values) const {
    using T = typename V::number;
    return T(T(eos.rho0) / get<field::VolumeRatio>(values));
  }

  /// q with the density and the sound speed at the beginning of the step. \return its work, J/kg
  ///
  /// The mean of the old and the new q: a step's force has the old one, and its velocity, that of the end of the step,
  /// is half this step's and half the next one's. So the work can be negative in the step in which compression ends.
  template <class V, class T>
  T update_viscosity(V& values, const Kinematics<T>& k, const Step& step) const {
    using std::sqrt;
    T& q = get<field::ViscousPressure>(values);
    const T q_old = q, closing = T(-step.spacing / step.dt) * trace(k.strain);
    q = viscosity.pressure(density(values), T(sqrt(sound_speed2(values))), closing);
    const T dv = T(1 / eos.rho0) * get<field::VolumeRatio>(values) * (k.volume_factor - T(1));
    const T work = T(-0.5) * (q_old + q) * dv;
    get<field::ViscousWork>(values) += work;
    return work;
  }

  template <class V, class T>
  void update_energy(V& values, const T& x_old, const T& x, const T& plastic_work, const T& viscous_work) const {
    if constexpr (Energy::complete) {
      const T work = plastic_work + viscous_work;
      energy.update(values, eos, x_old, x, work);
      heat.update(values, detail::WithoutReferenceHeating<Eos>{eos}, x_old, x, work);
    } else {
      energy.update(values, eos, x_old, x, plastic_work);
      heat.update(values, eos, x_old, x, plastic_work);
    }
  }

  template <class V, class T>
  void update_by_lane(V& values, const Mat<T, 3>& a, const Step& step) const {
    for_each_lane(values, particle_fields{}, [&](auto& one, int l) {
      Mat<Scalar<T>, 3> b{};
      for (int i = 0; i < 9; ++i) b.c[i] = lane(a.c[i], l);
      update(one, b, step);
    });
  }
};

template <class... Parts>
Material(const Parts&...) -> Material<typename detail::FirstOf<role::Eos, detail::MissingEos, Parts...>::type,
                                      typename detail::FirstOf<role::Strength, strength::None, Parts...>::type,
                                      typename detail::FirstOf<role::Heat, heat::None, Parts...>::type,
                                      typename detail::FirstOf<role::Viscosity, viscosity::None, Parts...>::type,
                                      typename detail::FirstOf<role::Energy, energy::Plastic, Parts...>::type>;

}  // namespace mote
