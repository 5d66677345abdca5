/// \file
/// What do the schemes survive? docs/stability.md shows the answers. `mote_bench_stability [PART...]` prints CSV;
/// without arguments all parts run, one after the other.
#include "stability/report.hpp"

int main(int argc, char** argv) {
  using namespace stability;
  std::printf("experiment,scheme,parameter,quantity,value\n");
  std::sort(parts().begin(), parts().end(), [](const Part& a, const Part& b) { return a.name < b.name; });
  for (const auto& part : parts())
    if (argc < 2 || std::any_of(argv + 1, argv + argc, [&](const char* wanted) { return part.name == wanted; }))
      part.run();
}
