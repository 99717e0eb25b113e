#!/usr/bin/env bash
# Prints the names of the test programs to run, one per line: the arguments, or all programs if there are none.
set -euo pipefail
if [ $# -gt 0 ]; then
  printf '%s\n' "$@"
else
  for source in "$(dirname "${BASH_SOURCE[0]}")"/../test/Surface_mesh_geodesics/test_*.cpp; do
    basename "$source" .cpp
  done
fi
