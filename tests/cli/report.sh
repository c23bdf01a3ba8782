#!/usr/bin/env bash
# report.sh FOOTFALL RUN: the page of a run holds its parts, loads nothing, and opens in a browser without network (where Chromium is installed).
set -euo pipefail
footfall=$1 run=$2
"$footfall" pictures "$run" --times 0.02
"$footfall" report "$run"
page=$run/report.html
for heading in Summary "How far to trust it" "Energy ledger" "Grains and mechanism" "Beside stock LIGGGHTS" "Scene and assumptions" Versions; do
  grep -q "$heading" "$page"
done
grep -q "plate_on_grains.scene, as it is now" "$page"
grep -q 'src="data:image/png;base64,' "$page"
# Nothing is fetched: no source or style from elsewhere, no script but those in the page; the browser is told to refuse any.
if grep -nE '<[^>]* src="[^d]|<link|<script[^>]* src|@import|url\(' "$page"; then echo "report.html fetches something"; exit 1; fi
grep -q "Content-Security-Policy\" content=\"default-src 'none'" "$page"
# The run can be played beside it.
grep -q '<a href="view.html">Play the run in 3D</a>' "$page"
[[ -s $run/view.html ]]
if ! command -v chromium > /dev/null; then echo "no chromium here: not opened in a browser"; exit 0; fi
profile=$(mktemp -d); trap 'rm -rf "$profile"' EXIT
timeout 60 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$profile" --host-resolver-rules="MAP * ~NOTFOUND" --virtual-time-budget=10000 --enable-logging=stderr --v=0 --dump-dom "file://$page" > "$profile/dom" 2> "$profile/log"
grep -q "<h1>Plate on grains</h1>" "$profile/dom"
grep -q "omega H" "$profile/dom"
# The browser shows both pictures: of the ledger, made for the report because the run made no plots, and of the grains.
[[ -s $run/ledger.csv && -s $run/plots/ledger.png ]]
for caption in "Where the energy is" "grains 0.0200s"; do grep -q "<figcaption>$caption</figcaption>" "$profile/dom"; done
grep -q "work to grains" "$profile/dom"
# Its plots are drawn, without a complaint.
grep -q 'class="uplot' "$profile/dom"
grep -q 'data-state="ready"' "$profile/dom"
if grep CONSOLE "$profile/log"; then echo "the browser complains about report.html"; exit 1; fi
