#!/usr/bin/env bash
# browser.sh FOOTFALL OUT RUNS: pages of the runs RUNS/plate and RUNS/plane in a browser without network: they get ready, draw, and the browser complains of nothing;
# where no graphics card draws, the page paints grains and mechanism itself, as its shaders draw them; an address opens a time, a camera and a track; pictures and,
# with ffmpeg, videos are made of a page. Where node is installed, what the page holds is read back.
# Exit code 77 where Chromium and node are missing.
set -euo pipefail
footfall=$1 out=$2 runs=$3 here=$(cd "$(dirname "$0")" && pwd)
die() { echo "browser.sh: $*"; exit 1; }
command -v chromium >/dev/null || command -v node >/dev/null || { echo "browser.sh: chromium and node are missing"; exit 77; }
rm -rf "$out" && mkdir -p "$out"
cp -r "$runs/plate" "$runs/plane" "$out"
for run in plate plane; do "$footfall" view "$out/$run" >/dev/null; done
"$footfall" report "$out/plate" >/dev/null
command -v node >/dev/null && node "$here/view_read_back.mjs" "$out/plate"
command -v chromium >/dev/null || exit 0

# The number of pixels that differ by more than `least` of 255 in a colour.
pixels='<script>
const pixels = (a, b, least) => {
  let count = 0;
  for (let k = 0; k < a.length; k += 4) if (Math.max(...[0, 1, 2].map((c) => Math.abs(a[k + c] - b[k + c]))) > least) ++count;
  return count;
};
</script>'

profile=$(mktemp -d); trap 'rm -rf "$profile"' EXIT
opened() { # PAGE: its elements when it is ready
  timeout 280 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$profile" --host-resolver-rules="MAP * ~NOTFOUND" \
    --window-size=800,600 --virtual-time-budget=20000 --enable-logging=stderr --v=0 --dump-dom "file://$1" >"$profile/dom" 2>"$profile/log" || die "$1: chromium ended with $?"
  grep -q 'data-state="ready"' "$profile/dom" || { grep CONSOLE "$profile/log"; die "$1: the page did not get ready"; }
  ! grep CONSOLE "$profile/log" | grep -v 'GPU stall due to ReadPixels' || die "$1: the browser complains"  # a test reads the picture back
  grep -q 'class="uplot' "$profile/dom" || die "$1: no plot"
}
for run in plate plane; do
  opened "$out/$run/view.html"
  grep -q '<canvas data-engine=' "$profile/dom" || die "$run: no picture"
done
# A report shows its mechanism and figures; the pointer reads values, a drag zooms, a double click shows all again; on paper a dark page is light.
sed 's|<head>|<head><script>window.matchMedia = () => ({ matches: true, addEventListener() {} });</script>|' "$out/plate/report.html" >"$out/report.html"
cat >>"$out/report.html" <<'JS'
<script>
(async () => {
  while (document.body.dataset.state !== "ready") await new Promise((resolve) => setTimeout(resolve, 50));
  const turn = () => new Promise((resolve) => setTimeout(resolve, 50)), all = (words) => [...document.querySelectorAll(words)];
  const run = JSON.parse(document.getElementById("footfall-run").textContent), note = (name, value) => (document.body.dataset[name] = value);
  note("figures", `${all(".footfall-figures .uplot").length} of ${run.figures.flatMap(({ figures }) => figures).length}`);
  const canvas = all(".footfall-mechanism")[0], pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  note("mechanism", pixels.filter((value, k) => k % 4 === 3 && value === 255).length);
  const over = all(".footfall-figures .u-over")[0], plot = over.closest(".u-wrap").querySelector("canvas"), { left, top } = over.getBoundingClientRect();
  const mouse = (kind, x, at = over) => at.dispatchEvent(new MouseEvent(kind, { clientX: left + x, clientY: top + 30, movementX: 1, bubbles: true }));
  await turn();  // the plot takes the size of its place
  const whole = plot.toDataURL();
  mouse("mousemove", 100);
  await turn();
  note("values", all(".footfall-figures figure")[0].querySelector("output").textContent !== "");
  mouse("mousedown", 100);
  mouse("mousemove", 200);
  mouse("mouseup", 200, document);
  await turn();
  note("zoomed", plot.toDataURL() !== whole);
  const zoomed = plot.toDataURL(), dot = all(".footfall-figures .dot")[0], dark = dot.style.background;
  window.dispatchEvent(new Event("beforeprint"));
  await turn();
  note("paper", dot.style.background !== dark && plot.toDataURL() !== zoomed);
  window.dispatchEvent(new Event("afterprint"));
  await turn();
  note("screen", dot.style.background === dark && plot.toDataURL() === zoomed);
  mouse("dblclick", 100);
  await turn();
  note("back", plot.toDataURL() === whole);
})();
</script>
JS
opened "$out/report.html"
body=$(grep -o '<body[^>]*>' "$profile/dom")
value() { sed -n "s/.* data-$1=\"\([^\"]*\)\".*/\1/p" <<<"$body"; }
[[ $(value figures) =~ ^([0-9]+)\ of\ ([0-9]+)$ && ${BASH_REMATCH[1]} == "${BASH_REMATCH[2]}" && ${BASH_REMATCH[1]} -gt 3 ]] || die "figures of the report: $body"
(($(value mechanism) > 10000)) || die "the report does not show its mechanism: $body"
for name in values zoomed paper screen back; do [[ $(value $name) == true ]] || die "report, $name: $body"; done
# Two samples, of which the second has its numbers a tenth larger, next to one run: curves with a band.
mkdir "$out/samples" "$out/louder"
cp "$out/plate/summary.json" "$out/louder"
awk -F, -v OFS=, 'NR > 2 { for (k = 2; k <= NF; ++k) $k *= 1.1 } { print }' "$out/plate/history.csv" >"$out/louder/history.csv"
echo run >"$out/samples/runs.csv"
printf 'case,run\nplate,../plate\nplate,../louder\n' >"$out/samples/samples.csv"
"$footfall" report "$out/samples" "$out/plate" >/dev/null
grep -q 'az 95 %' "$out/samples/difference.html" || die "samples: no band"
opened "$out/samples/difference.html"
cp "$out/plate/view.html" "$out/painted.html"
echo "$pixels" >>"$out/painted.html"
cat >>"$out/painted.html" <<'JS'
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
  document.body.dataset.paints = stage.paints;
  player.seek(0.5 * (player.start + player.end));
  const shaded = picture(false, false), painted = picture(true, false), none = picture(true, true);
  document.body.dataset.grains = pixels(shaded, none, 12);
  document.body.dataset.differ = pixels(shaded, painted, 12);
})();
</script>
JS
opened "$out/painted.html"
body=$(grep -o '<body[^>]*>' "$profile/dom")
[[ $(value paints) == true ]] || die "the page does not paint its grains: $body"
(($(value grains) > 1000)) || die "too few pixels show grains: $body"
(($(value differ) * 50 < $(value grains))) || die "the painted grains are not the shaded ones: $body"

# While it plays, the page paints the mechanism among the grains as its shaders draw it. A colour of the painter is a 63rd, half of which is 2 of 255;
# where edges fall between pixels, and lines end, both may choose differently: 2 % of the pixels.
cp "$out/plate/view.html" "$out/facets.html"
echo "$pixels" >>"$out/facets.html"
cat >>"$out/facets.html" <<'JS'
<script>
(async () => {
  while (document.body.dataset.state !== "ready") await new Promise((resolve) => setTimeout(resolve, 50));
  const { stage, player } = window.footfall, gl = stage.renderer.getContext();
  const picture = (playing, mechanism) => {
    stage.playing = playing;
    stage.bodies.object.visible = mechanism;
    stage.symbols.object.visible = mechanism;
    stage.setTime(player.time);
    stage.draw();
    const { width, height } = stage.renderer.domElement, bytes = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return bytes;
  };
  player.seek(0.5 * (player.start + player.end));
  for (const mesh of stage.symbols.solids.ghosts) mesh.removeFromParent();  // they are not shown while it plays
  const none = picture(true, false), painted = picture(true, true), meshes = stage.bodies.object.children.filter((mesh) => mesh.visible).length;
  const shaded = picture(false, true);
  document.body.dataset.facets = stage.facets.count;
  document.body.dataset.meshes = meshes;
  document.body.dataset.mechanism = pixels(shaded, none, 12);
  document.body.dataset.differ = pixels(shaded, painted, 12);
  stage.setClip({ axis: "x", bodies: true });
  picture(true, true);
  document.body.dataset.cut = stage.bodies.object.children.filter((mesh) => mesh.visible).length;
})();
</script>
JS
opened "$out/facets.html"
body=$(grep -o '<body[^>]*>' "$profile/dom")
(($(value facets) > 0 && $(value meshes) == 0)) || die "the page does not paint its mechanism while it plays: $body"
(($(value mechanism) > 1000)) || die "too few pixels show the mechanism: $body"
(($(value differ) * 50 < $(value mechanism))) || die "the painted mechanism is not the shaded one: $body"
(($(value cut) > 0)) || die "a cut mechanism is not left to the shaders: $body"

# An address opens a time and a camera; symbols are drawn where they are switched on, and a track where a point is chosen.
cp "$out/plane/view.html" "$out/linked.html"
cat >>"$out/linked.html" <<'JS'
<script>
(async () => {
  while (document.body.dataset.state !== "ready") await new Promise((resolve) => setTimeout(resolve, 50));
  const { stage, player, controls, picture } = window.footfall, eye = stage.eye();
  document.body.dataset.opened = [player.time, eye.azimuth, eye.elevation, eye.zoom].map((x) => x.toFixed(3)).join();
  const { tubes, pipes, balls } = stage.symbols.solids, drawn = () => tubes.count + pipes.count + balls.count;
  picture(0.02);
  document.body.dataset.symbols = drawn();
  document.body.dataset.track = stage.symbols.tracks.pipes.count;
  document.body.dataset.brackets = stage.symbols.brackets.length;
  controls.follow({ hide: "symbols" });
  picture(0.02);
  document.body.dataset.hidden = drawn();
  controls.writeLink();
  document.body.dataset.link = location.hash;
})();
</script>
JS
opened "$out/linked.html#t=0.01&camera=-40,30,2&track=body:cabin"
body=$(grep -o '<body[^>]*>' "$profile/dom")
[[ $(value opened) == 0.010,-40.000,30.000,2.000 ]] || die "the address does not open its time and camera: $body"
(($(value symbols) > 200)) || die "too few symbols of 36 joints, 12 struts and 4 springs: $body"
(($(value brackets) >= 8)) || die "the auxiliary struts end in mid-air: $body"
(($(value track) > 0 && $(value hidden) == 0)) || die "track or switch of the symbols: $body"
[[ $(value link) == "#t=0.02&amp;camera=-40,30,2"* ]] || die "the address that the page writes: $body"

cd "$out"
"$footfall" view plane --png plane.png --at 0.02 --size 640,360 --camera=-65,18 >/dev/null
"$footfall" check "$here/../../inputs/rigid_plane" --picture reference.png >/dev/null
for picture in plane.png reference.png; do [[ $(head -c 4 "$picture" | tail -c 3) == PNG ]] || die "$picture is no picture"; done
command -v ffprobe >/dev/null || exit 0
for film in plane.mp4 plane.webm; do
  "$footfall" view plane --video "$film" --slow 20 --fps 10 --size 320,180 >/dev/null
  [[ $(ffprobe -v error -count_frames -select_streams v -show_entries stream=width,height,nb_read_frames -of csv=p=0 "$film") == 320,180,7 ]] || die "$film: not 7 pictures of 0.03 s"
done
