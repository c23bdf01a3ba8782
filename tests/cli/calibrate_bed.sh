#!/usr/bin/env bash
# A set whose bed cannot be made has failed, and the calibration goes on; --so-far knows it.
#   calibrate_bed.sh FOOTFALL CALIBRATION OUT
set -eu
footfall=$1 calibration=$2 out=$3
rm -rf "$out"; mkdir -p "$out"
die() { echo "calibrate_bed.sh: $*" >&2; exit 1; }

# The shipped balls on beds of any depth, of which two of the first three are below nothing.
sed "/^\[\[parameters\]\]/,/^\[\[figures\]\]/d; /^\[\[stages\]\]/,\$d; s|\"../dropped_sphere|\"$(dirname "$calibration")/../dropped_sphere|; /^values = /s/=.*/= [15485863]/; /^search = /s/=.*/= 1/; s/^until = .*/until = 0.02/" \
  "$calibration" >"$out/beds.toml"
sed -i 's/^name = "depth \[m\]"/[[figures]]\n&/' "$out/beds.toml"
cat >>"$out/beds.toml" <<'TEXT'
[[parameters]]
name = "bed_depth"
settings = ["particles.bed.variables.depth={value}"]
least = -0.6
most = 0.6
start = 0.2
[[stages]]
method = "direct"
evaluations = 3
TEXT
"$footfall" calibrate "$out/beds.toml" --out "$out/run" --jobs 2 >"$out/said.txt" 2>&1 || { cat "$out/said.txt"; die "it ended with $?"; }
failed=$(grep -c 'ERROR' "$out/run/way.csv" || true)
sets=$(tail -n +2 "$out/run/way.csv" | wc -l)
((sets == 3 && failed == 2)) || { cat "$out/run/way.csv"; die "$failed of $sets sets failed, expected 2 of 3"; }
grep -l '^footfall: the bed.s script' "$out"/run/runs/*.log >/dev/null || die "no log says that a bed's script failed"
"$footfall" calibrate "$out/beds.toml" --out "$out/run" --so-far >"$out/so_far.txt" || die "--so-far ended with $?"
grep -q 'has ended' "$out/so_far.txt" || { cat "$out/so_far.txt"; die "--so-far does not know the sets that have failed"; }
echo "$sets sets, $failed of them with a bed that cannot be made"
