// Files are complete or reported; what was written before an error stays.
#include <sys/resource.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mote/observe/file.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using mote::observe::LineFile;
using mote::observe::OutputFile;

/// An empty directory that goes away with the test.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("mote_file_" + std::to_string(::getpid()));
  Scratch() {
    fs::remove_all(path);
    fs::create_directory(path);
  }
  ~Scratch() { fs::remove_all(path); }
};

/// While it lives, files of this process end at `bytes`, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

std::string content(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path).rdbuf();
  return out.str();
}

template <class Action>
std::string complaint(Action&& action) {
  try {
    action();
  } catch (const mote::OutputError& error) {
    return error.what();
  }
  return "no OutputError";
}

const auto full = [](const fs::path& name) {
  return "mote: cannot write " + name.string() + ": No space left on device";
};

}  // namespace

TEST_CASE("a whole file appears under its name when it is closed", "[observe][file]") {
  const Scratch scratch;
  const auto name = scratch.path / "made" / "on the way" / "a.txt";
  OutputFile file{name};
  file.write("one\n");
  file.write(std::string_view("\0two", 4));
  CHECK_FALSE(fs::exists(name));
  CHECK(fs::exists(name.string() + ".part"));
  file.close();
  file.close();
  CHECK(content(name) == std::string("one\n\0two", 8));
  CHECK_FALSE(fs::exists(name.string() + ".part"));
  CHECK_THROWS_AS(file.write("more"), mote::UsageError);
}

TEST_CASE("a whole file that is not closed leaves the old one", "[observe][file]") {
  const Scratch scratch;
  const auto name = scratch.path / "a.txt";
  std::ofstream(name) << "old";
  { OutputFile{name}.write("new"); }
  CHECK(content(name) == "old");
  CHECK_FALSE(fs::exists(name.string() + ".part"));
}

TEST_CASE("a link to a file stays a link", "[observe][file]") {
  const Scratch scratch;
  std::ofstream(scratch.path / "real.txt") << "old";
  fs::create_symlink("real.txt", scratch.path / "link.txt");
  OutputFile file{scratch.path / "link.txt"};
  file.write("new");
  file.close();
  CHECK(fs::is_symlink(scratch.path / "link.txt"));
  CHECK(content(scratch.path / "real.txt") == "new");
}

TEST_CASE("a full disk is reported for a whole file", "[observe][file]") {
  const Scratch scratch;
  const auto name = scratch.path / "a.txt";
  SECTION("that is a device itself") {
    fs::create_symlink("/dev/full", name);
    OutputFile file{name};
    file.write(std::string(100, 'x'));  // looks good until close
    CHECK(complaint([&] { file.close(); }) == full(name));
    CHECK(fs::is_character_file("/dev/full"));
  }
  SECTION("under way, and the old file stays") {
    std::ofstream(name) << "old";
    fs::create_symlink("/dev/full", name.string() + ".part");
    {
      OutputFile file{name};
      CHECK(complaint([&] { file.write(std::string(1 << 20, 'x')); }) == full(name));
      CHECK(complaint([&] { file.close(); }) == full(name));
    }
    CHECK(content(name) == "old");
    CHECK_FALSE(fs::is_symlink(name.string() + ".part"));
  }
}

TEST_CASE("a file that cannot be made is reported with its reason", "[observe][file]") {
  const Scratch scratch;
  std::ofstream(scratch.path / "plain") << "a file, not a directory";
  const auto inside = scratch.path / "plain" / "a.txt";
  const auto reason = "mote: cannot write " + inside.string() + ": its directory cannot be made: Not a directory";
  CHECK(complaint([&] { OutputFile{inside}; }) == reason);
  CHECK(complaint([&] { LineFile(inside, "a,b"); }) == reason);
  CHECK(complaint([&] { OutputFile{scratch.path}; }) ==
        "mote: cannot write " + scratch.path.string() + ": Is a directory");
  CHECK(complaint([&] {
          OutputFile file{scratch.path / "moved" / "a.txt"};
          fs::remove_all(scratch.path / "moved");
          file.close();
        }).ends_with("No such file or directory"));
  CHECK_THROWS_AS(OutputFile{""}, mote::InputError);
  CHECK_THROWS_AS(OutputFile{"directory/"}, mote::InputError);
}

TEST_CASE("rows can be read while the file is open", "[observe][file]") {
  const Scratch scratch;
  const auto name = scratch.path / "out" / "history.csv";
  LineFile file{name, "time_ns,step,p_mpa"};
  CHECK(content(name) == "time_ns,step,p_mpa\n");
  file.row(0.1, 1000000, -2.5f);
  file.row(std::vector<double>{1e-9, 3e6, -1e300});
  CHECK(content(name) == "time_ns,step,p_mpa\n0.1,1000000,-2.5\n1e-09,3000000,-1e+300\n");
  CHECK_THROWS_AS(file.row(1, 2), mote::InputError);
  CHECK_THROWS_AS(file.row(std::vector<double>(4)), mote::InputError);
  CHECK_THROWS_AS(file.row(std::vector<double>()), mote::InputError);
  LineFile moved = std::move(file);
  moved.row(1, 2, 3);
  moved.close();
  CHECK(content(name).ends_with("-1e+300\n1,2,3\n"));
  CHECK_THROWS_AS(moved.row(1, 2, 3), mote::OutputError);
}

TEST_CASE("numbers are written so that they read back the same", "[observe][file]") {
  for (const double value : {0.1, 1.0 / 3, 1e15, 123456789012345.0, 5e-324, 1.7976931348623157e308, -7.0}) {
    std::string digits;
    mote::observe::append_number(digits, value);
    CHECK(std::strtod(digits.c_str(), nullptr) == value);
  }
}

TEST_CASE("a full disk leaves whole rows", "[observe][file]") {
  const Scratch scratch;
  const auto name = scratch.path / "history.csv";
  SECTION("on a full device the header fails") {
    fs::create_symlink("/dev/full", name);
    CHECK(complaint([&] { LineFile(name, "a,b"); }) == full(name));
  }
  SECTION("a row that fits only in part is taken back") {
    LineFile file{name, "a,b"};
    std::string said;
    {
      const SmallDisk disk{18};
      said = complaint([&] {
        for (int i = 0; i < 10; ++i) file.row(1000 + i, 25);
      });
    }
    CHECK(said == "mote: cannot write " + name.string() + ": File too large");
    CHECK(content(name) == "a,b\n1000,25\n");
    CHECK_THROWS_AS(file.row(1, 2), mote::OutputError);
  }
}
