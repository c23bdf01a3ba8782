#!/usr/bin/env bash
# What parts that a scene does not use cost it: instructions of mbd_solver, counted by valgrind (callgrind), in functions of drives, brakes, gears, cams, rolling
# joints, signals, events, expressions, laws of joint coordinates, box beds. Reading a scene that names none of them counts, too.
#   tests/bench/unused_parts.sh BUILD [SECONDS [OPTION...]]    of inputs/landing_mr; default 0.02 s of simulated time; options of `footfall run`, e.g. for a small bed
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
(($#)) || { sed -n '2,4p' "$0"; exit 2; }
build=$(realpath "$1") seconds=${2:-0.02}
shift; (($# == 0)) || shift
cd "$(dirname "$0")/../.."
command -v valgrind >/dev/null || { echo "unused_parts.sh: valgrind is missing (a Debian package of that name)"; exit 2; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
cp "$build/bin/footfall" "$build/bin/liggghts_mbd" "$work/bin"
printf '#!/bin/sh\nexec valgrind -q --tool=callgrind --callgrind-out-file=%s %s "$@"\n' "$work/out" "$build/bin/mbd_solver" >"$work/bin/mbd_solver"
chmod +x "$work/bin/mbd_solver"
"$work/bin/footfall" run inputs/landing_mr --until "$seconds" --set output.plots=false --out "$work/run" "$@" >"$work/said" 2>&1 || { tail -n 20 "$work/said"; exit 1; }
callgrind_annotate --threshold=100 "$work/out" | awk '
  /PROGRAM TOTALS/ { all = $1; gsub(",", "", all) }
  /footfall::|mu::/ && /Motor|Drive|Brake|Gear|Cam[A-Z(:]|Rolling|Planar|ConstantVelocity|JointFriction|JointForce|JointCoordinate|Signal|Expression|Pid|LinearFilter|LookupTable|StateMachine|EventSpec|BoxSpec|AppliedForce|mu::/ {
    n = $1; gsub(",", "", n); n += 0; unused += n; if (n > most) { most = n; name = $0; sub(/.*\?\?\?:/, "", name) } }
  END { printf "inputs/landing_mr: unused parts %.0f of %.0f instructions of mbd_solver, %.5f %%; the largest: %d in %.90s\n", unused, all, 100 * unused / all, most, name }'
