#!/usr/bin/env bash
# Tries the README's two commands, as they stand, in a new Debian 12: makes its root with debootstrap, copies the last
# commit into it, runs both commands there, and prints how long each took, with the installation of what it needs.
# `check_bare_system.sh --all` also runs scripts/run_all_tests.sh there.
# Needs root, debootstrap and the network; a quarter of an hour, an hour with --all. Everything is written below
# build/bare_system, or WORK_FOLDER. JOBS is the number of jobs at once.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=${WORK_FOLDER:-$root/build/bare_system}
system=$work/debian
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
"$root/scripts/install_needs.sh" debootstrap git

rm -rf "$system"
mkdir -p "$system"
debootstrap --variant=minbase bookworm "$system" "$mirror" > "$work/debootstrap.log"
trap 'umount "$system/proc" || true' EXIT
mount -t proc proc "$system/proc"
cp /etc/resolv.conf "$system/etc/resolv.conf"
mkdir "$system/package"
git -C "$root" archive HEAD | tar -x -C "$system/package"

# run COMMAND LOG: runs the command in the new system and prints how it went and how long it took.
run() {
  local start=$SECONDS status=0
  chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root JOBS="${JOBS:-$(nproc)}" \
    bash -c "cd /package && $1" > "$work/$2.log" 2>&1 || status=$?
  echo "$1: exit status $status after $((SECONDS - start)) s, $(tail -n 1 "$work/$2.log")"
  return $status
}

run "bash scripts/run_main_job.sh" main_job
run "bash scripts/run_tests.sh" tests
grep -A 20 "tests passed" "$work/tests.log"
if [ "${1:-}" = --all ]; then
  run "bash scripts/run_all_tests.sh" all_tests
  grep -A 20 "tests passed" "$work/all_tests.log"
fi
