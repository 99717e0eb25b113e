#!/usr/bin/env bash
# Stores matrices with several MPI processes, kills one of them, and goes on with another number.
#
# Usage: test_mpi.sh MPIRUN PROGRAM WORK_FOLDER
set -euo pipefail
mpirun=$1
program=$2
work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
trap 'echo "FAILED in line $LINENO: $BASH_COMMAND"' ERR

# Open MPI starts no more ranks than cores, and nothing for root, unless it is asked to. A rank must not wait on a core
# of its own. Other implementations of MPI ignore the variables.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_btl_vader_single_copy_mechanism=none

# start RANKS [arguments of the program]
start() {
  local ranks=$1
  shift
  "$mpirun" -n "$ranks" "$program" "$@"
}

for kind in "" --float32 --symmetric "--radius 0.4" "--avoid --symmetric"; do
  "$program" alone $kind --alone
  for ranks in 1 2 4; do
    start $ranks "with_$ranks" $kind > out
    diff -r alone "with_$ranks" # all bits, and no other file
    grep --quiet "computed 642 found 0" out
    rm -r "with_$ranks"
  done
  rm -r alone
done

# A rank dies in the middle, and with it the job: twice, in the same folder. How many rows a rank gets depends on the
# machine; if it does not get enough to die, or the others finish before mpirun ends them, the job starts again.
"$program" alone --alone
mkdir folder
for killed in 1 0; do
  cp -r folder before
  for attempt in $(seq 20); do
    rm -r folder
    cp -r before folder
    status=0
    start 4 folder --kill $killed 20 > killed.out 2>&1 || status=$?
    done=$(find folder -name '*.npy' | wc -l)
    [ "$status" -eq 0 ] || [ "$done" -eq 41 ] || break
  done
  [ "$status" -ne 0 ]
  echo "rank $killed killed: $done of 41 shards"
  [ "$done" -ge "$(find before -name '*.npy' | wc -l)" ]
  [ "$done" -lt 41 ]
  rm -r before
done
# mpirun returns when it has told the other ranks to end. Those that still live keep their shards.
for attempt in $(seq 50); do
  if start 2 folder --threads > out 2>&1; then break; fi
  sleep 0.2
done
cat out
diff -r alone folder
start 3 folder > out # the rows that others find count as computed, in sum they are all
diff -r alone folder

start 2 folder --other-mesh > out
[ "$(grep --count "the folder has the matrix of a mesh with the hash" out)" -eq 2 ]
diff -r alone folder

# An exception of the visitor reaches the caller, also from the thread that talks to the other ranks.
status=0
start 3 thrown --throw > out 2>&1 || status=$?
[ "$status" -ne 0 ]
grep --quiet "rank 0: the visitor has thrown" out
