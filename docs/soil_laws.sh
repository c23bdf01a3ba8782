#!/usr/bin/env bash
# Remakes docs/soil_laws.md and its pictures: known laws of soil, and what the rigs of docs/rigs.md measure on their default bed. The better part of an hour
# on two cores; runs that are done are kept.
#   docs/soil_laws.sh [BUILD]     BUILD: the build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/.."
footfall=${1:-build}/bin/footfall
out=runs/rigs
# NAME SAMPLES: the table of a rig and the command that makes it.
table() {
  "$footfall" rig "$1" --out "$out/$1" --samples "$2" >&2
  cp "$out/$1/$1.png" "docs/soil_laws_$1.png"
  echo "\`footfall rig $1 --samples $2\`:"
  sed -e '/^## /d' -e '/^Made by/d' "$out/$1/$1.md" | cat -s
}
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  cat docs/soil_laws/head.txt
  table rft 1
  cat docs/soil_laws/sphere.txt
  table sphere 2
  cat docs/soil_laws/rigs.txt
  for rig in plate cone shear repose wheel; do
    echo "### $rig"
    echo
    table $rig 2
    echo
  done
} > "$page"
cp "$page" docs/soil_laws.md
