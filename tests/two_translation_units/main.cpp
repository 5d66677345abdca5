// Links only if no header defines a function or a variable twice; both units build and step a whole solver.
#include <string_view>

#include "run.hpp"

const char* version_seen_by_other();
double run_in_other();

int main() {
  const bool same_version = std::string_view(mote::version) == version_seen_by_other();
  const double mine = run_a_solver();
  return same_version && mine > 0 && mine == run_in_other() ? 0 : 1;
}
