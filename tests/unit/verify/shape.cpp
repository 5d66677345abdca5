/// \file
/// verify::shape: what the library has passes, and each check fails on a kernel that is wrong in that alone.
#include <mote/verify/shape.hpp>

#include <mote/shape/cubic_bspline.hpp>
#include <mote/shape/gimp.hpp>
#include <mote/shape/linear.hpp>
#include <mote/shape/quadratic_bspline.hpp>

#include "fails.hpp"

namespace {

using namespace mote;

enum class Fault { none, unity, gradient, linear, slopes, inertia, jump, negative, packs };

/// Quadratic B-splines with one mistake, and all else consistent with it.
template <Fault fault>
struct Faulty : shape::QuadraticBSpline {
  static constexpr double inertia = fault == Fault::unity                                ? 0.25 * 1.001
                                    : fault == Fault::inertia                            ? 0.3
                                    : fault == Fault::jump                               ? 0.25 + 2 * 0.01
                                    : fault == Fault::linear || fault == Fault::negative ? 0
                                                                                         : 0.25;
  template <class T>
  static void values(const T& f, T* w) {
    QuadraticBSpline::values(f, w);
    // a hump over the cell, flat at its ends
    const T u = f - T(0.5), bump = T(4) * u * (T(1) - u), hump = bump * bump;
    if (fault == Fault::unity)
      for (int i = 0; i < 3; ++i) w[i] *= T(1.001);
    if (fault == Fault::linear) w[0] += T(0.01) * hump, w[2] -= T(0.01) * hump;
    if (fault == Fault::jump) w[0] += T(0.01), w[1] -= T(0.02), w[2] += T(0.01);
    if (fault == Fault::negative) w[0] -= T(0.1) * hump, w[1] += T(0.2) * hump, w[2] -= T(0.1) * hump;
    if (fault == Fault::packs && is_pack<T>) w[1] += T(1e-9);
  }
  template <class T>
  static void slopes(const T& f, T* d) {
    QuadraticBSpline::slopes(f, d);
    const T u = f - T(0.5), slope = T(32) * u * (T(1) - u) * (T(1) - T(2) * u);
    if (fault == Fault::unity || fault == Fault::slopes)
      for (int i = 0; i < 3; ++i) d[i] *= T(1.001);
    if (fault == Fault::gradient) d[1] += T(1e-11);  // less than differences see, more than a body at rest forgives
    if (fault == Fault::linear) d[0] += T(0.01) * slope, d[2] -= T(0.01) * slope;
    if (fault == Fault::negative) d[0] -= T(0.1) * slope, d[1] += T(0.2) * slope, d[2] -= T(0.1) * slope;
  }
};

template <Fault fault>
void fails(const char* check) {
  verdict::fails(verify::shape(Faulty<fault>{}), {check});
}

}  // namespace

TEST_CASE("verify::shape passes all kernels of the library", "[verify]") {
  verdict::passes(verify::shape(shape::Linear{}));
  verdict::passes(verify::shape(shape::QuadraticBSpline{}));
  verdict::passes(verify::shape(shape::CubicBSpline{}));
  verdict::passes(verify::shape(shape::Gimp{}));
  verdict::passes(verify::shape(shape::ContiguousGimp{}));
  verdict::passes(verify::shape(Faulty<Fault::none>{}));
}

TEST_CASE("verify::shape: each check fails on its own mistake", "[verify]") {
  fails<Fault::unity>("partition of unity");
  fails<Fault::gradient>("slopes sum to zero");
  fails<Fault::linear>("linear functions are reproduced");
  fails<Fault::slopes>("slopes are those of the weights");
  fails<Fault::inertia>("inertia");
  fails<Fault::jump>("weights are continuous across cells");
  fails<Fault::negative>("weights are not negative");
  fails<Fault::packs>("packs are numbers, lane by lane");
}
