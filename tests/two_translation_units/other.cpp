#include "run.hpp"

const char* version_seen_by_other() { return mote::version; }
double run_in_other() { return run_a_solver(); }
