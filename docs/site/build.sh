#!/usr/bin/env bash
# Makes the site: docs/site/build.sh [OUT] (default: build/site). Needs Debian's mkdocs, and footfall built for the reference.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=${FOOTFALL_BUILD:-$root/build}
out=${1:-$build/site}
command -v mkdocs >/dev/null || { echo "docs/site/build.sh: mkdocs is missing; apt-get install mkdocs" >&2; exit 2; }
[[ -x $build/bin/footfall ]] || { echo "docs/site/build.sh: $build/bin/footfall is missing; build it first" >&2; exit 2; }

pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
python3 "$here/pages.py" "$root" "$build/bin/footfall" "$pages" "$out"
mkdocs --quiet build --strict --config-file "$pages/mkdocs.yml"
echo "$out/index.html"
