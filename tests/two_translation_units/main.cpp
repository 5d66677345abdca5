// Links only if no header defines a function or a variable twice.
#include <mote/mote.hpp>

#include <string_view>

const char* version_seen_by_other();

int main() { return std::string_view(mote::version) == version_seen_by_other() ? 0 : 1; }
