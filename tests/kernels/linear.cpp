#include "kernels.hpp"

namespace mote::passes {
MOTE_TEST_LINEAR_KERNELS()
}  // namespace mote::passes
