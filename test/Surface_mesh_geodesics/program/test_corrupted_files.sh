#!/usr/bin/env bash
# Damaged files: the program ends with a result, or with a message and a status of the man page; never by a signal,
# never late, and never with more than one GB of memory. The fifth argument is the number of rounds of random damage.
# With it, the test tries all damaged files, otherwise one file of eight.
script=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/corrupted_files.py
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "${@:1:4}"
command -v python3 > /dev/null || { echo "SKIPPED: there is no python3"; exit 77; }
python3 "$script" "$program" "$work" --rounds "${5:-1}" --share $(($# > 4 ? 1 : 8))
