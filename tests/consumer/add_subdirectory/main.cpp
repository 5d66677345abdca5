#include <mote/mote.hpp>

#include <string_view>

int main() { return std::string_view(mote::version) == EXPECTED_VERSION ? 0 : 1; }
