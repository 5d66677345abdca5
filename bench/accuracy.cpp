/// \file
/// How large is the error, and what does it cost? Every combination of shape function, transfer and update on problems
/// with exact solutions, and some on the paper's cavity. Writes CSV to standard output:
///
///     mote_bench_accuracy > accuracy.csv              all but the finest cavity: some ten minutes on one core
///     mote_bench_accuracy quadratic apic aflip bar    only these; words of one kind are alternatives
///     mote_bench_accuracy --finest 0.25 cavity_100    the cavity down to this mesh, um [0.5]
///     bench/plot_accuracy.py accuracy.csv             the pictures of docs/accuracy.md
///
/// Words: bar vortex wave_100 wave_400 wave_-500 cavity_100 cavity_400; linear quadratic cubic cpgimp; flip flip0.99
/// apic aflip xpic fmpm; usl musl usf. Seconds are those of the one thread that steps, without what others do on its
/// core and without observers and exact solutions; h is a part of the body's unit length, or um.
#include "accuracy/families.hpp"

#include <array>
#include <cstdlib>

#include "accuracy/report.hpp"

namespace {

using Family = void (*)(const accuracy::Wanted&);

constexpr std::array<Family, 17> families{
    accuracy::linear_plain,
    accuracy::linear_affine,
    accuracy::linear_sharpened,
    accuracy::quadratic_plain,
    accuracy::quadratic_affine,
    accuracy::quadratic_sharpened,
    accuracy::cubic_plain,
    accuracy::cubic_affine,
    accuracy::cubic_sharpened,
    accuracy::cpgimp_plain,
    accuracy::cpgimp_affine,
    accuracy::cpgimp_sharpened,
    accuracy::cavity_linear,
    accuracy::cavity_quadratic_affine,
    accuracy::cavity_quadratic_plain,
    accuracy::cavity_cubic,
    accuracy::cavity_cpgimp,
};

}  // namespace

int main(int argc, char** argv) {
  accuracy::Wanted wanted{.finest = 0.5};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--finest" && i + 1 < argc)
      wanted.finest = std::atof(argv[++i]);
    else if (accuracy::Wanted::known(word))
      wanted.words.push_back(word);
    else
      return std::fprintf(stderr, "'%s' is no word of this program; the head of bench/accuracy.cpp lists them\n",
                          argv[i]),
             2;
  }
  accuracy::Row::header();
  for (const Family family : families) family(wanted);
}
