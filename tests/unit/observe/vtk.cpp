// VTK files: what is written is what VTK's own readers find (through read_vtk.py, if VTK's Python module is there).
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mote/observe/vtk.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace mote::observe;

struct Scratch {
  fs::path path = fs::temp_directory_path() / ("mote_vtk_" + std::to_string(::getpid()));
  Scratch() { fs::remove_all(path); }
  ~Scratch() { fs::remove_all(path); }
};

int run(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// A Python that knows VTK, or "". The system's own comes first: another one in PATH may lack the module.
const std::string& python() {
  static const std::string found = [] {
    for (const std::string candidate : {"/usr/bin/python3", "python3"})
      if (run(candidate + " -c 'import vtk' >/dev/null 2>&1") == 0) return candidate;
    return std::string();
  }();
  return found;
}

/// Runs read_vtk.py; its exit code.
int read_back(const fs::path& directory, const std::string& options = "") {
  const auto script = fs::absolute(__FILE__).parent_path() / "read_vtk.py";
  return run(python() + " -B '" + script.string() + "' '" + directory.string() + "' " + options + " > '" +
             (directory / "said.txt").string() + "' 2>&1");
}

std::string content(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

#define NEEDS_VTK()                                                                              \
  if (python().empty()) {                                                                        \
    WARN("SKIPPED: no Python with `import vtk` (python3-vtk9), so the files are not read back"); \
    return;                                                                                      \
  }

/// Collects what read_vtk.py is to find.
struct Expectations {
  std::string lines;
  template <class T>
  void array(const std::string& file, const std::string& kind, const std::string& name, int components,
             const std::string& type, const std::vector<T>& values) {
    lines += file + '\t' + kind + '\t' + name + '\t' + std::to_string(components) + '\t' + type;
    for (const T value : values) append_number(lines += '\t', value);
    lines += '\n';
  }
};

template <class T>
std::vector<T> numbers(std::size_t count, double scale) {
  std::vector<T> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = T((double(i * 7919 % 1009) + 1) * scale);
  return out;
}

/// Writes `count` particles and says what they are.
void write_particles(const fs::path& directory, const std::string& file, std::size_t count, double time,
                     Expectations& expected) {
  const auto points = numbers<double>(3 * count, 1e-7 / 3);
  const auto velocity = numbers<float>(3 * count, -0.7);
  const auto affine = numbers<double>(9 * count, 1e300);
  const auto id = numbers<std::uint32_t>(count, 4e6);
  const auto offset = numbers<std::int64_t>(count, -9e15);
  write_vtp(directory / file, points,
            {{"velocity", 3, velocity}, {"affine <C> & \"more\"", 9, affine}, {"id", 1, id}, {"offset", 1, offset}},
            time);
  expected.array(file, "points", "Points", 3, "Float64", points);
  expected.array(file, "point", "velocity", 3, "Float32", velocity);
  expected.array(file, "point", "affine <C> & \"more\"", 9, "Float64", affine);
  expected.array(file, "point", "id", 1, "UInt32", id);
  expected.array(file, "point", "offset", 1, "Int64", offset);
  expected.array(file, "field", "TimeValue", 1, "Float64", std::vector{time});
}

/// Writes a lattice and says what it is.
void write_lattice(const fs::path& directory, const std::string& file, const Lattice& lattice, double time,
                   Expectations& expected) {
  const auto mass = numbers<double>(lattice.nodes(), 1e-15);
  const auto momentum = numbers<float>(3 * lattice.nodes(), 0.1);
  const auto active = numbers<std::uint32_t>(lattice.cells(), 1);
  write_vti(directory / file, lattice, {{"mass", 1, mass}, {"momentum", 3, momentum}}, {{"active", 1, active}}, time);
  expected.array(file, "point", "mass", 1, "Float64", mass);
  expected.array(file, "point", "momentum", 3, "Float32", momentum);
  expected.array(file, "cell", "active", 1, "UInt32", active);
  expected.array(file, "field", "TimeValue", 1, "Float64", std::vector{time});
  expected.lines += file + "\tlattice";
  for (const double x : lattice.origin) append_number(expected.lines += '\t', x);
  for (const double x : lattice.spacing) append_number(expected.lines += '\t', x);
  for (const int x : lattice.extent) append_number(expected.lines += '\t', x);
  expected.lines += '\n';
}

void check(const fs::path& directory, const Expectations& expected) {
  std::ofstream(directory / "expected.tsv") << expected.lines;
  const int code = read_back(directory, "--expect '" + (directory / "expected.tsv").string() + "'");
  INFO(content(directory / "said.txt"));
  CHECK(code == 0);
}

std::string base64_of(const std::string& bytes, std::size_t piece) {
  const Scratch scratch;
  OutputFile out{scratch.path / "text"};
  detail::Base64 base64{out};
  for (std::size_t i = 0; i < bytes.size(); i += piece)
    base64.write(bytes.data() + i, std::min(piece, bytes.size() - i));
  base64.finish();
  out.close();
  return content(scratch.path / "text");
}

}  // namespace

TEST_CASE("base64 as in RFC 4648, whatever the pieces", "[observe][vtk]") {
  const std::vector<std::pair<std::string, std::string>> known{{"", ""},
                                                               {"f", "Zg=="},
                                                               {"fo", "Zm8="},
                                                               {"foo", "Zm9v"},
                                                               {"foob", "Zm9vYg=="},
                                                               {"fooba", "Zm9vYmE="},
                                                               {"foobar", "Zm9vYmFy"},
                                                               {"\xff\xfe\xfb", "//77"}};
  for (const auto& [plain, encoded] : known)
    for (const std::size_t piece : {1u, 2u, 3u, 4u, 5u, 7u}) CHECK(base64_of(plain, piece) == encoded);
  std::string large(200001, ' ');
  for (std::size_t i = 0; i < large.size(); ++i) large[i] = char(i * i % 251);
  const auto whole = base64_of(large, large.size());
  CHECK(whole.size() == 4 * 66667);
  CHECK(base64_of(large, 1001) == whole);
  CHECK(base64_of(large, 49153) == whole);
}

TEST_CASE("VTK reads particles back", "[observe][vtk]") {
  NEEDS_VTK();
  const Scratch scratch;
  Expectations expected;
  for (const std::size_t count : {1u, 2u, 3u, 5000u})
    write_particles(scratch.path, "p" + std::to_string(count) + ".vtp", count, 1e-9 / 3 * double(count), expected);
  write_vtp(scratch.path / "none.vtp", std::span<const float>(), {{"id", 1, std::span<const float>()}}, 0);
  check(scratch.path, expected);
}

TEST_CASE("VTK reads lattices back", "[observe][vtk]") {
  NEEDS_VTK();
  const Scratch scratch;
  Expectations expected;
  const std::array<double, 3> origin{1e-6 / 3, -2e-6, 0.5}, spacing{1e-6, 2e-6, 0.1};
  write_lattice(scratch.path, "three.vti", {origin, spacing, {-2, 3, 4, 8, -7, -1}}, 2e-9, expected);
  write_lattice(scratch.path, "two.vti", {origin, spacing, {-2, 3, 4, 8, 0, 0}}, 0, expected);
  write_lattice(scratch.path, "one.vti", {origin, spacing, {-2, 30, 0, 0, 0, 0}}, 0, expected);
  check(scratch.path, expected);
}

TEST_CASE("a collection is complete after each frame", "[observe][vtk]") {
  NEEDS_VTK();
  const Scratch scratch;
  Collection collection{scratch.path / "frames" / "particles.pvd"};
  Expectations expected;
  std::string frames = "frames/particles.pvd\tframes";
  for (int i = 0; i < 3; ++i) {
    const std::string name = "p" + std::to_string(i) + ".vtp";
    const std::string file = i < 2 ? "frames/" + name : name;
    const double time = 0.1e-9 * i;
    write_particles(scratch.path, file, 4, time, expected);
    collection.add(scratch.path / file, time);
    append_number(frames += '\t' + (i < 2 ? name : "../" + name) + '\t', time);
    Expectations now{expected.lines + frames + '\n'};
    check(scratch.path, now);
  }
}

TEST_CASE("the check of a run's files notices what is wrong", "[observe][vtk]") {
  NEEDS_VTK();
  const Scratch scratch;
  const auto file = scratch.path / "a.vtp";
  std::vector<float> points{0, 0, 0, 1, 1, 1}, p{1, 2};
  write_vtp(file, points, {{"p", 1, p}}, 1);
  REQUIRE(read_back(scratch.path) == 0);
  std::string reason;
  SECTION("a number that is not finite") {
    p[1] = std::numeric_limits<float>::quiet_NaN();
    write_vtp(file, points, {{"p", 1, p}}, 1);
    reason = "the array p is not finite at point 1";
  }
  SECTION("half a file") {
    fs::resize_file(file, fs::file_size(file) / 2);
    reason = "not well-formed";
  }
  SECTION("too few numbers") {
    auto text = content(file);
    const std::string head = "NumberOfPoints=\"2\" NumberOfVerts=\"2\"";
    text.replace(text.find(head), head.size(), "NumberOfPoints=\"3\" NumberOfVerts=\"2\"");
    std::ofstream(file) << text;
    reason = "a.vtp";
  }
  SECTION("a frame with another time") {
    Collection(scratch.path / "all.pvd").add(file, 2);
    reason = "carries another time";
  }
  SECTION("a frame that is missing") {
    Collection(scratch.path / "all.pvd").add(scratch.path / "b.vtp", 1);
    reason = "b.vtp, which is missing";
  }
  SECTION("nothing there") {
    fs::remove(file);
    reason = "there is no .vtp";
  }
  CHECK(read_back(scratch.path) == 1);
  CHECK_THAT(content(scratch.path / "said.txt"), Catch::Contains(reason));
}

TEST_CASE("arrays that do not fit are refused before a file is made", "[observe][vtk]") {
  const Scratch scratch;
  const auto file = scratch.path / "a.vtp";
  const std::vector<float> points(6), two(2), three(3);
  CHECK_THROWS_AS(write_vtp(file, two, {}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vtp(file, points, {{"p", 1, three}}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vtp(file, points, {{"p", 0, two}}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vtp(file, points, {{"p", 1, two}, {"p", 1, two}}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vtp(file, points, {}, std::numeric_limits<double>::infinity()), mote::InputError);
  const Lattice lattice{.origin = {}, .spacing = {1, 1, 1}, .extent = {0, 1, 0, 0, 0, 0}};
  CHECK_THROWS_AS(write_vti(file, lattice, {}, {{"p", 1, two}}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vti(file, lattice, {{"p", 1, three}}, {}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vti(file, {{}, {1, 1, 0}, {0, 1, 0, 0, 0, 0}}, {}, {}, 0), mote::InputError);
  CHECK_THROWS_AS(write_vti(file, {{}, {1, 1, 1}, {0, 1, 0, -1, 0, 0}}, {}, {}, 0), mote::InputError);
  CHECK_FALSE(fs::exists(scratch.path));
}

TEST_CASE("a frame on a full disk is reported", "[observe][vtk]") {
  const Scratch scratch;
  fs::create_directory(scratch.path);
  fs::create_symlink("/dev/full", scratch.path / "a.vtp");
  fs::create_symlink("/dev/full", scratch.path / "a.pvd");
  CHECK_THROWS_AS(write_vtp(scratch.path / "a.vtp", std::vector<float>(6), {}, 0), mote::OutputError);
  CHECK_THROWS_AS(Collection(scratch.path / "a.pvd").add("b.vtp", 0), mote::OutputError);
}
