#!/usr/bin/env bash
# Functions shared by the tests of the program; each test begins with `source support.sh`.
#
# Usage of a test: test_x.sh <program> <folder with meshes> <work folder>. A failure ends the test and prints
# its line.
set -euo pipefail

program=$1
data=$2
work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
trap 'echo "FAILED in line $LINENO: $BASH_COMMAND"' ERR

fail() {
  echo "FAILED in line ${BASH_LINENO[1]}: $*"
  exit 1
}

# equals <actual> <expected>
equals() {
  [ "$1" = "$2" ] || fail "there is '$1' instead of '$2'"
}

# is_near <number> <number>: equal up to rounding
is_near() {
  awk -v a="$1" -v b="$2" 'BEGIN { d = a - b; exit !(a != "" && b != "" && d < 1e-12 && d > -1e-12) }' \
    || fail "there is '$1' instead of '$2'"
}

# contains <file> <text>
contains() {
  grep --quiet --fixed-strings -e "$2" "$1" || fail "'$2' is not in $1, which is: $(head -c 2000 "$1")"
}

# differ <file> <file>
differ() {
  if cmp --quiet "$1" "$2"; then
    fail "$1 is $2"
  fi
}

# column <file> <name>: the values of a column of a table, one per line
column() {
  awk -F, -v name="$2" '
    NR == 1 { for(i = 1; i <= NF; ++i) if($i == name) c = i; if(!c) exit 1; next }
    { print $c }' "$1"
}

# line <file> <number>: a line of a file, counted from 1
line() {
  sed -n "$2p" "$1"
}

# rejects <status> <text of the message> <arguments of the program>: nothing is computed, and one line names the reason
rejects() {
  local status=0
  "$program" "${@:3}" > rejected.out 2> rejected.err || status=$?
  [ "$status" -eq "$1" ] || fail "status $status instead of $1 for: ${*:3}"
  [ ! -s rejected.out ] || fail "something was written for: ${*:3}"
  [ "$(wc -l < rejected.err)" -eq 1 ] || fail "not one line of message for: ${*:3}: $(cat rejected.err)"
  contains rejected.err "surface_mesh_geodesics: error: "
  contains rejected.err "$2"
}

# is_silent <arguments of the program>: success, and an empty error stream
is_silent() {
  "$program" "$@" 2> silent.err
  [ ! -s silent.err ] || fail "the program said: $(cat silent.err)"
}

# remarks <text of the remark> <arguments of the program>: success, and one line with a remark
remarks() {
  "$program" "${@:2}" 2> remarks.err > remarks.out || fail "no success for: ${*:2}: $(cat remarks.err)"
  [ "$(wc -l < remarks.err)" -eq 1 ] || fail "not one line of remark for: ${*:2}: $(cat remarks.err)"
  contains remarks.err "$1"
}

# needs_pages: skips the test if the program cannot write pages for browsers
needs_pages() {
  if ! "$program" distances "$data/grid4.off" --source 0 --html probe.html 2> probe.err; then
    contains probe.err "this program was built without three.js"
    echo "SKIPPED: the program was built without three.js"
    exit 77
  fi
}

# no_remains: the work folder contains no unfinished file
no_remains() {
  local remains
  remains=$(find . -name '.[0-9]*')
  [ -z "$remains" ] || fail "left behind: $remains"
}
