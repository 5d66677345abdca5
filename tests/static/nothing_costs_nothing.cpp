// "Nothing" is an empty type, takes no room, and naming it is the same as leaving it out.
#include <mote/mote.hpp>

#include <type_traits>

namespace {

using namespace mote;

template <class A, class B>
inline constexpr bool same = std::is_same_v<std::remove_cv_t<A>, std::remove_cv_t<B>>;

static_assert(std::is_empty_v<strength::None>);
static_assert(std::is_empty_v<heat::None>);
static_assert(std::is_empty_v<viscosity::None>);
static_assert(std::is_empty_v<energy::Plastic> && std::is_empty_v<energy::Full>);
static_assert(std::is_empty_v<sleep::Never>);
static_assert(std::is_empty_v<execution::Serial>);

// they declare no fields
static_assert(same<particle_fields_of<strength::None>, fields<>>);
static_assert(same<particle_fields_of<heat::None>, fields<>>);
static_assert(same<particle_fields_of<transfer::Flip>, fields<>>);

constexpr eos::LinearBulk bulk{.rho0 = 1000, .bulk_modulus = 2e9};
constexpr eos::MieGruneisen hugoniot{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96};
constexpr strength::Elastic elastic{.shear_modulus = 26e9};
constexpr strength::VonMises plastic{.shear_modulus = 26e9, .yield = 120e6};
constexpr heat::Adiabatic heating{.specific_heat = 880};

// a material is as large as the parts that are something
static_assert(sizeof(Material{bulk}) == sizeof bulk);
static_assert(sizeof(Material{hugoniot}) == sizeof hugoniot);
static_assert(sizeof(Material{hugoniot, elastic}) == sizeof hugoniot + sizeof elastic);
static_assert(sizeof(Material{hugoniot, plastic, heating}) == sizeof hugoniot + sizeof plastic + sizeof heating);

// naming nothing is leaving it out
static_assert(
    same<decltype(Material{bulk}), decltype(Material{bulk, strength::None{}, heat::None{}, viscosity::None{}})>);
static_assert(same<decltype(Material{hugoniot, plastic}), decltype(Material{energy::Plastic{}, hugoniot, plastic})>);
static_assert(same<decltype(Material{hugoniot, plastic}), decltype(Material{hugoniot, plastic, heat::None{}})>);

// order does not matter, a copy is a copy
static_assert(same<decltype(Material{hugoniot, plastic, heating}), decltype(Material{heating, hugoniot, plastic})>);
static_assert(same<decltype(Material{hugoniot, plastic, heating}), decltype(Material{plastic, heating, hugoniot})>);
static_assert(same<decltype(Material{Material{hugoniot, plastic}}), decltype(Material{hugoniot, plastic})>);

// no plastic work where nothing is dissipated, no temperature in a cold scene
static_assert(!decltype(Material{bulk})::plastic && !decltype(Material{bulk, elastic})::plastic);
static_assert(decltype(Material{bulk, plastic})::plastic);
static_assert(same<decltype(Material{bulk})::particle_fields, fields<field::VolumeRatio>>);
static_assert(
    same<decltype(Material{bulk, elastic})::particle_fields, fields<field::VolumeRatio, field::DeviatoricStress>>);
static_assert(same<decltype(Material{bulk, plastic})::particle_fields,
                   fields<field::VolumeRatio, field::DeviatoricStress, field::PlasticStrain, field::PlasticWork>>);
static_assert(contains<decltype(Material{bulk, heating})::particle_fields, field::Temperature>);
static_assert(sizeof(decltype(Material{bulk})::State<double>) == sizeof(double));

// the same for the solver
using Left = decltype(Solver{grid::Cartesian<3>{}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{},
                             Material{bulk, elastic}});
using Named = decltype(Solver{grid::Cartesian<3>{}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{}, update::Usl{},
                              execution::Serial{}, sleep::Never{}, Material{bulk, elastic, heat::None{}}});
using Turned = decltype(Solver{Material{heat::None{}, elastic, bulk}, timestep::Cfl{}, transfer::Flip{},
                               shape::Linear{}, grid::Cartesian<3>{}});
static_assert(same<Left, Named>);
static_assert(same<Left, Turned>);
static_assert(!same<Left, decltype(Solver{grid::Cartesian<3>{}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{},
                                          Material{bulk, elastic, heating}})>);

// where nobody sleeps nothing is stored for it, per solver, tile or particle
using Sleepless = passes::Sleeper<sleep::Never, double, 3>;
using Asleep = decltype(Solver{grid::Cartesian<3>{}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{},
                               sleep::Quiescent{}, Material{bulk, elastic}});
static_assert(std::is_empty_v<Sleepless>);
static_assert(sizeof(passes::Tile<3>) == 48);
static_assert(sizeof(Left) + sizeof(passes::Sleeper<sleep::Quiescent, double, 3>) == sizeof(Asleep));
static_assert(Left::bytes_per_particle<> == Asleep::bytes_per_particle<>);

// dimension and number type follow from the grid
static_assert(Left::dimension == 3 && same<Left::number, double>);
using Flat = decltype(Solver{grid::Cartesian<2, float>{}, shape::Linear{}, transfer::Flip{}, timestep::Cfl{},
                             Material{bulk}});
static_assert(Flat::dimension == 2 && same<Flat::number, float>);

}  // namespace
