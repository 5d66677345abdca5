// What a particle takes in memory: exactly the columns that the scene's parts declare.
#include <mote/mote.hpp>

namespace {

using namespace mote;

const Material aluminium{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350},
                         strength::VonMises{.shear_modulus = 26e9, .yield = 1e8},
                         heat::Adiabatic{.specific_heat = 880}};
const Material cold_elastic{eos::LinearBulk{.rho0 = 2700, .bulk_modulus = 77e9},
                            strength::Elastic{.shear_modulus = 26e9}};
const Material water{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2.2e9}};

template <class Grid, class Shape, class Transfer, class M>
auto scene(Grid, Shape, Transfer, M)
    -> decltype(Solver{Grid{}, Shape{}, Transfer{}, timestep::Cfl{}, std::declval<M>()});

template <int D, class T, class Shape, class Transfer, class M>
inline constexpr int bytes =
    decltype(scene(grid::Cartesian<D, T>{}, Shape{}, Transfer{}, std::declval<M>()))::template bytes_per_particle<0>;

using Aluminium = decltype(aluminium);
using ColdElastic = decltype(cold_elastic);
using Water = decltype(water);
using shape::CubicBSpline, shape::Linear, shape::QuadraticBSpline, transfer::AffineFlip, transfer::Apic,
    transfer::Flip;

constexpr int id = 4;

// position 3, velocity 3, mass, volume ratio, deviatoric stress 6, plastic strain, plastic work, temperature
static_assert(bytes<3, double, Linear, Flip, Aluminium> == 17 * 8 + id);
static_assert(bytes<3, double, Linear, Flip, Aluminium> == 140, "the paper's scene");

// and the affine matrix 9
static_assert(bytes<3, double, QuadraticBSpline, Apic, Aluminium> == 26 * 8 + id);
static_assert(bytes<3, double, QuadraticBSpline, Apic, Aluminium> == 212, "quadratic APIC");
static_assert(bytes<3, double, QuadraticBSpline, AffineFlip, Aluminium> == 212, "the accurate scene");

// position 3, velocity 3, mass, volume ratio, deviatoric stress 6
static_assert(bytes<3, double, Linear, Flip, ColdElastic> == 14 * 8 + id);
static_assert(bytes<3, double, Linear, Flip, ColdElastic> == 116, "a cold elastic scene");

// a fluid: no stress column
static_assert(bytes<3, double, Linear, Flip, Water> == 8 * 8 + id);

// the full energy equation takes a column, a shock viscosity two
const Material shocked{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350}, energy::Full{}, viscosity::VonNeumann{}};
static_assert(bytes<3, double, Linear, Flip, decltype(shocked)> == (8 + 1 + 2) * 8 + id);

// one dimension: position, velocity, mass, volume ratio, stress 3, strain, work, temperature
static_assert(bytes<1, double, Linear, Flip, Aluminium> == 10 * 8 + id);
static_assert(bytes<1, double, QuadraticBSpline, Apic, Aluminium> == 11 * 8 + id);
// plane strain: position 2, velocity 2, mass, volume ratio, stress 4, strain, work, temperature; affine 4
static_assert(bytes<2, double, Linear, Flip, Aluminium> == 13 * 8 + id);
static_assert(bytes<2, double, QuadraticBSpline, Apic, Aluminium> == 17 * 8 + id);
// single precision halves all but the number
static_assert(bytes<3, float, Linear, Flip, Aluminium> == 17 * 4 + id);
static_assert(bytes<3, float, QuadraticBSpline, Apic, Aluminium> == 26 * 4 + id);

// only mixed hardening stores a back stress; logarithmic strain and the exponential map store nothing more
template <class Strength>
using Metal = decltype(Material{eos::MieGruneisen{}, Strength{}, heat::Adiabatic{}});
static_assert(bytes<3, double, Linear, Flip, Metal<strength::VonMisesMixed>> == 140 + 6 * 8);
static_assert(bytes<3, double, Linear, Flip, Metal<strength::VonMisesMixedExponential>> == 140 + 6 * 8);
static_assert(bytes<3, double, Linear, Flip, Metal<strength::VonMisesExponential>> == 140);
static_assert(bytes<3, double, Linear, Flip, Metal<strength::VonMisesLogarithmic>> == 140);
// position, velocity, mass, volume ratio, b of 3 numbers
static_assert(bytes<1, double, Linear, Flip, decltype(Material{eos::LogarithmicBulk{}, strength::NeoHookean{}})> ==
              7 * 8 + id);

// GIMP adds the half size 3
static_assert(bytes<3, double, shape::Gimp, Flip, Aluminium> == 20 * 8 + id);
static_assert(bytes<3, double, shape::ContiguousGimp, Apic, Aluminium> == 29 * 8 + id);
static_assert(bytes<1, float, shape::ContiguousGimp, Flip, Aluminium> == 11 * 4 + id);

// neither other shape functions, update orders nor executors add columns
static_assert(bytes<3, double, QuadraticBSpline, Flip, Aluminium> == bytes<3, double, Linear, Flip, Aluminium>);
static_assert(bytes<3, double, CubicBSpline, Apic, Aluminium> == bytes<3, double, QuadraticBSpline, Apic, Aluminium>);
static_assert(decltype(Solver{grid::Cartesian<3>{}, Linear{}, Flip{}, update::Musl{}, execution::Threads{},
                              timestep::Cfl{}, aluminium})::bytes_per_particle<0> == 140);

// every material has columns of its own
using Two = decltype(Solver{grid::Cartesian<3>{}, Linear{}, Flip{}, timestep::Cfl{}, aluminium, cold_elastic});
static_assert(Two::bytes_per_particle<0> == 140 && Two::bytes_per_particle<1> == 116);

// so has every one of two materials of one type; neither particles nor the solver carry a number to tell them apart
using Twins = decltype(Solver{grid::Cartesian<3>{}, Linear{}, Flip{}, timestep::Cfl{}, aluminium, aluminium});
using One = decltype(Solver{grid::Cartesian<3>{}, Linear{}, Flip{}, timestep::Cfl{}, aluminium});
static_assert(Twins::bytes_per_particle<0> == 140 && Twins::bytes_per_particle<1> == 140 && Twins::bodies == 2);
static_assert(One::bytes_per_particle<0> == 140 && One::bodies == 1);

// a body is its material, its columns and the range of its tiles; a solver grows by a body with each material
template <class M>
using BodyOf = passes::Body<std::remove_cv_t<M>, double, 3, Flip, Linear>;
static_assert(sizeof(BodyOf<Aluminium>) ==
              sizeof(Aluminium) + sizeof(Particles<double, 3, BodyOf<Aluminium>::list>) + 2 * sizeof(std::uint32_t));
static_assert(sizeof(Twins) == sizeof(One) + sizeof(BodyOf<Aluminium>));
static_assert(sizeof(Two) == sizeof(One) + sizeof(BodyOf<ColdElastic>));

}  // namespace
