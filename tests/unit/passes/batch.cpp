/// \file
/// Windows of a batch: every lane of every pack is gathered, surplus ones too, since all of them enter the tile's
/// report.
#include <cmath>
#include <limits>

#include <mote/mote.hpp>

#include "catch.hpp"

using namespace mote;

namespace {

using Shape = shape::QuadraticBSpline;
constexpr passes::Wanted values_only{false, false};

struct Batch {
  passes::NodeBox<1> box{tile(), Shape::support};
  passes::BatchNodes<Shape, double, 1> nodes;
  passes::SumColumns<values_only, double, 1> columns;

  static passes::Tile<1> tile() {
    passes::Tile<1> t{};
    t.lo = {passes::lowest}, t.hi = {passes::highest};
    return t;
  }
  /// Appends a pack with these positions, in cells; the last one repeats in surplus lanes, as a load does.
  void append(const std::vector<double>& xi) {
    nodes.append({Pack<double>([&](int l) { return xi[std::min(std::size_t(l), xi.size() - 1)]; })}, box);
  }
  /// A field on nodes that no cell's polynomial continues into the next.
  static double field(int node) { return node % 3 == 0 ? 1.0 + node : -node * node; }
  /// The same in between, from the kernel alone.
  static double at(double xi) {
    const double lowest = std::floor(xi - Shape::first);
    double w[Shape::support], sum = 0;
    Shape::values(xi - lowest, w);
    for (int i = 0; i < Shape::support; ++i) sum += w[i] * field(int(lowest) + i);
    return sum;
  }
  /// Gathers the field; what is not gathered stays nan. \return windows
  int gather() {
    passes::Sums<double, 1> nan;
    nan.value = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < passes::batch; i += lanes) columns.put<false>(i, 0, nan, 0xff);
    AlignedVector<double> on_nodes(std::size_t(box.size * grid::node_width<1>), 0.0);
    for (int n = 0; n < box.size; ++n) on_nodes[std::size_t(n * grid::node_width<1>)] = field(n + box.lo[0]);
    return nodes.for_each_window([&](int i, int node, const auto& stencil, unsigned bits, bool some) {
      const auto sums = passes::gather<values_only>(on_nodes.data() + node * grid::node_width<1>, 0, box, stencil);
      some ? columns.put<true>(i, 0, sums, bits) : columns.put<false>(i, 0, sums, bits);
    });
  }
};

}  // namespace

TEST_CASE("batch: surplus lanes of a last pack gather what its last particle does", "[passes]") {
  Batch batch;
  batch.append({0.6, 1.6, 1.7, 1.8, 1.9, 2.0, 2.1, 2.2});  // one particle in a cell, and eight in the next
  batch.append({2.3});
  CHECK(batch.gather() == 3);  // the repeated lanes beyond the window of the eight take one more
  for (int l = 0; l < lanes; ++l) CHECK(batch.columns.value(8, 0)[std::size_t(l)] == Approx(Batch::at(2.3)));
  CHECK(batch.columns.value(0, 0)[0] == Approx(Batch::at(0.6)));
  CHECK(batch.columns.value(0, 0)[7] == Approx(Batch::at(2.2)));
}

TEST_CASE("batch: strangers among the particles of a cell keep what is theirs", "[passes]") {
  const std::vector<double> xi = {1.6, 3.6, 1.7, 0.7, 3.7, 1.8, 0.8, 1.9};
  Batch batch;
  batch.append(xi);
  CHECK(batch.gather() == 3);
  for (std::size_t l = 0; l < xi.size(); ++l) CHECK(batch.columns.value(0, 0)[l] == Approx(Batch::at(xi[l])));
}
