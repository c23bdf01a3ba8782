#!/usr/bin/env bash
# Remakes docs/soil_laws.md and its pictures: known laws of soil, and what the rigs of docs/rigs.md measure on their default bed. About half an hour on two
# cores; runs that are done are kept.
#   docs/soil_laws.sh [BUILD]     BUILD: the build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/.."
footfall=${1:-build}/bin/footfall
out=runs/rigs
# FOLDER RIG OPTIONS...: the table of a rig and the command that makes it.
table() {
  local folder=$1 rig=$2; shift 2
  "$footfall" rig "$rig" --out "$out/$folder" "$@" >&2
  echo "\`footfall rig $rig $*\`:"
  sed -e '/^## /d' -e '/^Made by/d' "$out/$folder/$rig.md" | cat -s
  echo
}
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  cat docs/soil_laws/head.txt
  table rft rft --samples 1
  cat docs/soil_laws/rft.txt
  cat docs/soil_laws/sphere.txt
  table sphere sphere --samples 2
  cat docs/soil_laws/rigs.txt
  for rig in plate shear repose cone; do
    echo "### $rig"
    echo
    table $rig $rig --samples 2
  done
} > "$page"
cp "$page" docs/soil_laws.md
for rig in rft sphere; do cp "$out/$rig/$rig.png" "docs/soil_laws_$rig.png"; done
