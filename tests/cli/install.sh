#!/usr/bin/env bash
# install.sh BUILD OUT: what `cmake --install` puts there holds the scripts of [particles.box], and uses its own and not the checkout's.
set -u
build=$1 out=$2 source=$(cd "$(dirname "$0")/../.." && pwd)
die() { echo "install.sh: $*"; exit 1; }
rm -rf "$out"
cmake --install "$build" --prefix "$out" >/dev/null || die "cmake --install failed"
for program in footfall footfall_studies mbd_solver liggghts_mbd; do [[ -x $out/bin/$program ]] || die "$program is not installed"; done
diff -r "$source/inputs/box" "$out/share/footfall/inputs/box" || die "the scripts of inputs/box are not installed as they are"
"$out/bin/footfall" check "$source/examples/01_pendulum" >"$out/check.txt" 2>&1 || { cat "$out/check.txt"; die "the scene is refused"; }
# A script that is broken there shows that it is the one that is read.
printf 'no LIGGGHTS script\n' >"$out/share/footfall/inputs/box/in.bed"
FOOTFALL_CACHE=$out/cache "$out/bin/footfall" run "$source/examples/01_pendulum" --quiet --out "$out/run" >"$out/run.txt" 2>&1 &&
  die "a run made its bed with another script than the installed one"
grep -q "in.bed" "$out/run.txt" || { cat "$out/run.txt"; die "the message does not name the script"; }
exit 0
