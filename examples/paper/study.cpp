/// \file
/// paper_study: the cavity program's scene and default scheme with one reading of the paper's equations, and with
/// frames at chosen times:
///
///     paper_study [--material NAME] [--frame-times T,T,...] [--particle-times T,T,...] [options of cavity]
///
/// Times in ns. `--material list` names the readings. Frames hold the quarter that is simulated. Exit codes as
/// cavity's.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../cavity/report.hpp"
#include "study.hpp"

namespace {

using cavity::BadOption;

const std::vector<study::Choice>& choices() {
  static const auto all = [] {
    auto list = study::choices_numbers;
    for (const auto* more : {&study::choices_eos, &study::choices_strength})
      list.insert(list.end(), more->begin(), more->end());
    return list;
  }();
  return all;
}

const study::Choice& find(const std::string& name) {
  std::string names;
  for (const auto& choice : choices()) {
    if (name == choice.name) return choice;
    names += std::string(names.empty() ? "" : ", ") + choice.name;
  }
  throw BadOption("--material is '" + name + "'; choose one of " + names);
}

std::vector<double> read_times(const std::string& option, const std::string& list) {
  std::vector<double> times;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    char* end = nullptr;
    const double time = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !(time >= 0) || (!times.empty() && time <= times.back()))
      throw BadOption(option + " is '" + list + "'; it must be rising times in ns, with commas between");
    times.push_back(time);
  }
  return times;
}

/// Takes this program's own options out of the command line.
study::Extra take(std::vector<const char*>& words) {
  study::Extra extra;
  std::vector<const char*> rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    if (word != "--material" && word != "--frame-times" && word != "--particle-times") {
      rest.push_back(words[i]);
      continue;
    }
    if (++i == words.size()) throw BadOption(word + " has no value");
    if (word == "--material")
      extra.material = words[i];
    else
      (word == "--frame-times" ? extra.frames : extra.particles) = read_times(word, words[i]);
  }
  words = rest;
  return extra;
}

void demand_default_scheme(const cavity::Options& o) {
  const cavity::Options usual;
  if (o.shape != usual.shape || o.transfer != usual.transfer || o.update != usual.update || o.domain != usual.domain ||
      o.precision != usual.precision || o.conductivity > 0)
    throw BadOption(
        "paper_study runs the default scheme only, on a quarter and without conduction; cavity runs others");
}

/// summary.json as cavity writes it, and what this program adds to the configuration.
void write_summary(const cavity::Options& o, const study::Extra& extra, const cavity::Result& result, double seconds) {
  cavity::write_summary(o, result, seconds);
  const auto file = std::filesystem::path(o.out) / "summary.json";
  auto summary = nlohmann::ordered_json::parse(std::ifstream(file));
  summary["configuration"]["material"] = extra.material;
  summary["configuration"]["frame_times_ns"] = extra.frames;
  summary["configuration"]["particle_times_ns"] = extra.particles;
  mote::observe::OutputFile to{file};
  to.write(summary.dump(2) + "\n");
  to.close();
}

int run(std::vector<const char*> words) {
  const study::Extra extra = take(words);
  if (extra.material == "list") {
    for (const auto& choice : choices()) std::printf("%-18s%s\n", choice.name, choice.what);
    return 0;
  }
  const auto& choice = find(extra.material);
  const cavity::Options options = cavity::parse(int(words.size()), words.data());
  demand_default_scheme(options);
  if (options.dry_run) {
    cavity::Combination parts{};
    parts.bytes_per_particle =
        cavity::bytes_per_particle<mote::shape::QuadraticBSpline, mote::transfer::AffineFlip, double>();
    cavity::check_directory(options);
    std::printf("%s", cavity::plan(options, parts).c_str());
    return 0;
  }
  cavity::prepare_directory(options);
  const cavity::Voice voice{
      .progress =
          [&](const std::string& line) { options.quiet ? void() : void(std::fprintf(stderr, "%s\n", line.c_str())); },
      .seconds = 10,
      .notice = [](const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }};
  const auto start = std::chrono::steady_clock::now();
  const auto result = choice.run(options, extra, voice);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_summary(options, extra, result, wall);
  if (!result.failure.empty()) throw mote::NumericalError(result.failure);
  std::printf("%s", cavity::closing_words(options, result, wall).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv, argv + argc});
  } catch (const cavity::Information& information) {
    std::printf("%s", information.what());
    return 0;
  } catch (const BadOption& error) {
    std::fprintf(stderr, "paper_study: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "paper_study: %s\n", error.what());
    return 1;
  }
}
