/// \file
/// The cavity program's options, in the paper's units: um, ns, m/s, K, MPa.
#pragma once

#include <cstdint>
#include <mote/sleep/quiescent.hpp>
#include <optional>
#include <stdexcept>
#include <string>

namespace cavity {

enum class Shape { linear, gimp, cpgimp, quadratic, cubic };
enum class Transfer { flip, apic, aflip, xpic, fmpm };
enum class Update { usl, musl, usf };
enum class Precision { single_, double_ };
enum class Domain { full, quarter };
enum class Fill { lattice, fraction };

/// The body, um: [-half_width, half_width]^2 x [0, height].
inline constexpr double half_width = 20, height = 50;

/// What a run is made of. The initial values are the preset `accurate`.
struct Options {
  std::string preset = "accurate";
  double speed = 100;    ///< m/s, away from the wall
  double until = 15;     ///< ns
  double radius = 5;     ///< um; 0: no cavity
  double centre_z = 10;  ///< um
  double spacing = 1;    ///< um
  int per_axis = 2;
  Fill fill = Fill::fraction;
  double jitter = 0;
  std::int64_t seed = 0;
  Shape shape = Shape::quadratic;
  Transfer transfer = Transfer::aflip;
  std::optional<double> flip_blend;  ///< the transfer's own unless given
  std::optional<int> order;          ///< of XPIC, FMPM and AffineFlip; the transfers' own unless given
  Update update = Update::usl;
  double courant = 0.4;
  Domain domain = Domain::quarter;
  int threads = 0;  ///< 0: all
  Precision precision = Precision::double_;
  double yield = 120, hardening = 384;  ///< MPa
  double conductivity = 0;              ///< W/(m K)
  std::optional<bool> sleep;            ///< on unless given, or heat is conducted; check() decides
  double sleep_tolerance = mote::sleep::Quiescent{}.tolerance;
  std::string out = "cavity-out";
  bool overwrite = false;
  double sample = 0.1;  ///< ns
  int frames = 16;
  bool dry_run = false, quiet = false;
};

/// Something about the command line is wrong; one sentence. Exit code 2.
struct BadOption : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// --help or --version was asked for; the text to print. Exit code 0.
struct Information : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads the command line over its preset and checks every value. Throws BadOption, Information.
Options parse(int argc, const char* const* argv);

/// Throws BadOption unless the values lie in their ranges and fit together; snaps the spacing to a part of the body.
void check(Options& options);

/// Makes the output directory fit to be written to: refuses what is in the way, removes an earlier run's files if told
/// to overwrite, and tries a file. Throws BadOption.
void prepare_directory(const Options& options);

/// The same refusals, touching nothing.
void check_directory(const Options& options);

// The words of the command line.
std::string to_string(Shape value);
std::string to_string(Transfer value);
std::string to_string(Update value);
std::string to_string(Precision value);
std::string to_string(Domain value);
std::string to_string(Fill value);

}  // namespace cavity
