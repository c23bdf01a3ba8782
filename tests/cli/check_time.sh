#!/usr/bin/env bash
# check_time.sh FOOTFALL OUT: what `footfall check` foretells of a run: time steps from the text of the scripts, and with --time the run time, from its first
# seconds. Nothing of the trial stays. The figures themselves: tests/bench/run_time.sh.
set -u
footfall=$1 out=$2 root=$(cd "$(dirname "$0")/../.." && pwd)
die() { echo "check_time.sh: $*"; exit 1; }
rm -rf "$out" && mkdir -p "$out/tmp" && cd "$out" || die "cannot make $out"
export TMPDIR=$out/tmp FOOTFALL_CACHE=$out/cache
says() { grep -Eq -e "$2" "$1" || { cat "$1"; die "$1 does not say: $2"; }; }

"$footfall" check "$root/inputs/landing_mr" >script.txt 2>&1 || die "check of landing_mr"
says script.txt 'radius: 0.02 to 0.05 m'
says script.txt 'time step: 0.0001 s, 11 % of the Rayleigh time, 5.2 % of the Hertz time at 3.8 m/s; window: 3 steps'
"$footfall" check "$root/inputs/landing_mr" --time >none.txt 2>&1 || die "check --time without a bed"
says none.txt 'not known before the bed is made'
[[ ! -e $out/cache ]] || die "a bed was made"

# Alone: the run that it foretells, and one that ends within the trial.
"$footfall" check "$root/inputs/rigid_plane" --time 0.5 >plane.txt 2>&1 || { cat plane.txt; die "check of the plane"; }
says plane.txt 'Run time: about [0-9.]+ (s|min) \([0-9.]+ .* to [0-9.]+ .*\).*tried for (0\.[5-9]|[1-9])'  # as long as asked, or to the end of a row
"$footfall" check "$root/inputs/rigid_plane" --set end_time=0.005 --time=60 >short.txt 2>&1 || die "check of a short run"
says short.txt 'that was the whole run'

# With grains.
cat >grains.toml <<'TOML'
end_time = 50
[[bodies]]
name = "plate"
mass = 0.5
shape = { kind = "cylinder", centre = [0, 0, 0.01], radius = 0.04, length = 0.01 }
[[boundaries]]
body = "plate"
surface = { element_size = 0.02 }
[ground]
kind = "particles"
[initial]
velocity = [0, 0, -1]
[particles]
ranks = 1
[particles.box]
size = [0.14, 0.14]
depth = 0.04
radius = [0.009]
TOML
"$footfall" run grains.toml --until 0.001 --quiet --set output.plots=false >bed.txt 2>&1 || { cat bed.txt; die "the bed"; }
"$footfall" check grains.toml --time 1 >grains.txt 2>&1 || { cat grains.txt; die "check of the grains"; }
says grains.txt 'Run time: about [0-9.]+ (s|min|h)'
says grains.txt '% of it for LIGGGHTS'
says grains.txt 'memory: [1-9][0-9]* MB'
says grains.txt 'omega H: up to [0-9.e-]+ so far \(plate\)'

# What is wrong is told as by run; nothing is left.
"$footfall" check grains.toml --time 0 >zero.txt 2>&1; (($? == 2)) || die "--time 0 is no bad input"
"$footfall" check grains.toml --ranks 2 >ranks.txt 2>&1; (($? == 2)) || die "--ranks without --time is no bad input"
left=$(find "$out/tmp" -name 'footfall_trial*' | head -n 1)
[[ -z $left ]] || die "$left was left behind"
