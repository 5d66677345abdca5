#include <mote/mote.hpp>

const char* version_seen_by_other() { return mote::version; }
