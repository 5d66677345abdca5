/// \file
/// cavity: options in, files out. Exit codes: 0 done, 1 the run failed, 2 the command line is wrong.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <new>

#include "report.hpp"

namespace cavity {

namespace {

/// The line of progress: one that rewrites itself on a terminal, else a line every ten seconds.
class ProgressLine {
 public:
  Voice voice(bool quiet) {
    return {.progress = [this, quiet](const std::string& line) { quiet ? void() : show(line); },
            .seconds = terminal_ ? 0.2 : 10,
            .notice = [this](const std::string& sentence) { say(sentence); }};
  }
  /// Ends the line, so that what follows begins at the left.
  void finish() {
    if (open_) std::fputc('\n', stderr);
    open_ = false;
  }
  void say(const std::string& sentence) {
    finish();
    std::fprintf(stderr, "%s\n", sentence.c_str());
  }

 private:
  void show(const std::string& line) {
    std::fprintf(stderr, terminal_ ? "\r\033[K%s" : "%s\n", line.c_str());
    std::fflush(stderr);
    open_ = terminal_;
  }

  bool terminal_ = isatty(STDERR_FILENO) != 0, open_ = false;
};

int simulate(const Options& options, ProgressLine& line) {
  const auto& combination = find_combination(options);
  if (options.dry_run) {
    check_directory(options);
    std::cout << plan(options, combination);
    return 0;
  }
  prepare_directory(options);
  const auto start = std::chrono::steady_clock::now();
  const Result result = combination.simulate(options, line.voice(options.quiet));
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  line.finish();
  write_summary(options, result, wall);
  if (!result.failure.empty()) throw mote::NumericalError(result.failure);
  std::cout << closing_words(options, result, wall);
  return 0;
}

}  // namespace

int run(int argc, const char* const* argv) {
  ProgressLine line;
  const auto complain = [&](int code, const char* what) {
    const std::string sentence = what;
    const bool named = sentence.starts_with("mote: ");
    line.say("cavity: " + (named ? sentence.substr(6) : sentence));
    return code;
  };
  try {
    return simulate(parse(argc, argv), line);
  } catch (const Information& information) {
    std::cout << information.what();
    return 0;
  } catch (const BadOption& error) {
    return complain(2, error.what());
  } catch (const mote::InputError& error) {
    return complain(2, error.what());
  } catch (const std::bad_alloc&) {
    return complain(1, "there is not enough memory for this run; --dry-run estimates what it needs");
  } catch (const std::exception& error) {
    return complain(1, error.what());
  }
}

}  // namespace cavity

int main(int argc, char** argv) { return cavity::run(argc, argv); }
