#!/usr/bin/env bash
# Makes the site: docs/site/build.sh [OUT] (default: build/site). Needs Debian's mkdocs, and footfall built for the reference. With doxygen it includes the C++ API.
# Uses no network. FOOTFALL_LANDING=DIR: the run that the first page plays.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=${FOOTFALL_BUILD:-$root/build}
out=${1:-$build/site}
command -v mkdocs >/dev/null || { echo "docs/site/build.sh: mkdocs is missing; apt-get install mkdocs" >&2; exit 2; }
[[ -x $build/bin/footfall ]] || { echo "docs/site/build.sh: $build/bin/footfall is missing; build it first" >&2; exit 2; }

pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
if command -v doxygen >/dev/null; then
  (cd "$root" && { cat "$here/Doxyfile"; echo "OUTPUT_DIRECTORY = \"$pages\""; } | doxygen -) >"$pages/doxygen.log" 2>&1 ||
    { tail -n 20 "$pages/doxygen.log" >&2; exit 1; }
fi
python3 "$here/pages.py" "$root" "$build/bin/footfall" "$pages" "$out"
# A landing that plays in the browser: the run in FOOTFALL_LANDING, or one on a soil without grains, which takes some seconds.
landing=${FOOTFALL_LANDING:-$pages/landing}
[[ -e $landing/summary.json ]] ||
  "$build/bin/footfall" run "$root/inputs/public_lander" --set ground.kind=soil --set output.plots=false --quiet --out "$landing" >"$pages/landing.log" 2>&1 || { tail -n 20 "$pages/landing.log" >&2; exit 1; }
"$build/bin/footfall" view "$landing" >"$pages/landing.log" 2>&1 || { tail -n 20 "$pages/landing.log" >&2; exit 1; }
cp "$landing/view.html" "$pages/pages/landing.html"
sed -i '0,/^<img /s||[Play a landing in the browser](landing.html)\n\n&|' "$pages/pages/index.md"
mkdocs --quiet build --strict --config-file "$pages/mkdocs.yml"
[[ ! -d $pages/cpp ]] || cp -r "$pages/cpp" "$out/cpp"
echo "$out/index.html"
