/// \file
/// Files that are either complete or reported: OutputFile (whole files), LineFile (CSV, a row at a time).
///
/// Both create missing parent directories and throw OutputError with one sentence that names the file and the reason.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mote/core/error.hpp>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace mote::observe {

/// Appends a number so that reading it back gives the same number: 3, 0.1, 1e-09, nan.
template <class Number>
requires std::is_arithmetic_v<Number>
void append_number(std::string& line, Number value) {
  std::array<char, 64> digits;
  const auto print = [&](auto number) {
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    line.append(digits.data(), end);
  };
  if constexpr (std::is_integral_v<Number>)
    print(+value);
  else if (std::abs(value) < Number(1e15) && value == std::trunc(value))
    print(static_cast<std::int64_t>(value));  // 1000000 rather than 1e+06
  else
    print(value);
}

namespace detail {

[[noreturn]] inline void cannot_write(const std::filesystem::path& name, const std::string& reason) {
  throw OutputError(text("mote: cannot write ", name.string(), ": ", reason));
}
[[noreturn]] inline void cannot_write(const std::filesystem::path& name, int error) {
  cannot_write(name, std::generic_category().message(error));
}

/// A C stream that keeps its first error: 0, or an errno.
class Stream {
 public:
  /// Opens `path` for writing from its start. `name` is what a complaint calls it.
  Stream(const std::filesystem::path& path, const std::filesystem::path& name) {
    if (const auto parent = path.parent_path(); !parent.empty()) {
      std::error_code error;
      std::filesystem::create_directories(parent, error);
      if (error) cannot_write(name, text("its directory cannot be made: ", error.message()));
    }
    file_.reset(std::fopen(path.string().c_str(), "wb"));
    if (!file_) cannot_write(name, errno);
  }

  bool is_open() const { return file_ != nullptr; }
  int error() const { return error_; }

  int write(const void* bytes, std::size_t size) {
    errno = 0;
    return note(std::fwrite(bytes, 1, size, file_.get()) == size);
  }
  int flush() {
    errno = 0;
    return note(std::fflush(file_.get()) == 0);
  }
  /// Flushes, then closes, and looks at both: a full disk may show only here.
  int close() {
    flush();
    errno = 0;
    return note(std::fclose(file_.release()) == 0);
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  int note(bool good) {
    if (!good && error_ == 0) error_ = errno != 0 ? errno : EIO;
    return error_;
  }

  std::unique_ptr<std::FILE, Close> file_;
  int error_ = 0;
};

}  // namespace detail

/// A file that appears under its name only when it is complete.
///
/// It is written as NAME.part and renamed by close(), so a reader sees the old file or the new one, never half of one.
/// Without close(), or after an error, the .part is removed and NAME stays as it was. A device or a pipe is written
/// directly; of a symbolic link to a file, the file is replaced.
///
///     OutputFile file{"out/summary.json"};
///     file.write("{}\n");
///     file.close();
class OutputFile {
 public:
  /// Creates the directories and NAME.part. Throws OutputError.
  explicit OutputFile(const std::filesystem::path& name)
      : name_(name), target_(resolved(name)), written_(part_of(target_)), stream_(written_, name) {}

  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (!stream_.is_open()) return;
    stream_.close();
    discard();
  }

  /// Writes text or bytes. Throws OutputError; UsageError after close().
  void write(std::string_view bytes) {
    if (!stream_.is_open()) throw UsageError(text("mote: ", name_.string(), " is written to after close()"));
    if (const int error = stream_.write(bytes.data(), bytes.size())) detail::cannot_write(name_, error);
  }

  /// Flushes, checks, closes, checks and renames to NAME. Throws OutputError. A second call does nothing.
  void close() {
    if (!stream_.is_open()) return;
    if (const int error = stream_.close()) {
      discard();
      detail::cannot_write(name_, error);
    }
    if (written_ == target_) return;
    std::error_code error;
    std::filesystem::rename(written_, target_, error);
    if (!error) return;
    discard();
    detail::cannot_write(name_, error.message());
  }

 private:
  static std::filesystem::path resolved(const std::filesystem::path& name) {
    require(name.has_filename(), "the output file '", name.string(), "' has no file name");
    std::error_code error;
    const auto real = std::filesystem::canonical(name, error);
    return error ? name : real;
  }
  static std::filesystem::path part_of(const std::filesystem::path& target) {
    std::error_code error;
    const bool special = std::filesystem::exists(target, error) && !std::filesystem::is_regular_file(target, error);
    return special ? target : std::filesystem::path(target) += ".part";
  }
  void discard() const {
    std::error_code ignored;
    if (written_ != target_) std::filesystem::remove(written_, ignored);
  }

  std::filesystem::path name_, target_, written_;
  detail::Stream stream_;
};

/// A CSV file: the header at once, then a row per call, each flushed and checked.
///
/// Whatever happens later (a full disk, a killed process), the rows that were written stay, each a whole line. A file
/// of that name is replaced.
///
///     LineFile history{"out/history.csv", "time_ns,step"};
///     history.row(0.1, 12);
class LineFile {
 public:
  /// Creates the directories and the file and writes the header, the columns' names separated by commas. Throws
  /// OutputError.
  LineFile(const std::filesystem::path& name, std::string_view header)
      : name_(name), columns_(1 + std::size_t(std::ranges::count(header, ','))), stream_(name, name) {
    line(header);
  }

  /// Writes a row of as many numbers as the header has columns. Throws OutputError; InputError for another count.
  template <class... Numbers>
  requires(sizeof...(Numbers) > 0 && (std::is_arithmetic_v<Numbers> && ...)) void row(Numbers... values) {
    std::string cells;
    ((append_number(cells, values), cells += ','), ...);
    finish_row(cells, sizeof...(values));
  }
  /// The same of a list. Whole numbers are written without a point.
  void row(std::span<const double> values) {
    std::string cells;
    for (const double value : values) {
      append_number(cells, value);
      cells += ',';
    }
    finish_row(cells, values.size());
  }

  /// Writes a line that the caller has put together, without its line end. Throws OutputError.
  void line(std::string_view content) {
    if (!stream_.is_open()) detail::cannot_write(name_, "it was closed before this line");
    const std::string whole = std::string(content) + '\n';
    if (stream_.write(whole.data(), whole.size()) == 0 && stream_.flush() == 0) {
      complete_ += whole.size();
      return;
    }
    fail();
  }

  /// Closes and checks. Throws OutputError. The destructor closes too, but cannot complain.
  void close() {
    if (stream_.is_open() && stream_.close() != 0) detail::cannot_write(name_, stream_.error());
  }

 private:
  void finish_row(std::string& cells, std::size_t count) {
    require(count == columns_, "a row of ", count, " values for the ", columns_, " columns of ", name_.string());
    cells.pop_back();
    line(cells);
  }
  /// Closes, cuts a torn last line off and throws.
  [[noreturn]] void fail() {
    stream_.close();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(name_, ignored)) std::filesystem::resize_file(name_, complete_, ignored);
    detail::cannot_write(name_, stream_.error());
  }

  std::filesystem::path name_;
  std::size_t columns_;
  std::uintmax_t complete_ = 0;
  detail::Stream stream_;
};

}  // namespace mote::observe
