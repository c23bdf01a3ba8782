#!/usr/bin/env bash
# video_speed.sh FOOTFALL RUN [PICTURES]: what a video of a run costs: wall-clock time, and processor time of footfall, browser and encoder, which
# says on a busy machine what an idle one would do. RUN: the folder of a run; its video has about PICTURES (150) pictures of 1280 x 720 pixels, 25 in a second.
# Needs chromium, ffmpeg and python3.
set -euo pipefail
export LC_ALL=C.UTF-8  # decimal points of awk
footfall=$(realpath "$1") run=$(realpath "$2") pictures=${3:-150}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
end=$(python3 -c 'import json, sys; print(json.load(open(sys.argv[1] + "/summary.json"))["end_time_s"])' "$run")
slow=$(awk -v n="$pictures" -v end="$end" 'BEGIN { print n / 25 / end }')
began=$(date +%s.%N)
"$footfall" view "$run" --video "$work/run.mp4" --fps 25 --slow "$slow" > "$work/log" &
python3 - $! "$work" <<'PY'
# Sums the processor time of a process and all that come from it, as last seen before each ends.
import os, sys, time
root, seen, family = int(sys.argv[1]), {}, {int(sys.argv[1])}
while os.path.exists("/proc/%d" % root) and open("/proc/%d/stat" % root).read().rsplit(")", 1)[1].split()[0] != "Z":
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = open("/proc/%s/stat" % pid).read().rsplit(")", 1)[1].split()
        except OSError:
            continue
        parent, group = int(words[1]), int(words[2])
        if parent in family or group in family or int(pid) in family:
            family.add(int(pid))
            seen[pid] = int(words[11]) + int(words[12])
    time.sleep(0.1)
open(sys.argv[2] + "/seconds", "w").write(str(sum(seen.values()) / os.sysconf("SC_CLK_TCK")))
PY
wait
frames=$(ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames -of csv=p=0 "$work/run.mp4")
awk -v frames="$frames" -v wall="$(awk -v a="$began" -v b="$(date +%s.%N)" 'BEGIN { print b - a }')" -v cpu="$(cat "$work/seconds")" -v cores="$(nproc)" \
  'BEGIN { printf "video of %d pictures: %.0f s, processor time %.0f s, %.0f ms a picture, so %.0f s on %d free cores\n", frames, wall, cpu, 1000 * cpu / frames, cpu / cores, cores }'
