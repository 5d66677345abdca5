#include "kernels.hpp"

namespace mote::passes {
MOTE_TEST_CUBIC_KERNELS()
}  // namespace mote::passes
