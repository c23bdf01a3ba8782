#!/usr/bin/env bash
# ledger.sh FOOTFALL OUT: energy ledgers of real runs.
#   Elastic grains without friction keep what they receive as motion and height: once nothing touches, nothing may be left over, though nearly all of
#   the plate's energy was in the contacts before. With restitution 0.4 most of it stays in the grains. On a plane there are no columns of grains.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out"
plate() {   # plate RESTITUTION RANKS
  "$footfall" run "$here/../bad_input/plate_on_grains.scene" --set particles.script="\"$here/ledger/in.plate\"" --set particles.variables.dt=2e-5 \
    --set particles.variables.every=1 --set particles.variables.energy_every=5e-4 --set particles.variables.restitution="$1" --set output.interval=1e-4 \
    --ranks "$2" --out "$out/plate_$1_$2" --quiet
}
# figure FILE KEY
figure() { sed -n "s/^ *\"$2\": \([-0-9.e+]*\),\{0,1\}$/\1/p" "$1/summary.json"; }
# column FILE NAME: its values
column() { awk -F, -v name="$2" 'NR == 2 { for (i = 1; i <= NF; i++) if ($i == name) k = i; if (!k) exit 1 } NR > 2 { print $k }' "$1/ledger.csv"; }
# holds WHAT CONDITION OF NUMBERS
holds() { if ! awk "BEGIN { exit !($2) }"; then echo "ledger.sh: $1: not $2"; exit 1; fi; }

plate 1 1; plate 1 2; plate 0.4 1
elastic=$out/plate_1_1 soft=$out/plate_0.4_1
most=$(column "$elastic" grains.dissipated | sort -g | tail -1)
holds "energy is stored in the contacts" "$most > 0.4"                                    # of the 0.58 J of the plate
# A millionth of that is what is found; the steps of the grains are second order, and rows of the plate are joined by lines of 0.1 ms.
holds "elastic grains dissipate nothing" "$(figure "$elastic" grains_dissipated_J)^2 < (1e-5 * $most)^2"
holds "the ledger closes" "$(figure "$elastic" closing_error_relative) < 1e-6"
holds "ranks make no difference" "($(figure "$elastic" energy_to_grains_J) - $(figure "$out/plate_1_2" energy_to_grains_J))^2 < 1e-12"
holds "restitution 0.4 dissipates" "$(figure "$soft" grains_dissipated_J) > 0.9 * $(figure "$soft" energy_to_grains_J)"
# By how much it falls is elastic energy that comes back: less than the elastic grains hold.
fall=$(column "$soft" grains.dissipated | awk '{ if ($1 > top) top = $1; if (top - $1 > fall) fall = top - $1 } END { print fall }')
holds "what is dissipated stays so" "$fall < $most"
last=$(column "$soft" grains.dissipated | tail -40 | sort -g | awk 'NR == 1 { low = $1 } END { print $1 - low }')
holds "nothing changes after the last contact" "$last < 1e-4"

"$footfall" run "$here/../../inputs/rigid_plane" --until 0.02 --out "$out/plane" --quiet
holds "the ledger on a plane closes" "$(figure "$out/plane" closing_error_relative) < 1e-4"
if grep -q grains "$out/plane/ledger.csv"; then echo "ledger.sh: a run without grains has columns of grains"; exit 1; fi
[[ -s $out/plane/plots/ledger.png && -s $out/plane/plots/ledger.svg ]]
