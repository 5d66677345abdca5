/// \file
/// Refusals: every value in its range, everything fitting together, a directory to write to.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <mote/core/error.hpp>

#include "options.hpp"

namespace cavity {

namespace {

namespace fs = std::filesystem;
using mote::text;

template <class... Args>
void demand(bool ok, const Args&... args) {
  if (!ok) throw BadOption(text(args...));
}

void check_body(const Options& o) {
  demand(std::abs(o.speed) <= 5000, "--speed is ", o.speed, " m/s; it must be from -5000 to 5000");
  demand(o.until > 0 && o.until <= 1e6, "--until is ", o.until, " ns; it must be > 0 and at most 1e6");
  demand(o.yield > 0 && o.yield <= 1e5, "--yield is ", o.yield, " MPa; it must be > 0 and at most 1e5");
  demand(o.hardening >= 0 && o.hardening <= 1e5, "--hardening is ", o.hardening, " MPa; it must be from 0 to 1e5");
}

void check_conduction(Options& o) {
  demand(o.conductivity >= 0 && o.conductivity <= 1e5, "--conductivity is ", o.conductivity,
         " W/(m K); it must be from 0 to 1e5");
  if (o.conductivity > 0) {
    demand(!o.sleep.value_or(false), "--sleep on does not go with --conductivity ", o.conductivity,
           ": heat flows in material at rest too; it needs --sleep off");
    demand(o.shape != Shape::linear || o.fill == Fill::lattice, "--fill fraction does not go with --conductivity ",
           o.conductivity, " and --shape linear, which slivers can make unstable; it needs --fill lattice");
  }
  o.sleep = o.sleep.value_or(o.conductivity == 0);
}

void check_cavity(const Options& o) {
  demand(o.radius >= 0 && std::isfinite(o.radius), "--radius is ", o.radius, " um; it must be >= 0 (0: no cavity)");
  if (o.radius == 0) return;
  demand(o.centre_z > 0 && o.centre_z < height, "--centre-z is ", o.centre_z,
         " um, outside the body; it must lie between 0 and ", height);
  demand(o.radius < o.centre_z, "--radius is ", o.radius, " um: the cavity touches the wall; with --centre-z ",
         o.centre_z, " it must be below ", o.centre_z);
  demand(o.radius < height - o.centre_z, "--radius is ", o.radius,
         " um: the cavity touches the free surface; with --centre-z ", o.centre_z, " it must be below ",
         height - o.centre_z);
  demand(o.radius < half_width, "--radius is ", o.radius,
         " um: the cavity touches its periodic image; it must be below ", half_width);
  demand(o.radius >= o.spacing, "--radius is ", o.radius, " um, less than a cell; it must be 0 or at least --spacing, ",
         o.spacing, " um");
}

void check_mesh(Options& o) {
  demand(o.spacing > 0 && std::isfinite(o.spacing), "--spacing is ", o.spacing, " um; it must be > 0");
  // half_width and height are whole numbers of cells if their common divisor, 10 um, is
  const double common = 10, cells = std::round(common / o.spacing);
  demand(cells >= 1 && std::abs(common / o.spacing - cells) < 1e-5 * cells, "--spacing is ", o.spacing,
         " um, which does not divide the body; it must be 10 um over a whole number, e.g. 2, 1.25, 1 or 0.5");
  o.spacing = common / cells;
  demand(o.per_axis >= 1 && o.per_axis <= 8, "--per-axis is ", o.per_axis, "; it must be from 1 to 8");
  const double sites = 4 * half_width * half_width * height * std::pow(o.per_axis / o.spacing, 3);
  demand(sites < 0x1p31, "--spacing ", o.spacing, " um with --per-axis ", o.per_axis, " makes ", sites,
         " particles in the whole body; the most is 2^31");
  demand(o.jitter >= 0 && o.jitter <= 0.5, "--jitter is ", o.jitter, "; it must be from 0 to 0.5");
  demand(o.seed >= 0, "--seed is ", o.seed, "; it must be >= 0");
}

void check_method(const Options& o) {
  demand(!o.flip_blend || o.transfer == Transfer::flip || o.transfer == Transfer::aflip,
         "--flip-blend does not go with --transfer ", to_string(o.transfer), "; it needs --transfer flip or aflip");
  demand(!o.flip_blend || (*o.flip_blend >= 0 && *o.flip_blend <= 1), "--flip-blend is ", o.flip_blend.value_or(0),
         "; it must be from 0 to 1");
  demand(!o.order || o.transfer == Transfer::xpic || o.transfer == Transfer::fmpm || o.transfer == Transfer::aflip,
         "--order does not go with --transfer ", to_string(o.transfer), "; it needs --transfer xpic, fmpm or aflip");
  demand(!o.order || (*o.order >= 1 && *o.order <= 40), "--order is ", o.order.value_or(0),
         "; it must be from 1 to 40");
  demand(o.courant >= 1e-3 && o.courant <= 1, "--courant is ", o.courant, "; it must be from 0.001 to 1");
  demand(o.sleep_tolerance > 0 && o.sleep_tolerance < 1, "--sleep-tolerance is ", o.sleep_tolerance,
         "; it must be > 0 and < 1");
  demand(o.threads >= 0 && o.threads <= 1024, "--threads is ", o.threads, "; it must be from 0 (all) to 1024");
}

void check_output(const Options& o) {
  demand(!o.out.empty(), "--out is empty; it must name a directory");
  demand(o.sample > 0 && std::isfinite(o.sample), "--sample is ", o.sample, " ns; it must be > 0");
  demand(o.until / o.sample <= 1e6, "--sample is ", o.sample, " ns, which makes more than a million rows until ",
         o.until, " ns; it must be at least ", o.until / 1e6);
  demand(o.frames == 0 || (o.frames >= 2 && o.frames <= 9999), "--frames is ", o.frames,
         "; it must be 0 (none) or from 2 (first and last) to 9999");
}

/// Leaves nothing of an earlier run that this one might not replace.
void remove_earlier(const fs::path& out) {
  std::error_code ignored;
  for (const char* name : {"axis.csv", "summary.json"}) fs::remove(out / name, ignored);
  for (const char* part : {"frames", "pictures"})
    for (const auto& entry : fs::directory_iterator(out / part, ignored)) {
      const auto kind = entry.path().extension();
      if (kind == ".vtp" || kind == ".vti" || kind == ".pvd" || kind == ".png") fs::remove(entry.path(), ignored);
    }
}

}  // namespace

void check(Options& options) {
  check_body(options);
  check_mesh(options);
  check_cavity(options);
  check_method(options);
  check_conduction(options);
  check_output(options);
}

void check_directory(const Options& options) {
  std::error_code error;
  const fs::path out = options.out;
  const auto status = fs::status(out, error);
  demand(!fs::exists(status) || fs::is_directory(status), "--out ", options.out, " is there and is no directory");
  if (!fs::exists(status)) return;
  const bool empty = fs::is_empty(out, error);
  demand(!error, "--out ", options.out, " cannot be read: ", error.message());
  demand(empty || options.overwrite, "--out ", options.out,
         " is not empty; name another directory, or say --overwrite to replace the run in it");
}

void prepare_directory(const Options& options) {
  check_directory(options);
  const fs::path out = options.out;
  std::error_code error;
  fs::create_directories(out, error);
  demand(!error, "--out ", options.out, " cannot be made: ", error.message());
  const auto trial = out / ".trial";
  const bool good = bool(std::ofstream(trial) << "x" << std::flush);
  fs::remove(trial, error);
  demand(good, "--out ", options.out, " cannot be written to");
  remove_earlier(out);
}

}  // namespace cavity
