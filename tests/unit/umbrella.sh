#!/usr/bin/env bash
# umbrella.sh INCLUDE_DIR: mote.hpp includes every header below mote/ but eigen.hpp and verify/, each once, in sorted order, and nothing else.
set -eu
cd "$1"
if diff <(find mote -name '*.hpp' ! -path mote/mote.hpp ! -path mote/eigen.hpp ! -path 'mote/verify/*' | LC_ALL=C sort) \
        <(sed -n 's|^#include <\(.*\)>$|\1|p' mote/mote.hpp); then
  echo "mote.hpp includes all $(grep -c '^#include' mote/mote.hpp) headers"
else
  echo "mote.hpp does not include exactly the headers that exist (<: missing there, >: should not be there)"
  exit 1
fi
