/// \file
/// The three kinds of trouble, as three types.
#pragma once

#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace mote {

/// A parameter is outside its allowed range. Thrown before anything runs; the text names the value and the range.
struct InputError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The calls came in the wrong order, e.g. a step before any particle was filled in.
struct UsageError : std::logic_error {
  using std::logic_error::logic_error;
};

/// The computation itself failed: not-a-number, a lost particle, a collapsed time step, a state that the equation of
/// state does not cover. The text names the particle, its position, the step and what to try.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be written completely. What was written before stays as it is.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {

/// A word or a number of a sentence.
struct Piece {
  enum class Kind { words, real, whole, natural } kind;
  union {
    std::string_view words;
    double real;
    long long whole;
    unsigned long long natural;
  };

  Piece(std::string_view w) : kind(Kind::words), words(w) {}
  Piece(const std::string& w) : Piece(std::string_view(w)) {}
  Piece(const char* w) : Piece(std::string_view(w)) {}
  Piece(const char& c) : Piece(std::string_view(&c, 1)) {}
  template <class T>
  requires std::is_floating_point_v<T> Piece(T x) : kind(Kind::real), real(double(x)) {}
  template <class T>
  requires std::is_integral_v<T> Piece(T i) : kind(std::is_signed_v<T> ? Kind::whole : Kind::natural) {
    if constexpr (std::is_signed_v<T>)
      whole = i;
    else
      natural = i;
  }
};

/// Numbers have six digits. Not a template: sentences are many, and each would be compiled anew.
[[gnu::noinline]] inline std::string sentence(std::initializer_list<Piece> pieces) {
  std::string all;
  char digits[32];
  for (const Piece& p : pieces) {
    if (p.kind == Piece::Kind::words) {
      all += p.words;
      continue;
    }
    const int n = p.kind == Piece::Kind::real    ? std::snprintf(digits, sizeof digits, "%g", p.real)
                  : p.kind == Piece::Kind::whole ? std::snprintf(digits, sizeof digits, "%lld", p.whole)
                                                 : std::snprintf(digits, sizeof digits, "%llu", p.natural);
    all.append(digits, std::size_t(n));
  }
  return all;
}

[[noreturn, gnu::cold, gnu::noinline]] inline void refuse(std::initializer_list<Piece> pieces) {
  throw InputError("mote: " + sentence(pieces));
}

}  // namespace detail

/// The arguments, words and numbers, one after the other as one string.
template <class... Args>
std::string text(const Args&... args) {
  return detail::sentence({detail::Piece(args)...});
}

/// Throws InputError("mote: " + the arguments as one sentence) unless `ok` holds.
template <class... Args>
void require(bool ok, const Args&... args) {
  if (!ok) detail::refuse({detail::Piece(args)...});
}

}  // namespace mote
