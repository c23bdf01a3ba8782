#!/usr/bin/env bash
# launcher_crash.sh FOOTFALL OUT: mpirun ends by a fault of its own when both programs have ended. The run is whole: its exit code and its
# summary say done, and a warning names mpirun. Where the programs did not come to their end the run has failed.
set -u
source "$(dirname "$0")/run_to_end.sh"
footfall=$(realpath "$1")
rm -rf "$2" && mkdir -p "$2/bin" && cd "$2" || exit 1
mpirun=$(command -v mpirun)
bad() { echo "$*"; cat said.txt; exit 1; }
scene_of_plate "$here/endless.in" "$here/endless_bed.in" >scene.toml
run_with() { # what the launcher of the pair does; other launches are mpirun's own
  printf '#!/bin/sh\ncase "$*" in *mbd_solver*) %s ;; *) exec %s "$@" ;; esac\n' "$1" "$mpirun" >bin/mpirun && chmod +x bin/mpirun
  PATH=$PWD/bin:$PATH FOOTFALL_CACHE=$PWD/cache "$footfall" run scene.toml --out run --until 0.02 --force --quiet >said.txt 2>&1
  code=$?
}
run_with "$mpirun \"\$@\"; kill -SEGV \$\$"
((code == 0)) || bad "whole run: exit code $code, expected 0"
grep -q '"status": "done"' run/summary.json || bad "the summary does not say done"
grep -q 'mpirun itself crashed (signal 11' said.txt || bad "no warning names mpirun"
run_with 'kill -SEGV $$'
((code == 1)) || bad "no run: exit code $code, expected 1"
grep -q '"status": "failed"' run/summary.json || bad "the summary does not say failed"
echo "done after a crash of mpirun; failed where there was no run"
