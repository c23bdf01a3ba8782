#!/usr/bin/env bash
# view_speed.sh FOOTFALL [GRAINS [FRAMES]]: how fast the page of footfall view is in headless Chromium, whose renderer is software: a made bed
# of 50 000 grains and 100 frames with one impact. Prints the time to the first picture, to all frames, pictures a second while it plays, alone
# and while the eye turns, and the processor time of a picture of full size, which says on a busy machine what an idle one would do. Needs chromium
# and python3.
set -euo pipefail
export LC_ALL=C.UTF-8  # decimal points of awk
set -m  # the browser and its processes are a group of their own
footfall=$(realpath "$1") grains=${2:-50000} frames=${3:-100}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
browser=
trap '[[ -z $browser ]] || kill "$browser" 2>/dev/null || true; sleep 0.5; rm -rf "$work"' EXIT
"$footfall" run "$here/../../inputs/rigid_plane" --until 0.1 --set output.plots=false --set output.vtk_interval=0.001 --quiet --out "$work/run"
python3 - "$work/run" "$grains" "$frames" <<'PY'
import json, math, random, sys
run, n, frames = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
random.seed(1)
summary = json.load(open(run + "/summary.json"))
summary["dt_dem_s"] = 1e-4
json.dump(summary, open(run + "/summary.json", "w"))
side = 4.0
depth = 0.064 ** 3 * n / side ** 2 * 0.25
grains = [(random.uniform(-side / 2, side / 2), random.uniform(-side / 2, side / 2), -random.random() * depth) for _ in range(n)]
near = [math.hypot(x, y) for x, y, _ in grains]
for k in range(frames):
    t = k / max(1, frames - 1)
    with open("%s/grains_%d.txt" % (run, 10 * k), "w") as file:
        file.write("ITEM: ATOMS id x y z vx vy vz radius\n")
        for i, (x, y, z) in enumerate(grains):
            wave = math.exp(-((near[i] - 2 * t) / 0.2) ** 2) if t > 0 else 0.0
            file.write("%d %.5f %.5f %.5f %.3f 0 %.3f 0.02\n" % (i + 1, x, y, z + 0.1 * wave, 0.3 * wave, wave))
PY
"$footfall" view "$work/run" > /dev/null
ls -l "$work/run/view.html" | awk '{ printf "page: %.1f MB\n", $5 / 1e6 }'
cat >> "$work/run/view.html" <<'JS'
<script>
(async () => {
  const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  while (document.body.dataset.state !== "ready") await wait(50);
  const { stage, player } = window.footfall;
  let drawn = 0, pictures = 0;
  const draw = stage.draw.bind(stage);
  stage.draw = () => { draw(); ++drawn; ++pictures; };
  player.seconds = 6;
  const measured = async (turn) => {
    player.seek(player.start);
    player.play(true);
    await wait(1500);  // the picture finds its size
    drawn = 0;
    const began = performance.now();
    for (let k = 0; performance.now() - began < 4000; ++k) {
      if (!player.playing) player.play(true);
      if (turn) { stage.orbit.object.position.applyAxisAngle(stage.camera.up, 0.01); stage.orbit.update(); stage.wish(); }
      await wait(turn ? 15 : 50);
    }
    return (1000 * drawn) / (performance.now() - began);
  };
  const plays = await measured(false), turns = await measured(true);
  // Sixty pictures of full size for the processor time, as they are drawn while it plays: as many as are drawn, whatever else the machine does.
  player.play(false);
  const screen = () => new Promise((resolve) => requestAnimationFrame(resolve));
  await wait(500);
  console.log("view-speed-begin");
  pictures = 0;
  for (let k = 0; k < 60; ++k) {
    await screen();
    player.playing = true;  // slider, numbers and plots follow as often as then
    player.seek(player.start + ((player.end - player.start) * (k + 0.5)) / 60);
  }
  player.playing = false;
  await screen();
  await screen();
  console.log(`view-speed-end ${pictures}`);
  const { width, height } = stage.renderer.domElement;
  console.log(`view-speed: first picture ${document.body.dataset.firstFrame} ms, all frames ${document.body.dataset.loaded} ms, ` +
    `${plays.toFixed(1)} pictures a second, ${turns.toFixed(1)} while the eye turns, at ${width} x ${height} pixels`);
})();
</script>
JS
chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --user-data-dir="$work/profile" --window-size=1280,800 \
  --remote-debugging-port=0 --enable-logging=stderr --v=0 "file://$work/run/view.html" > "$work/log" 2>&1 &
browser=$!
# Processor time of the browser and all its processes so far [ticks].
ticks() {
  local stat
  for stat in /proc/[0-9]*/stat; do cat "$stat" 2> /dev/null || true; done |  # some end meanwhile
    awk -v group="$(ps -o pgid= "$browser" | tr -d ' ')" '$5 == group { sum += $14 + $15 } END { print sum + 0 }'
}
until_said() {
  for ((i = 0; i < 3000; ++i)); do
    grep -q -e "$1" -e Uncaught "$work/log" && return
    kill -0 "$browser" 2> /dev/null || return 0
    sleep 0.1
  done
}
until_said view-speed-begin
before=$(ticks)
until_said view-speed-end
after=$(ticks)
until_said view-speed:
grep -oE 'view-speed: [^"]*' "$work/log" | head -n 1 || { grep CONSOLE "$work/log"; tail -n 5 "$work/log"; exit 1; }
pictures=$(grep -oE 'view-speed-end [0-9]+' "$work/log" | head -n 1 | cut -d ' ' -f 2)
awk -v t="$((after - before))" -v hz="$(getconf CLK_TCK)" -v n="$pictures" -v cores="$(nproc)" \
  'BEGIN { ms = 1000 * t / hz / n; printf "processor time: %.0f ms a picture, so at most %.0f pictures a second on %d free cores\n", ms, 1000 * cores / ms, cores }'
