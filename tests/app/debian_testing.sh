#!/usr/bin/env bash
# debian_testing.sh SOURCE OUT: the build and a short landing in a fresh root of Debian's next release, as README writes them. Exit code 69: no root could be made.
set -euo pipefail
source=$1 root=$2/root
trap '"$source/packaging/clean_root.sh" --remove "$root"' EXIT
short=$(sed -n 's/^<!-- short: \(.*\) -->$/\1/p' "$source/README.md")
# shellcheck disable=SC2086
"$source/packaging/clean_root.sh" testing "$root" ./footfall run $short
