// Every concept takes a good type, every shipped policy, and refuses a type that lacks one thing.
#include <mote/mote.hpp>

namespace {

using namespace mote;

// ---- Eos

struct GoodEos {
  using role = mote::role::Eos;
  double rho0 = 1;
  // clang-format off
  template <class T> T pressure(T x, T) const { return T(1) - x; }
  template <class T> T bulk_sound_speed2(T x, T) const { return x * x; }
  template <class T> T reference_energy(T x) const { return x; }
  template <class T> T reference_heating(T) const { return T(0); }
  template <class T> auto admissible(T x) const { return x > T(0); }
  // clang-format on
  double gamma_over_volume() const { return 0; }
};
struct EosWithGammaOfVolume : GoodEos {
  template <class T>
  T gamma_over_volume(T x) const {
    return T(2) / x;
  }
};
struct EosWithIntegerGamma : GoodEos {
  int gamma_over_volume(double) const;
};
struct EosWithoutRole : GoodEos {
  using role = void;
};
struct EosOfForeignRole : GoodEos {
  using role = mote::role::Strength;
};
struct EosWithoutDensity : GoodEos {
  void rho0() const;
};
struct EosWithoutPressure : GoodEos {
  void pressure() const;
};
struct EosWithIntegerPressure : GoodEos {
  int pressure(double, double) const;
};
struct EosWithoutSoundSpeed : GoodEos {
  void bulk_sound_speed2() const;
};
struct EosWithoutEnergy : GoodEos {
  void reference_energy() const;
};
struct EosWithoutHeating : GoodEos {
  void reference_heating() const;
};
struct EosWithoutGamma : GoodEos {
  void gamma_over_volume() const;
};
struct EosWithoutAdmissible : GoodEos {
  void admissible() const;
};

static_assert(Eos<GoodEos> && Eos<GoodEos, Pack<float>>);
static_assert(Eos<eos::LinearBulk> && Eos<eos::LinearBulk, float> && Eos<eos::LinearBulk, Pack<double>>);
static_assert(Eos<eos::MieGruneisen> && Eos<eos::MieGruneisen, float> && Eos<eos::MieGruneisen, Pack<double>>);
static_assert(!Eos<int> && !Eos<EosWithoutRole> && !Eos<EosOfForeignRole> && !Eos<strength::Elastic>);
static_assert(!Eos<EosWithoutDensity> && !Eos<EosWithoutPressure> && !Eos<EosWithIntegerPressure>);
static_assert(!Eos<EosWithoutSoundSpeed> && !Eos<EosWithoutEnergy> && !Eos<EosWithoutHeating>);
static_assert(Eos<eos::IdealGas> && Eos<eos::IdealGas, float> && Eos<eos::IdealGas, Pack<double>>);
static_assert(Eos<eos::ConstantGamma<eos::MieGruneisen>, Pack<float>> && Eos<EosWithGammaOfVolume, Pack<double>>);
static_assert(Eos<eos::TensionCutoff<eos::ConstantGamma<eos::MieGruneisen>>, Pack<double>>);
static_assert(!Eos<EosWithIntegerGamma>);
static_assert(!Eos<EosWithoutGamma> && !Eos<EosWithoutAdmissible>);

// ---- StrengthFor

template <class T>
using Solid =
    Values<T, 3, fields<field::VolumeRatio, field::DeviatoricStress, field::PlasticStrain, field::Temperature>>;

struct GoodStrength {
  using role = mote::role::Strength;
  template <class V, class T>
  void update(V&, const Kinematics<T>&) const {}
};
struct StrengthWithoutUpdate {
  using role = mote::role::Strength;
};
struct StrengthWithoutRole : GoodStrength {
  using role = void;
};
struct StrengthThatChanges {
  using role = mote::role::Strength;
  template <class V, class T>
  void update(V&, const Kinematics<T>&) {}
};
struct StrengthForNumbers {
  using role = mote::role::Strength;
  template <class V>
  void update(V&, const Kinematics<double>&) const {}
};

template <class S>
inline constexpr bool strength_for_all = StrengthFor<S, Solid<double>>&& StrengthFor<S, Solid<float>>&&
    StrengthFor<S, Solid<Pack<double>>>&& StrengthFor<S, Solid<Pack<float>>>;
static_assert(strength_for_all<GoodStrength> && strength_for_all<strength::None>);
static_assert(strength_for_all<strength::Elastic> && strength_for_all<strength::VonMises>);
static_assert(StrengthFor<StrengthForNumbers, Solid<double>> && !StrengthFor<StrengthForNumbers, Solid<Pack<double>>>);
static_assert(!StrengthFor<int, Solid<double>> && !StrengthFor<StrengthWithoutUpdate, Solid<double>>);
static_assert(!StrengthFor<StrengthWithoutRole, Solid<double>> && !StrengthFor<StrengthThatChanges, Solid<double>>);

// ---- HeatFor

struct GoodHeat {
  using role = mote::role::Heat;
  template <class V, class E, class T>
  void update(V&, const E&, const T&, const T&, const T&) const {}
};
struct HeatWithoutRole : GoodHeat {
  using role = void;
};
struct HeatWithoutUpdate {
  using role = mote::role::Heat;
};
struct HeatWithoutWork {
  using role = mote::role::Heat;
  template <class V, class E, class T>
  void update(V&, const E&, const T&, const T&) const {}
};

template <class H>
inline constexpr bool heat_for_all = HeatFor<H, Solid<double>, GoodEos>&& HeatFor<H, Solid<float>, eos::LinearBulk>&&
    HeatFor<H, Solid<Pack<double>>, eos::MieGruneisen>;
static_assert(heat_for_all<GoodHeat> && heat_for_all<heat::None> && heat_for_all<heat::Adiabatic>);
static_assert(!HeatFor<int, Solid<double>, GoodEos> && !HeatFor<HeatWithoutRole, Solid<double>, GoodEos>);
static_assert(!HeatFor<HeatWithoutUpdate, Solid<double>, GoodEos> && !HeatFor<HeatWithoutWork, Solid<double>, GoodEos>);

// ---- EnergyFor

struct GoodEnergy {
  using role = mote::role::Energy;
  static constexpr bool complete = false;
  // clang-format off
  template <class V, class E> typename V::number excess(const V&, const E&) const { return {}; }
  template <class V, class E> typename V::number bulk_sound_speed2(const V&, const E&) const { return {}; }
  template <class V, class E> typename V::number pressure_work(const V&, const E&) const { return {}; }
  template <class V, class E, class T> void update(V&, const E&, const T&, const T&, const T&) const {}
  // clang-format on
};
struct EnergyWithoutRole : GoodEnergy {
  using role = void;
};
struct EnergyWithoutComplete : GoodEnergy {
  void complete() const;
};
struct EnergyWithoutExcess : GoodEnergy {
  void excess() const;
};
struct EnergyWithoutSoundSpeed : GoodEnergy {
  void bulk_sound_speed2() const;
};
struct EnergyWithoutWork : GoodEnergy {
  void pressure_work() const;
};
struct EnergyWithoutUpdate : GoodEnergy {
  void update() const;
};

template <class T>
using Gas = Values<T, 3, fields<field::VolumeRatio, field::InternalEnergy>>;
template <class C>
inline constexpr bool energy_for_all = EnergyFor<C, Gas<double>, GoodEos>&& EnergyFor<C, Gas<float>, eos::IdealGas>&&
    EnergyFor<C, Gas<Pack<double>>, eos::MieGruneisen>;
static_assert(energy_for_all<GoodEnergy> && energy_for_all<energy::Plastic> && energy_for_all<energy::Full>);
static_assert(HasInternalEnergy<eos::MieGruneisen> && HasInternalEnergy<eos::TensionCutoff<eos::LinearBulk>> &&
              HasInternalEnergy<eos::ConstantGamma<eos::LinearBulk>, Pack<float>> && !HasInternalEnergy<GoodEos> &&
              !HasInternalEnergy<eos::ConstantGamma<GoodEos>>);
static_assert(!energy_for_all<int> && !energy_for_all<EnergyWithoutRole> && !energy_for_all<EnergyWithoutExcess>);
static_assert(!energy_for_all<EnergyWithoutComplete> && !energy_for_all<EnergyWithoutSoundSpeed>);
static_assert(!energy_for_all<EnergyWithoutWork> && !energy_for_all<EnergyWithoutUpdate>);

// ---- Viscosity

struct GoodViscosity {
  using role = mote::role::Viscosity;
  // clang-format off
  template <class T> T pressure(const T&, const T&, const T& u) const { return u; }
  template <class T> T signal_speed2(const T&, const T& c2, const T&) const { return c2; }
  // clang-format on
};
struct ViscosityWithoutRole : GoodViscosity {
  using role = void;
};
struct ViscosityWithoutPressure : GoodViscosity {
  void pressure() const;
};
struct ViscosityWithoutSpeed : GoodViscosity {
  void signal_speed2() const;
};
static_assert(Viscosity<GoodViscosity> && Viscosity<viscosity::VonNeumann, Pack<float>>);
static_assert(!Viscosity<int> && !Viscosity<ViscosityWithoutRole> && !Viscosity<ViscosityWithoutPressure>);
static_assert(!Viscosity<ViscosityWithoutSpeed> && !Viscosity<viscosity::None>, "None is not asked for anything");

// ---- Shape

struct GoodShape {
  using role = mote::role::Shape;
  static constexpr int support = 1;
  static constexpr double first = 0, inertia = 0;
  // clang-format off
  template <class T> static void values(const T&, T*) {}
  template <class T> static void slopes(const T&, T*) {}
  // clang-format on
};
struct ShapeWithoutRole : GoodShape {
  using role = void;
};
struct ShapeWithoutSupport : GoodShape {
  static void support();
};
struct ShapeWithoutFirst : GoodShape {
  static void first();
};
struct ShapeWithoutInertia : GoodShape {
  static void inertia();
};
struct ShapeWithoutValues : GoodShape {
  static void values();
};
struct ShapeWithoutSlopes : GoodShape {
  static void slopes();
};

static_assert(Shape<GoodShape> && Shape<shape::Linear> && Shape<shape::QuadraticBSpline> &&
              Shape<shape::CubicBSpline>);
// one that declares a half size takes it
struct SizedShape : GoodShape {
  using particle_fields = fields<field::HalfSize>;
  // clang-format off
  template <class T> static void values(const T&, const T&, T*) {}
  template <class T> static void slopes(const T&, const T&, T*) {}
  // clang-format on
};
struct SizedShapeWithoutHalf : GoodShape {
  using particle_fields = fields<field::HalfSize>;
};
struct ShapeWithHalf : SizedShape {
  using particle_fields = fields<>;
};
static_assert(Shape<SizedShape> && Shape<shape::Gimp> && Shape<shape::ContiguousGimp>);
static_assert(!Shape<SizedShapeWithoutHalf> && !Shape<ShapeWithHalf>);
static_assert(!Shape<int> && !Shape<ShapeWithoutRole> && !Shape<ShapeWithoutSupport> && !Shape<ShapeWithoutFirst>);
static_assert(!Shape<ShapeWithoutInertia> && !Shape<ShapeWithoutValues> && !Shape<ShapeWithoutSlopes>);

// ---- Transfer

struct GoodTransfer {
  using role = mote::role::Transfer;
  static constexpr bool affine = false, increment = false;
  double kept() const { return 0; }
  template <class V, class G>
  void update(V&, const G&) const {}
};
struct TransferWithoutUpdate : GoodTransfer {
  int update;
};
struct TransferWithoutRole : GoodTransfer {
  using role = void;
};
struct TransferWithoutKept : GoodTransfer {
  void kept() const;
};
struct TransferWithoutAffine : GoodTransfer {
  static void affine(int);
  static void affine(double);
};
struct TransferWithoutIncrement : GoodTransfer {
  static void increment(int);
  static void increment(double);
};

static_assert(Transfer<GoodTransfer> && Transfer<transfer::Flip> && Transfer<transfer::Apic>);
static_assert(Transfer<transfer::Xpic> && Transfer<transfer::Fmpm>);
static_assert(sharpens<transfer::Apic> == Sharpens::nothing && sharpens<transfer::Fmpm> == Sharpens::grid);
static_assert(!Transfer<int> && !Transfer<TransferWithoutRole> && !Transfer<TransferWithoutKept>);
static_assert(!Transfer<TransferWithoutAffine> && !Transfer<TransferWithoutIncrement>);
static_assert(!Transfer<TransferWithoutUpdate>);

// ---- Update, Timestep, LoadIn

struct UpdateWithoutRemaps {
  using role = mote::role::Update;
};
struct TimestepWithoutCall {
  using role = mote::role::Timestep;
};
static_assert(Update<update::Usl> && Update<update::Musl> && Update<update::Usf> && !Update<UpdateWithoutRemaps> &&
              !Update<int>);
static_assert(Timestep<timestep::Cfl> && Timestep<timestep::Fixed> && !Timestep<TimestepWithoutCall> && !Timestep<int>);
static_assert(LoadIn<load::BodyForce<2>, 2> && !LoadIn<load::BodyForce<2>, 3> && !LoadIn<int, 2>);

// ---- MirrorPlane, PeriodicPair, Boundary

struct GoodPlane {
  using role = mote::role::Boundary;
  static constexpr bool body_beyond = true;
  Side side;
  double at;
  static constexpr bool odd(int, int) { return true; }
};
struct PlaneWithoutRole : GoodPlane {
  using role = void;
};
struct PlaneWithoutSide : GoodPlane {
  void side() const;
};
struct PlaneWithoutPlace : GoodPlane {
  void at() const;
};
struct PlaneWithoutOdd : GoodPlane {
  static void odd();
};
struct PlaneWithoutBeyond : GoodPlane {
  static void body_beyond(int);
  static void body_beyond(double);
};
struct GoodPair {
  using role = mote::role::Boundary;
  int axis;
  double from, to;
};
struct PairWithoutRole : GoodPair {
  using role = void;
};
struct PairWithoutAxis : GoodPair {
  void axis() const;
};
struct PairWithoutFrom : GoodPair {
  void from() const;
};
struct PairWithoutTo : GoodPair {
  void to() const;
};

static_assert(MirrorPlane<GoodPlane> && MirrorPlane<boundary::Symmetry> && MirrorPlane<boundary::RigidWall>);
static_assert(!MirrorPlane<GoodPair> && !MirrorPlane<boundary::Periodic> && !MirrorPlane<PlaneWithoutRole>);
static_assert(!MirrorPlane<PlaneWithoutSide> && !MirrorPlane<PlaneWithoutPlace> && !MirrorPlane<PlaneWithoutOdd>);
static_assert(!MirrorPlane<PlaneWithoutBeyond>);
static_assert(PeriodicPair<GoodPair> && PeriodicPair<boundary::Periodic>);
static_assert(!PeriodicPair<GoodPlane> && !PeriodicPair<boundary::RigidWall> && !PeriodicPair<PairWithoutRole>);
static_assert(!PeriodicPair<PairWithoutAxis> && !PeriodicPair<PairWithoutFrom> && !PeriodicPair<PairWithoutTo>);
static_assert(Boundary<GoodPlane> && Boundary<GoodPair> && Boundary<boundary::Periodic>);
static_assert(Boundary<boundary::Symmetry> && Boundary<boundary::RigidWall>);
static_assert(!Boundary<int> && !Boundary<PlaneWithoutOdd> && !Boundary<PairWithoutTo>);

// ---- Execution

struct GoodExecution {
  using role = mote::role::Execution;
  int concurrency() const { return 1; }
  template <class F>
  void for_each(std::size_t, const F&) const {}
};
struct ExecutionWithoutRole : GoodExecution {
  using role = void;
};
struct ExecutionWithoutConcurrency : GoodExecution {
  void concurrency() const;
};
struct ExecutionWithoutLoop : GoodExecution {
  void for_each() const;
};
struct ExecutionThatChanges {
  using role = mote::role::Execution;
  int concurrency() const { return 1; }
  template <class F>
  void for_each(std::size_t, const F&) {}
};

static_assert(Sleep<sleep::Never> && Sleep<sleep::Quiescent> && !Sleep<int>);
static_assert(Execution<GoodExecution> && Execution<execution::Serial> && Execution<execution::Threads>);
static_assert(!Execution<int> && !Execution<ExecutionWithoutRole> && !Execution<ExecutionWithoutConcurrency>);
static_assert(!Execution<ExecutionWithoutLoop> && !Execution<ExecutionThatChanges>);

// ---- Region

struct GoodRegion {
  static constexpr int dimension = 2;
  bool contains(const Vec<double, 2>&) const { return true; }
  double level(const Vec<double, 2>&) const { return -1; }
  geometry::Bounds<2> bounds() const { return geometry::Bounds<2>::everything(); }
};
struct RegionOfFourDimensions {
  static constexpr int dimension = 4;
  bool contains(const Vec<double, 4>&) const { return true; }
  double level(const Vec<double, 4>&) const { return -1; }
  geometry::Bounds<4> bounds() const { return geometry::Bounds<4>::everything(); }
};
struct RegionWithoutContains : GoodRegion {
  void contains() const;
};
struct RegionWithoutLevel : GoodRegion {
  void level() const;
};
struct RegionWithoutBounds : GoodRegion {
  void bounds(int) const;
};
struct RegionWithForeignBounds : GoodRegion {
  geometry::Bounds<3> bounds() const;
};

template <int D>
inline constexpr bool shipped = geometry::Region<geometry::Box<D>>&& geometry::Region<geometry::Ball<D>>&&
    geometry::Region<geometry::HalfSpace<D>>&& geometry::Region<decltype(geometry::Box<D>{} - geometry::Ball<D>{})>;
static_assert(geometry::Region<GoodRegion> && shipped<1> && shipped<2> && shipped<3>);
static_assert(!geometry::Region<int> && !geometry::Region<RegionOfFourDimensions>);
static_assert(!geometry::Region<RegionWithoutContains> && !geometry::Region<RegionWithoutLevel>);
static_assert(!geometry::Region<RegionWithoutBounds> && !geometry::Region<RegionWithForeignBounds>);

// ---- good types are good enough: the assembly takes them

static_assert(decltype(Solver{grid::Cartesian<2>{}, GoodShape{}, GoodTransfer{}, timestep::Cfl{}, GoodExecution{},
                              GoodPlane{}, GoodPair{}, Material{GoodEos{}, GoodStrength{}, GoodHeat{}}})::dimension ==
              2);

}  // namespace
