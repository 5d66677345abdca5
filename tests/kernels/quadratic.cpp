#include "kernels.hpp"

namespace mote::passes {
MOTE_TEST_QUADRATIC_KERNELS()
}  // namespace mote::passes
