/// \file
/// What a verification found: one row per check, with what was measured, what was allowed, and where.
#pragma once

#include <algorithm>
#include <cmath>
#include <iosfwd>
#include <limits>
#include <mote/core/error.hpp>
#include <string>
#include <vector>

namespace mote::verify {

/// One check: the worst state that was found, as measured against what is allowed there.
struct Row {
  std::string check;
  double measured;    ///< in the unit of the check
  double bound;       ///< what is allowed there; infinite: only reported
  bool passed;        ///< measured <= bound
  std::string where;  ///< the state or position of the worst, or why nothing was checked
};

/// All checks of one policy. Nothing is printed: `std::cout << report`, or report.text().
struct Report {
  std::string subject;  ///< the role
  std::vector<Row> rows;

  bool passed() const {
    return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.passed; });
  }
  /// The names of the checks that failed, in order.
  std::vector<std::string> failures() const {
    std::vector<std::string> names;
    for (const Row& row : rows)
      if (!row.passed) names.push_back(row.check);
    return names;
  }
  /// A line per check.
  std::string text() const {
    std::size_t width = 0;
    for (const Row& row : rows) width = std::max(width, row.check.size());
    std::string all = "verify::" + subject + (passed() ? ": passed\n" : ": FAILED\n");
    for (const Row& row : rows) {
      const bool reported = row.bound == std::numeric_limits<double>::infinity();
      all += row.passed ? (reported ? "  --    " : "  ok    ") : "  FAIL  ";
      all += row.check + std::string(width - row.check.size() + 2, ' ');
      all += reported ? mote::text(row.measured) : mote::text(row.measured, row.passed ? " <= " : " > ", row.bound);
      if (!row.where.empty()) all += " (" + row.where + ")";
      all += '\n';
    }
    return all;
  }

  template <class Traits>
  friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, const Report& report) {
    return out << report.text();
  }
};

namespace detail {

/// Round-off of one operation.
inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// Keeps the state that is worst beside its own bound. What is not a number is worse than all.
class Worst {
  double measured_ = 0, bound_ = 0, ratio_ = -1;
  std::string where_ = "no state could be tried";

 public:
  /// \param where called for its text if this state is the worst so far
  template <class Where>
  void see(double measured, double bound, const Where& where) {
    double ratio = measured == 0 ? 0 : measured / bound;
    if (std::isnan(ratio) || std::isnan(bound)) ratio = std::numeric_limits<double>::infinity();
    if (!(ratio > ratio_)) return;
    measured_ = measured, bound_ = bound, ratio_ = ratio;
    where_ = where();
  }
  bool saw_nothing() const { return ratio_ < 0; }
  /// A check that saw no state has failed.
  Row row(const char* check) const { return {check, measured_, bound_, ratio_ >= 0 && ratio_ <= 1, where_}; }
};

inline Row only_reported(const char* check, double measured, const std::string& where) {
  return {check, measured, std::numeric_limits<double>::infinity(), !std::isnan(measured), where};
}

}  // namespace detail

}  // namespace mote::verify
