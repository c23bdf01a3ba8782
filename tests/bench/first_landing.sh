#!/usr/bin/env bash
# first_landing.sh RELEASE [WORDS...]: the first landing on a fresh machine, with the time of each stage: `./footfall run WORDS` in a minimal Debian RELEASE
# (bookworm, trixie; packaging/clean_root.sh) with a clone of what is committed here.
set -euo pipefail
export LC_ALL=C.UTF-8  # decimal points of awk
cd "$(dirname "$0")/../.."
root=$(mktemp -d)/root
trap 'packaging/clean_root.sh --remove "$root"' EXIT
packaging/clean_root.sh "$1" "$root" true
began=$(date +%s.%N)
stamped() { while IFS= read -r line; do echo "$(awk -v a="$began" -v b="$(date +%s.%N)" 'BEGIN { printf "%6.1f s", b - a }')  $line"; done; }
packaging/clean_root.sh "$1" "$root" ./footfall run "${@:2}" 2>&1 | stamped
echo "in all" | stamped
awk '/^model name/ { sub(/.*: /, ""); model = $0; ++n } END { printf "The machine: %s, %d cores.\n", model, n }' /proc/cpuinfo
