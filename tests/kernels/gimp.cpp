#include "kernels.hpp"

namespace mote::passes {
MOTE_TEST_GIMP_KERNELS()
}  // namespace mote::passes
