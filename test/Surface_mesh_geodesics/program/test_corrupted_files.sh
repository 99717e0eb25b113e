#!/usr/bin/env bash
# Damaged files: the program ends with a result or with a message and a status that the man page names; never by a
# signal, never late, and never with more than one GB of memory. With a fifth argument, all damaged files are tried, and
# as many rounds of random damage as it tells; without, one file of eight.
script=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/corrupted_files.py
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "${@:1:4}"
command -v python3 > /dev/null || { echo "SKIPPED: there is no python3"; exit 77; }
python3 "$script" "$program" "$work" --rounds "${5:-1}" --share $(($# > 4 ? 1 : 8))
