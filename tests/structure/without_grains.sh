#!/usr/bin/env bash
# A scene without grains makes nothing of the coupling: every part of it is made by CoupledRun alone, and that by
# Simulation alone, which has a test that it makes none without a partner. Those who observe a run do not include it.
set -u
cd "$(dirname "$0")/../.."
failed=0
# only PATTERN ALLOWED...: no other source of the solver includes what matches.
only() {
  local pattern=$1 file name allowed found=0; shift
  while IFS= read -r file; do
    allowed=0 found=1
    for name in "$@"; do [[ $file == $name ]] && allowed=1; done
    if ((!allowed)); then echo "$file includes $pattern; only $* may"; failed=1; fi
  done < <(grep -rlE "^#include \"mbd_solver/$pattern" mbd_solver --include=*.h --include=*.cpp)
  if ((!found)); then echo "nothing includes $pattern: this check is blind"; failed=1; fi
}
only 'coupling/(dem_partner|coupling_watch|window_choice|flight_time|fast_modes)\.h' 'mbd_solver/coupling/*'
only 'coupling/coupled_run\.h' 'mbd_solver/coupling/*' 'mbd_solver/run/simulation.h'
only 'run/' 'mbd_solver/run/*' 'mbd_solver/main.cpp'
only 'coupling/coupling_sample\.h' 'mbd_solver/coupling/*' 'mbd_solver/observe/sample.h'
if [[ $(grep -rlE 'make_unique<CoupledRun>|\bCoupledRun [a-z]+[({]' mbd_solver) != mbd_solver/run/simulation.cpp ]]; then
  echo "CoupledRun is made elsewhere than in mbd_solver/run/simulation.cpp"; failed=1; fi
exit $failed
