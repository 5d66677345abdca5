/// \file
/// Properties of every shape function: alone, in the passes' stencils, and with the mirror images beyond a plane.
#include <array>
#include <limits>

#include <mote/mote.hpp>

#include "catch.hpp"
#include "holds.hpp"

// g++ 12 takes the lowest nodes of a pack, copied from a vector register, for uninitialised when a test inlines them
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace {

using namespace mote;

template <class S, class N>
struct Kernel {
  using Shape = S;
  using number = N;
};
/// A new kernel is one more line.
#define KERNELS                                                                                               \
  (Kernel<shape::Linear, double>), (Kernel<shape::Linear, float>), (Kernel<shape::QuadraticBSpline, double>), \
      (Kernel<shape::QuadraticBSpline, float>), (Kernel<shape::CubicBSpline, double>),                        \
      (Kernel<shape::CubicBSpline, float>), (Kernel<shape::ContiguousGimp, double>),                          \
      (Kernel<shape::ContiguousGimp, float>)

/// Whether the gradient is continuous.
template <class S>
inline constexpr bool smooth = S::support > 2;

template <class T>
bool near(T a, double b, double size = 1) {
  return std::abs(double(a) - b) <= 16 * double(std::numeric_limits<T>::epsilon()) * size;
}

/// A number in [0, 1], ends included.
double unit() { return *rc::gen::inRange(0, (1 << 20) + 1) / double(1 << 20); }

/// A half size in cells; kernels without one do not look at it.
double half_size() { return 0.01 + 0.49 * unit(); }

/// Weights and slopes at a place within the cell.
template <class S, class T>
struct At {
  T f, w[S::support], d[S::support];
  explicit At(double place, double half = 0.3) : f(T(S::first + place)) {
    if constexpr (sized<S>) {
      S::values(f, T(half), w);
      S::slopes(f, T(half), d);
    } else {
      S::values(f, w);
      S::slopes(f, d);
    }
  }
  /// sum of g(i - f, w_i, d_i)
  template <class G>
  T sum(G g) const {
    T total = 0;
    for (int i = 0; i < S::support; ++i) total += g(T(i) - f, w[i], d[i]);
    return total;
  }
};

/// A tile that reaches as far as tiles do, with one pack of particles anywhere in it.
template <class S, class T, int D>
struct Scene {
  passes::NodeBox<D> box{tile(), S::support};
  Vec<Pack<T>, D> xi;
  passes::HalfSizes<S, T, D> half{};

  Scene() {
    const int strangers = *rc::gen::inRange(0, lanes + 1);  // that do not share the first one's cell
    for (int a = 0; a < D; ++a) {
      const int first = cell();
      for (int l = 0; l < lanes; ++l)
        xi[a].set(l, T(S::first + (l < lanes - strangers ? first : cell()) + unit() * (1 - 1e-6)));
      if constexpr (sized<S>)
        for (int l = 0; l < lanes; ++l) half[a].set(l, T(half_size()));
    }
  }
  static int cell() { return *rc::gen::inRange(passes::lowest, passes::highest + 1); }
  static passes::Tile<D> tile() {
    passes::Tile<D> t{};
    t.lo.fill(passes::lowest);
    t.hi.fill(passes::highest);
    return t;
  }
  /// Coordinate of node n along axis a, in cells.
  int coordinate(int n, int a) const {
    const auto u = std::size_t(a);
    return n / box.stride[u] % box.extent[u] + box.lo[u];
  }
  /// What the pack gathers of the field f(node, component).
  template <class F>
  auto gathered(const F& f) {
    constexpr int width = grid::node_width<D>;
    AlignedVector<T> field(std::size_t(box.size * width), T(0));
    for (int n = 0; n < box.size; ++n)
      for (int c = 0; c < D; ++c) field[std::size_t(n * width + c)] = f(n, c);
    return gathered_from(field);
  }

 private:
  /// No template, so that it is compiled once for all f.
  [[gnu::noinline]] std::array<passes::Sums<T, D>, D> gathered_from(const AlignedVector<T>& field) {
    constexpr int width = grid::node_width<D>;
    constexpr passes::Wanted everything{true, true};
    passes::BatchNodes<S, T, D> nodes;
    nodes.append(xi, box, half);
    passes::SumColumns<everything, T, D> columns;
    nodes.for_each_window([&](int i, int node, const auto& stencil, unsigned bits, bool) {
      for (int c = 0; c < D; ++c)
        columns.template put<true>(i, c, passes::gather<everything>(field.data() + node * width, c, box, stencil),
                                   bits);
    });
    std::array<passes::Sums<T, D>, D> sums;
    for (int c = 0; c < D; ++c) {
      const auto i = std::size_t(c);
      sums[i].value = columns.value(0, c);
      for (int a = 0; a < D; ++a)
        sums[i].slope[a] = columns.slope(0, c, a), sums[i].moment[a] = columns.moment(0, c, a);
    }
    return sums;
  }
};

/// Calls f(integral constant D) for D = 1, 2, 3; of floats, which have no code of their own, for 3.
template <class T, class F>
void in_each_dimension(F f) {
  if constexpr (std::is_same_v<T, double>) {
    f(std::integral_constant<int, 1>{});
    f(std::integral_constant<int, 2>{});
  }
  f(std::integral_constant<int, 3>{});
}

}  // namespace

TEMPLATE_TEST_CASE("shape: weights sum to one and are not negative", "[shape][property]", KERNELS) {
  CHECK(holds([] {
    const At<typename TestType::Shape, typename TestType::number> at(unit(), half_size());
    RC_ASSERT(near(at.sum([](auto, auto w, auto) { return w; }), 1));
    for (auto w : at.w) RC_ASSERT(w >= 0);
  }));
}

TEMPLATE_TEST_CASE("shape: slopes sum to zero", "[shape][property]", KERNELS) {
  CHECK(holds([] {
    const At<typename TestType::Shape, typename TestType::number> at(unit(), half_size());
    RC_ASSERT(near(at.sum([](auto, auto, auto d) { return d; }), 0));
  }));
}

TEMPLATE_TEST_CASE("shape: a linear function is reproduced, and its slope", "[shape][property]", KERNELS) {
  CHECK(holds([] {
    const At<typename TestType::Shape, typename TestType::number> at(unit(), half_size());
    RC_ASSERT(near(at.sum([](auto r, auto w, auto) { return w * r; }), 0));
    RC_ASSERT(near(at.sum([](auto r, auto, auto d) { return d * r; }), 1));
  }));
}

TEMPLATE_TEST_CASE("shape: slopes are the derivatives of the weights", "[shape][property]", KERNELS) {
  using S = typename TestType::Shape;
  CHECK(holds([] {
    const double step = 1e-5, f = 0.001 + 0.998 * unit();  // differences of cubics are off by step^2/2
    const double half = half_size(), off = sized<S> ? step / half : 0;  // where the slope has a kink, up to 1/half
    const At<S, double> at(f, half), before(f - step, half), after(f + step, half);
    for (int i = 0; i < S::support; ++i)
      RC_ASSERT(std::abs((after.w[i] - before.w[i]) / (2 * step) - at.d[i]) < 1e-9 + off);
  }));
}

TEMPLATE_TEST_CASE("shape: no node beyond half the support is touched", "[shape][property]", KERNELS) {
  using S = typename TestType::Shape;
  CHECK(holds([] {
    const At<S, typename TestType::number> at(unit(), half_size());
    for (int i = 0; i < S::support; ++i) RC_ASSERT(std::abs(i - at.f) <= 0.5 * S::support);
  }));
}

TEMPLATE_TEST_CASE("shape: values, and slopes of smooth kernels, continue in the next cell", "[shape]", KERNELS) {
  using S = typename TestType::Shape;
  const At<S, typename TestType::number> end(1), begin(0);
  CHECK(end.w[0] == 0);
  CHECK(begin.w[S::support - 1] == 0);
  for (int i = 1; i < S::support; ++i) {
    CHECK(end.w[i] == begin.w[i - 1]);
    if (smooth<S>) CHECK(end.d[i] == begin.d[i - 1]);
  }
  if (smooth<S>) CHECK(end.d[0] == 0);
}

TEMPLATE_TEST_CASE("shape: the inertia that a kernel states is the same everywhere", "[shape][property]", KERNELS) {
  using S = typename TestType::Shape;
  if (S::inertia == 0) return;
  CHECK(holds([] {
    const At<S, typename TestType::number> at(unit(), half_size());
    RC_ASSERT(near(at.sum([](auto r, auto w, auto) { return w * r * r; }), S::inertia));
  }));
}

TEMPLATE_TEST_CASE("stencil: a linear field is gathered exactly, with its gradient and its inertia",
                   "[shape][passes][property]", KERNELS) {
  using S = typename TestType::Shape;
  using T = typename TestType::number;
  in_each_dimension<T>([](auto d) {
    constexpr int D = d;
    CHECK(holds([] {
      Scene<S, T, D> scene;
      const auto sums = scene.gathered([&](int n, int c) { return T(scene.coordinate(n, c)); });
      for (std::size_t l = 0; l < lanes; ++l)
        for (int c = 0; c < D; ++c) {
          RC_ASSERT(near(sums[std::size_t(c)].value[l], scene.xi[c][l], 8));
          for (int a = 0; a < D; ++a) {
            RC_ASSERT(near(sums[std::size_t(c)].slope[a][l], a == c, 8));
            if (a != c || S::inertia > 0)
              RC_ASSERT(near(sums[std::size_t(c)].moment[a][l], a == c ? S::inertia : 0, 32));
          }
        }
    }));
  });
}

TEMPLATE_TEST_CASE("stencil: a constant field has neither gradient nor moment", "[shape][passes][property]", KERNELS) {
  using T = typename TestType::number;
  in_each_dimension<T>([](auto d) {
    constexpr int D = d;
    CHECK(holds([] {
      Scene<typename TestType::Shape, T, D> scene;
      const auto sums = scene.gathered([](int, int) { return T(1); });
      for (std::size_t l = 0; l < lanes; ++l) {
        RC_ASSERT(near(sums[0].value[l], 1));
        for (int a = 0; a < D; ++a) {
          RC_ASSERT(near(sums[0].slope[a][l], 0));
          RC_ASSERT(near(sums[0].moment[a][l], 0));
        }
      }
    }));
  });
}

TEMPLATE_TEST_CASE("stencil: scattering is the transpose of gathering", "[shape][passes][property]", KERNELS) {
  using T = typename TestType::number;
  in_each_dimension<T>([](auto d) {
    constexpr int D = d;
    CHECK(holds([] {
      using S = typename TestType::Shape;
      constexpr int width = passes::MomentumAndForce<T, D>::width;
      Scene<S, T, D> scene;
      const auto draw = [](int) { return T(unit() - 0.5); };
      Pack<T> value[width], axis[D][width];
      for (auto& c : value) c = Pack<T>(draw);
      for (auto& a : axis)
        for (auto& c : a) c = Pack<T>(draw);
      const int n = *rc::gen::inRange(1, lanes + 1);
      AlignedVector<T> scattered(std::size_t(scene.box.size * width), T(0));
      passes::scatter_pack<S, passes::AxisWeights::moment_slope>(scattered.data(), scene.box, scene.xi, n, value, axis,
                                                                   scene.half);
      // <scattered, field> over the nodes is <brought, gathered> over the particles, for each number of a record
      for (int c = 0; c < width; ++c) {
        std::vector<T> field(std::size_t(scene.box.size));
        for (auto& f : field) f = draw(0);
        const auto sums = scene.gathered([&](int node, int i) { return i == 0 ? field[std::size_t(node)] : T(0); });
        double on_nodes = 0, on_particles = 0;
        for (std::size_t node = 0; node < field.size(); ++node)
          on_nodes += double(scattered[node * width + std::size_t(c)]) * double(field[node]);
        for (std::size_t l = 0; l < std::size_t(n); ++l) {
          on_particles += double(value[c][l]) * double(sums[0].value[l]);
          for (int a = 0; a < D; ++a)
            on_particles += double(axis[a][c][l]) * double(c % 2 ? sums[0].slope[a][l] : sums[0].moment[a][l]);
        }
        RC_ASSERT(near(T(on_nodes), on_particles, 16));
      }
    }));
  });
}

namespace {

/// A velocity field that is linear and obeys a mirror plane: v = A x + c.
template <int D>
struct LinearField {
  Mat<double, D> A{};
  Vec<double, D> c{};

  /// All components odd in the distance from the plane, or, for a symmetry plane, only the normal one.
  LinearField(int axis, bool wall) {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        if (j == axis ? wall || i == axis : !wall && i != axis) A(i, j) = unit() - 0.5;
    for (int i = 0; i < D; ++i) c[i] = wall || i == axis ? 0 : unit() - 0.5;
  }
  Vec<double, D> operator()(const Vec<double, D>& x) const { return A * x + c; }
};

/// One step of a body on a plane through the origin, its particles anywhere in their cells; see the test below.
template <class S, class T, int D, class Plane>
void check_mirrored_field(const Plane& plane, bool wall) {
  const double dt = 0.01;
  const Material dust{eos::MieGruneisen{.rho0 = 1, .c0 = 1e-16, .lambda = 1.34, .gamma0 = 1.96},
                      strength::VonMises{.shear_modulus = 1e-30, .yield = 1},
                      heat::Adiabatic{.specific_heat = 880}};  // the type of kernels/kernels.hpp, without its stress
  const LinearField<D> field(plane.side.axis, wall);
  Solver solver{grid::Cartesian<D, T>{.spacing = 1},
                S{},
                transfer::Apic{},
                update::Musl{},
                timestep::Fixed{.dt = dt},
                plane,
                dust};
  geometry::Box<D> block{.lower = Vec<double, D>::filled(-3), .upper = Vec<double, D>::filled(3)};
  (plane.side.upper ? block.upper : block.lower)[plane.side.axis] = 0;
  solver.fill(block, dust, {.per_axis = 1, .jitter = 0.5, .seed = *rc::gen::inRange<std::uint64_t>(0, 1000)});
  auto& particles = solver.particles();
  for (std::size_t p = 0; p < particles.size(); ++p) {
    particles.template set<field::Velocity>(p, field(cast<double>(particles.template get<field::Position>(p))));
    particles.template set<field::Affine>(p, field.A);
    if constexpr (sized<S>)
      for (int a = 0; a < D; ++a) particles.template column<field::HalfSize>(a)[p] = T(half_size());
  }
  solver.refresh();
  std::vector<Vec<double, D>> place;
  for (std::size_t p = 0; p < particles.size(); ++p)
    place.push_back(cast<double>(particles.template get<field::Position>(p)));
  solver.step();
  const double J = det(Mat<double, 3>::identity() + embed(dt * field.A));
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Vec<double, D> v = field(place[p]);
    for (int i = 0; i < D; ++i) {
      RC_ASSERT(near(particles.template column<field::Velocity>(i)[p], v[i], 4));
      RC_ASSERT(near(particles.template column<field::Position>(i)[p], place[p][i] + dt * v[i], 4));
      for (int j = 0; j < D; ++j) RC_ASSERT(near(particles.template get<field::Affine>(p)(i, j), field.A(i, j), 16));
    }
    RC_ASSERT(near(particles.template column<field::VolumeRatio>()[p], J));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("shape: with the images beyond a plane, a field that obeys it is reproduced up to the plane",
                   "[shape][boundary][property]", KERNELS) {
  using S = typename TestType::Shape;
  using T = typename TestType::number;
  in_each_dimension<T>([](auto d) {
    constexpr int D = d;
    CHECK(holds([] {
      const Side side{*rc::gen::inRange(0, D), *rc::gen::arbitrary<bool>()};
      check_mirrored_field<S, T, D>(boundary::RigidWall{.side = side, .at = 0}, true);
      check_mirrored_field<S, T, D>(boundary::Symmetry{.side = side, .at = 0}, false);
    }));
  });
}
