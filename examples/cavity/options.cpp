#include "options.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <mote/core/error.hpp>
#include <mote/core/version.hpp>
#include <utility>

namespace cavity {

namespace {

using mote::text;

/// An option whose values are words.
template <class Enum>
struct Words {
  const char* option;
  std::vector<std::pair<const char*, Enum>> available;

  std::string list() const {
    std::string all;
    for (std::size_t i = 0; i < available.size(); ++i)
      all += text(i == 0 ? "" : i + 1 == available.size() ? " or " : ", ", available[i].first);
    return all;
  }
  Enum value(const std::string& word) const {
    for (const auto& [name, value] : available)
      if (word == name) return value;
    throw BadOption(text("--", option, " is '", word, "'; choose ", list()));
  }
  std::string word(Enum value) const {
    for (const auto& [name, other] : available)
      if (other == value) return name;
    return {};
  }
};

// gimp is what other codes call so: domains of constant size; those of cpgimp follow the particles' stretch
const Words<Shape> shapes{"shape",
                          {{"linear", Shape::linear},
                           {"gimp", Shape::gimp},
                           {"cpgimp", Shape::cpgimp},
                           {"quadratic", Shape::quadratic},
                           {"cubic", Shape::cubic}}};
const Words<Transfer> transfers{"transfer",
                                {{"flip", Transfer::flip},
                                 {"apic", Transfer::apic},
                                 {"aflip", Transfer::aflip},
                                 {"xpic", Transfer::xpic},
                                 {"fmpm", Transfer::fmpm}}};
const Words<Update> updates{"update", {{"usl", Update::usl}, {"musl", Update::musl}, {"usf", Update::usf}}};
const Words<Precision> precisions{"precision", {{"double", Precision::double_}, {"float", Precision::single_}}};
const Words<Domain> domains{"domain", {{"full", Domain::full}, {"quarter", Domain::quarter}}};
const Words<Fill> fills{"fill", {{"lattice", Fill::lattice}, {"fraction", Fill::fraction}}};
const Words<bool> sleeps{"sleep", {{"on", true}, {"off", false}}};

Options preset(const std::string& name) {
  Options o;
  o.preset = name;
  if (name == "accurate") return o;
  if (name != "paper" && name != "quick")
    throw BadOption(text("--preset is '", name, "'; choose paper, accurate or quick"));
  o.shape = Shape::linear;
  o.transfer = Transfer::flip;
  o.update = Update::musl;
  o.fill = Fill::lattice;
  if (name == "paper") {
    o.domain = Domain::full;
  } else {  // the paper's scheme on a quarter, coarser and shorter
    o.spacing = 1.25;
    o.until = 7.2;
    o.frames = 9;
  }
  return o;
}

template <class Enum, class Value>
void add_words(CLI::App& app, const Words<Enum>& words, Value& value, const std::string& help) {
  app.add_option_function<std::string>(
         text("--", words.option), [&](const std::string& word) { value = words.value(word); },
         text(words.list(), ": ", help))
      ->type_name("WORD");
}

void add_scene(CLI::App& app, Options& o) {
  app.add_option("--preset", o.preset, "paper, accurate or quick: sets all the others, which may follow it [accurate]")
      ->type_name("WORD");
  app.add_option("--speed", o.speed, "launch speed away from the wall, m/s; negative: into it [100]");
  app.add_option("--until", o.until, "end of the run, ns [15]");
  app.add_option("--radius", o.radius, "of the cavity, um; 0: no cavity [5]");
  app.add_option("--centre-z", o.centre_z, "height of the cavity's centre over the wall, um [10]");
  app.add_option("--yield", o.yield, "initial yield stress, MPa [120]");
  app.add_option("--hardening", o.hardening, "hardening modulus, MPa [384]");
  app.add_option("--conductivity", o.conductivity, "of heat, W/(m K), 237 in reality; 0: none [0]");
}

void add_method(CLI::App& app, Options& o) {
  app.add_option("--spacing", o.spacing, "of the grid, um; 10 um over a whole number [1]");
  app.add_option("--per-axis", o.per_axis, "particles per cell and axis, 1 to 8 [2]");
  add_words(app, fills, o.fill, "whole particles, or particles cut at the surface [fraction]");
  app.add_option("--jitter", o.jitter, "random displacement in particle distances, 0 to 0.5 [0]");
  app.add_option("--seed", o.seed, "of the jitter [0]");
  add_words(app, shapes, o.shape, "shape functions [quadratic]");
  add_words(app, transfers, o.transfer, "between particles and grid [aflip]");
  app.add_option("--flip-blend", o.flip_blend, "of flip, 1: FLIP, 0: PIC [1]; of aflip [0.85]");
  app.add_option("--order", o.order, "of xpic, fmpm and aflip, 1 to 40; 1: the lumped mass [xpic 5, fmpm 2, aflip 2]");
  add_words(app, updates, o.update, "when stresses are updated [usl]");
  app.add_option("--courant", o.courant, "time step over cell crossing time, up to 1 [0.4]");
  add_words(app, domains, o.domain, "simulate all of the body or one symmetric part [quarter]");
  app.add_option("--threads", o.threads, "0: as many as the machine has [0]");
  add_words(app, precisions, o.precision, "number type [double]");
  add_words(app, sleeps, o.sleep, "skip material that no wave has reached [on; off with --conductivity]");
  app.add_option("--sleep-tolerance", o.sleep_tolerance,
                 text("what counts as a wave, relative [", o.sleep_tolerance, "]"));
}

void add_output(CLI::App& app, Options& o) {
  app.add_option("--out", o.out, "directory for the results [cavity-out]")->type_name("DIR");
  app.add_flag("--overwrite", o.overwrite, "replace an earlier run in that directory");
  app.add_option("--sample", o.sample, "interval of history.csv, ns [0.1]");
  app.add_option("--frames", o.frames, "frames, evenly spaced, first and last included; 0: none [16]");
  app.add_flag("--dry-run", o.dry_run, "show the configuration and what it would cost, then stop");
  app.add_flag("--quiet", o.quiet, "no progress on stderr");
}

/// One pass over the command line.
void read(int argc, const char* const* argv, Options& o) {
  CLI::App app{
      "A spherical cavity in aluminium, torn open by the rarefaction wave from a wall (MPM).\n"
      "Units: um, ns, m/s, K, MPa. Values in brackets: preset accurate.",
      "cavity"};
  app.set_version_flag("--version", text("cavity, mote ", mote::version));
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  add_scene(app, o);
  add_method(app, o);
  add_output(app, o);
  for (int i = 1; i < argc; ++i)
    if (const std::string word = argv[i]; word.empty() || word.back() == '=')
      throw BadOption(text("'", i > 1 && word.empty() ? argv[i - 1] : argv[i], "' has no value"));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw Information(app.help());
  } catch (const CLI::CallForVersion& version) {
    throw Information(text(version.what(), "\n"));
  } catch (const CLI::ExtrasError&) {
    throw BadOption(text("'", app.remaining().at(0), "' is not an option; cavity --help lists them all"));
  } catch (const CLI::ParseError& error) {
    throw BadOption(error.what());
  }
}

}  // namespace

Options parse(int argc, const char* const* argv) {
  Options options;
  read(argc, argv, options);  // to learn the preset
  options = preset(options.preset);
  read(argc, argv, options);
  check(options);
  return options;
}

std::string to_string(Shape value) { return shapes.word(value); }
std::string to_string(Transfer value) { return transfers.word(value); }
std::string to_string(Update value) { return updates.word(value); }
std::string to_string(Precision value) { return precisions.word(value); }
std::string to_string(Domain value) { return domains.word(value); }
std::string to_string(Fill value) { return fills.word(value); }

}  // namespace cavity
