// Frames, read back with VTK's own readers through read_vtk.py where VTK's Python module is there.
#include "catch.hpp"

#include <mote/observe/vti.hpp>
#include <mote/observe/vtp.hpp>

#include <sys/wait.h>
#include <unistd.h>
#include <mote/mote.hpp>

#include <fstream>
#include <sstream>

using namespace mote;

namespace {

namespace fs = std::filesystem;

struct Scratch {
  fs::path path = fs::temp_directory_path() / ("mote_frames_" + std::to_string(::getpid()));
  Scratch() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Scratch() { fs::remove_all(path); }
};

int run(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Whether all files below a directory read back and hold what is expected; true with a warning without VTK.
bool reads_back(const fs::path& directory, const std::string& expected = "") {
  for (const std::string python : {"/usr/bin/python3", "python3"}) {
    if (run(python + " -c 'import vtk' >/dev/null 2>&1") != 0) continue;
    std::ofstream(directory / "expected.txt") << expected;
    const auto script = fs::absolute(__FILE__).parent_path() / "read_vtk.py";
    return run(python + " -B '" + script.string() + "' '" + directory.string() + "' --expect '" +
               (directory / "expected.txt").string() + "'") == 0;
  }
  WARN("SKIPPED: no Python with `import vtk` (python3-vtk9), so the files are not read back");
  return true;
}

std::string content(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

std::string expectation(const std::string& file, const std::string& name, int components, const std::string& type,
                        const std::vector<double>& values) {
  std::string line = file + "\tpoint\t" + name + '\t' + std::to_string(components) + '\t' + type;
  for (const double v : values) observe::append_number(line += '\t', v);
  return line + '\n';
}

// A user's own fields, on a material without strength.
struct Marker {
  using shape = shape_of::Scalar;
  static constexpr const char* name = "marker";
  static constexpr double initial = 7;
};
struct Drift {
  using shape = shape_of::Vector;
  static constexpr const char* name = "drift";
  static constexpr double initial = 2;
};
struct Tracer {
  using role = mote::role::Strength;
  using particle_fields = fields<Marker, Drift>;
  template <class V, class T>
  void update(V&, const Kinematics<T>&) const {}
};

const Material metal{eos::MieGruneisen{.rho0 = 2700, .c0 = 5350, .lambda = 1.34, .gamma0 = 1.96},
                     strength::VonMises{.shear_modulus = 25.94e9, .yield = 120e6, .hardening = 384e6},
                     heat::Adiabatic{.specific_heat = 880, .initial_temperature = 300}};

/// 8 x 8 x 12 cells of 1 m, so that sums of volumes are exact; whole (from = -4) or a quarter (0).
auto scene(int threads, double from) {
  return Solver{grid::Cartesian<3>{.spacing = 1},
                shape::QuadraticBSpline{},
                transfer::Apic{},
                timestep::Cfl{},
                boundary::Symmetry{.side = side::x_min, .at = from},
                boundary::Symmetry{.side = side::x_max, .at = 4},
                boundary::Symmetry{.side = side::y_min, .at = from},
                boundary::Symmetry{.side = side::y_max, .at = 4},
                boundary::RigidWall{.side = side::z_min, .at = 0},
                execution::Threads(threads),
                metal};
}
template <class S>
void fill(S& solver) {
  const geometry::Box<3> block{.lower = {-4, -4, 0}, .upper = {4, 4, 12}};
  solver.fill(block - geometry::Ball<3>{.centre = {0, 0, 5}, .radius = 2.5}, metal,
              {.velocity = [](const Vec<double, 3>& x) {
                return Vec<double, 3>{x[0], -2 * x[1], 8};
              }});
}

}  // namespace

TEST_CASE("vtp: particles with the user's fields and their image, padded", "[frames]") {
  const Scratch scratch;
  const Material own{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}, Tracer{}};
  Solver solver{grid::Cartesian<2>{.spacing = 1},
                shape::Linear{},
                transfer::Apic{},
                timestep::Cfl{},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                own};
  solver.fill(geometry::Box<2>{.lower = {0, 0}, .upper = {1, 1}}, own, {.per_axis = 1, .velocity = {3, 4}});
  const bool doubles = GENERATE(false, true);
  solver.run({.until = 1e-6},
             observe::Vtp{.stem = scratch.path / "sub" / "p", .frames = 1, .mirror = {axis::x}, .doubles = doubles});
  const std::string real = doubles ? "Float64" : "Float32", file = "sub/p_0000.vtp";
  std::string points = expectation(file, "Points", 3, real, {0.5, 0.5, 0, -0.5, 0.5, 0});
  points.replace(points.find("\tpoint\t"), 7, "\tpoints\t");
  CHECK(reads_back(scratch.path,
                   points + expectation(file, "velocity", 3, real, {3, 4, 0, -3, 4, 0}) +
                       expectation(file, "drift", 3, real, {2, 2, 0, -2, 2, 0}) +
                       expectation(file, "marker", 1, real, {7, 7}) + expectation(file, "pressure", 1, real, {0, 0}) +
                       expectation(file, "density", 1, real, {1000, 1000}) +
                       expectation(file, "volume_ratio", 1, real, {1, 1}) +
                       expectation(file, "id", 1, "UInt32", {0, 0}) + "sub/p.pvd\tframes\tp_0000.vtp\t0\n"));
  const std::string text = content(scratch.path / file);
  for (const char* hidden : {"affine", "mass", "deviatoric", "body"}) CHECK(text.find(hidden) == std::string::npos);
}

TEST_CASE("vtp: of several bodies each has its number, and nan for what it lacks", "[frames]") {
  const Scratch scratch;
  const Material own{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}, Tracer{}};
  auto colder = metal;
  colder.heat.initial_temperature = 200;
  Solver solver{grid::Cartesian<2>{.spacing = 1},
                shape::Linear{},
                transfer::Flip{},
                timestep::Cfl{},
                boundary::Symmetry{.side = side::x_min, .at = 0},
                metal,
                own,
                colder};
  const auto put = [&](int row, const auto& material) {
    solver.fill(geometry::Box<2>{.lower = {0, double(row)}, .upper = {1, row + 1.0}}, material, {.per_axis = 1});
  };
  put(4, colder), put(0, metal), put(2, own);
  solver.run({.until = 1e-6}, observe::Vtp{.stem = scratch.path / "p", .frames = 1, .mirror = {axis::x}},
             observe::Vti{.stem = scratch.path / "g", .frames = 1});
  const double nan = std::nan("");
  const std::string real = "Float32", file = "p_0000.vtp";
  CHECK(reads_back(scratch.path,
                   expectation(file, "body", 1, "UInt32", {0, 1, 2, 0, 1, 2}) +
                       expectation(file, "id", 1, "UInt32", {1, 2, 0, 1, 2, 0}) +
                       expectation(file, "density", 1, real, {2700, 1000, 2700, 2700, 1000, 2700}) +
                       expectation(file, "temperature", 1, real, {300, nan, 200, 300, nan, 200}) +
                       expectation(file, "von_mises_stress", 1, real, {0, nan, 0, 0, nan, 0}) +
                       expectation(file, "marker", 1, real, {nan, 7, nan, nan, 7, nan}) +
                       expectation(file, "drift", 3, real,
                                   {nan, nan, nan, 2, 2, 0, nan, nan, nan, nan, nan, nan, -2, 2, 0, nan, nan, nan})));
}

TEST_CASE("vtp and vti: frame times, what a metal has, any number of threads", "[frames]") {
  const Scratch scratch;
  for (const int threads : {1, 3}) {
    auto solver = scene(threads, 0);
    fill(solver);
    const auto to = scratch.path / std::to_string(threads);
    solver.run({.until = 1e-3}, observe::Vtp{.stem = to / "p", .every = 0.4e-3, .mirror = {axis::x, axis::y}},
               observe::Vti{.stem = to / "g", .frames = 2, .mirror = {axis::x, axis::y}},
               observe::Vti{.stem = to / "none", .frames = 0});
  }
  CHECK(reads_back(scratch.path,
                   "1/p.pvd\tframes\tp_0000.vtp\t0\tp_0001.vtp\t0.0004\tp_0002.vtp\t0.0008\tp_0003.vtp\t0.001\n"
                   "1/g.pvd\tframes\tg_0000.vti\t0\tg_0001.vti\t0.001\n"));
  CHECK_FALSE(fs::exists(scratch.path / "1" / "none_0000.vti"));
  for (const char* name : {"p_0003.vtp", "g_0001.vti"}) {
    const bool same = content(scratch.path / "1" / name) == content(scratch.path / "3" / name);
    CHECK(same);
  }
  const std::string text = content(scratch.path / "1" / "p_0003.vtp");
  for (const char* name : {"velocity", "pressure", "von_mises_stress", "temperature", "plastic_strain", "density", "id",
                           "plastic_work", "volume_ratio"})
    CHECK(text.find('"' + std::string(name) + '"') != std::string::npos);
}

TEST_CASE("vti: a mirrored quarter is the whole, to the last digit", "[frames]") {
  const Scratch scratch;
  for (const bool quarter : {false, true}) {
    auto solver = scene(1, quarter ? 0 : -4);
    fill(solver);
    const auto mirror = quarter ? std::vector{axis::x, axis::y} : std::vector<int>{};
    solver.run({.until = 1e-6},
               observe::Vti{.stem = scratch.path / (quarter ? "quarter" : "whole"), .frames = 1, .mirror = mirror});
  }
  const bool same = content(scratch.path / "quarter_0000.vti") == content(scratch.path / "whole_0000.vti");
  CHECK(same);
}

TEST_CASE("vti: fractions and means on the nodes of one cell, a period, a plane", "[frames]") {
  const Scratch scratch;
  const Material own{eos::LinearBulk{.rho0 = 1000, .bulk_modulus = 2e9}};
  Solver solver{grid::Cartesian<2>{.spacing = 1},
                shape::Linear{},
                transfer::Flip{},
                timestep::Cfl{},
                boundary::Periodic{.axis = axis::x, .from = 0, .to = 3},
                boundary::RigidWall{.side = side::y_min, .at = 0},
                own};
  solver.fill(geometry::Box<2>{.lower = {2, 0}, .upper = {3, 1}}, own, {.per_axis = 1, .velocity = {3, 4}});
  solver.run({.until = 1e-6}, observe::Vti{.stem = scratch.path / "g", .frames = 1});
  // one particle at (2.5, 0.5): a quarter of its volume to each of four nodes, those on the wall have half a cell
  const std::string file = "g_0000.vti";
  CHECK(reads_back(
      scratch.path,
      file + "\tlattice\t0\t0\t0\t1\t1\t1\t0\t3\t0\t2\t0\t0\n" +
          expectation(file, "volume_fraction", 1, "Float32", {.5, 0, .5, .5, .25, 0, .25, .25, 0, 0, 0, 0}) +
          expectation(file, "density", 1, "Float32", {1000, 0, 1000, 1000, 1000, 0, 1000, 1000, 0, 0, 0, 0}) +
          expectation(file, "velocity", 3, "Float32", {3, 4, 0, 0, 0, 0, 3, 4, 0, 3, 4, 0, 3, 4, 0, 0, 0, 0,
                                                       3, 4, 0, 3, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})));
  CHECK(content(scratch.path / file).find("temperature") == std::string::npos);
  observe::Vti none{.stem = scratch.path / "n", .mirror = {axis::x}};
  CHECK_THROWS_AS(solver.run({.until = 1}, none), InputError);
}
