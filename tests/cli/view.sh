#!/usr/bin/env bash
# view.sh FOOTFALL OUT: the page of a run with grains, of one without, and of one that drew nothing; it loads nothing, and a browser without
# network (where Chromium is installed) shows it without a complaint, painted grains as shaded ones. Where node is installed, what the page holds is read back.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out"
die() { echo "view.sh: $*"; exit 1; }
"$footfall" run "$here/../bad_input/plate_on_grains.scene" --set particles.script="\"$here/replay/in.plate\"" --out "$out/grains" --quiet
"$footfall" run "$here/../../inputs/rigid_plane" --until 0.03 --set output.plots=false --set output.vtk_interval=0.01 --out "$out/mechanism" --quiet
cp -r "$out/grains" "$out/history"
rm -r "$out"/history/{motion,grains_*.txt,bodies*}

# Bodies are drawn without being asked for, a hundred times in a run.
[[ $(find "$out/grains" -name 'bodies_*.vtu' | wc -l) -ge 50 ]] || die "the run drew no bodies"

for run in grains mechanism history; do
  "$footfall" view "$out/$run" > "$out/$run.said" 2> "$out/$run.warned"
  page=$out/$run/view.html
  grep -q "view.html" "$out/$run.said" || die "$run: its path is not told"
  (($(stat -c %s "$page") < 3000000)) || die "$page is too large"
  grep -q "Content-Security-Policy\" content=\"default-src 'none'" "$page" || die "$page may load something"
  # The only address in it is the name of XHTML; nothing has a source.
  if grep -oE 'https?://[^" ]*' "$page" | grep -vx 'http://www.w3.org/1999/xhtml'; then die "$page names an address"; fi
  if grep -nE '<(script|img|iframe|link)[^>]* (src|href)="[^d]' "$page" | cut -c1-200 | grep .; then die "$page has a source"; fi
done
grep -q 'id="footfall-grains-0"' "$out/grains/view.html" && grep -q 'id="footfall-bodies-0"' "$out/grains/view.html" || die "a run with grains lacks frames"
[[ ! -s $out/grains.warned && ! -s $out/mechanism.warned ]] || die "a whole run is warned of"
grep -q "dumped no grains" "$out/history.warned" && grep -q "particles.variables.frames" "$out/history.warned" || die "nobody says how to get grains"
grep -q "output.vtk was false" "$out/history.warned" || die "nobody says how to get bodies"

# refused EXPECTED ARGUMENTS...
refused() {
  local expected=$1 code=0; shift
  "$footfall" view "$@" > "$out/refused" 2>&1 || code=$?
  [[ $code == 2 ]] && grep -q -e "$expected" "$out/refused" || { cat "$out/refused"; die "not refused: $*"; }
}
refused "expected the folder of a run" "$out"
cp -r "$out/mechanism" "$out/cut"
truncate -s 400 "$(find "$out/cut" -name 'bodies_*.vtu' | sort | tail -n 1)"
refused "bodies_.*vtu" "$out/cut"
[[ -s $out/mechanism/view.html ]] || die "a page is gone"

if command -v node > /dev/null; then
  node "$here/view_read_back.mjs" "$out/grains"
else
  echo "no node here: the page was not read back"
fi
if ! command -v chromium > /dev/null; then echo "no chromium here: not opened in a browser"; exit 0; fi
profile=$(mktemp -d); trap 'rm -rf "$profile"' EXIT
for run in grains mechanism history; do
  timeout 280 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$profile" \
    --host-resolver-rules="MAP * ~NOTFOUND" --window-size=800,600 --virtual-time-budget=20000 --enable-logging=stderr --v=0 \
    --dump-dom "file://$out/$run/view.html" > "$profile/dom" 2> "$profile/log" || die "$run: chromium ended with $?"
  grep -q 'data-state="ready"' "$profile/dom" || { grep -o '<body[^>]*>' "$profile/dom"; grep CONSOLE "$profile/log"; die "$run: the page did not get ready"; }
  if grep 'CONSOLE' "$profile/log"; then die "$run: the browser complains"; fi
  grep -q 'class="uplot' "$profile/dom" || die "$run: no plot"
  [[ $run == history ]] || grep -q '<canvas data-engine=' "$profile/dom" || die "$run: no picture"
done

# Where no graphics card draws, the page paints the grains itself: the picture is that of its shader, but for the rims of the discs.
mkdir -p "$out/painted"
cp "$out/grains/view.html" "$out/painted/view.html"
cat >> "$out/painted/view.html" <<'JS'
<script>
(async () => {
  while (document.body.dataset.state !== "ready") await new Promise((resolve) => setTimeout(resolve, 50));
  const { stage, player } = window.footfall;
  const picture = (paints, empty) => {
    stage.paints = paints;
    stage.grains.object.visible = !empty;
    stage.draw();
    const gl = stage.renderer.getContext(), { width, height } = stage.renderer.domElement, bytes = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  };
  const pixels = (a, b, least) => {
    let count = 0;
    for (let k = 0; k < a.length; k += 4) if (Math.max(...[0, 1, 2].map((c) => Math.abs(a[k + c] - b[k + c]))) > least) ++count;
    return count;
  };
  document.body.dataset.paints = stage.paints;
  player.seek(0.5 * (player.start + player.end));
  const shaded = picture(false, false), painted = picture(true, false), none = picture(true, true);
  document.body.dataset.grains = pixels(shaded, none, 12);
  document.body.dataset.differ = pixels(shaded, painted, 12);
})();
</script>
JS
timeout 280 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$profile" \
  --window-size=800,600 --virtual-time-budget=20000 --dump-dom "file://$out/painted/view.html" > "$profile/dom" 2> "$profile/log" || die "painted: chromium ended with $?"
body=$(grep -o '<body[^>]*>' "$profile/dom")
value() { sed -n "s/.* data-$1=\"\([^\"]*\)\".*/\1/p" <<< "$body"; }
[[ $(value paints) == true ]] || die "the page does not paint its grains: $body"
(($(value grains) > 1000)) || die "too few pixels show grains: $body"
(($(value differ) * 50 < $(value grains))) || die "the painted grains are not the shaded ones: $body"
