#!/usr/bin/env bash
# full_tmpfs.sh FOOTFALL OUT: coupled runs into a disk of 16 kB to 1 MB (a tmpfs), with pictures, motion and checkpoints: each ends with exit code 1 and a file's name,
# or is done; rows are whole; what counts as a checkpoint can be resumed once there is room. Exit code 77: tmpfs cannot be mounted here.
set -u
source "$(dirname "$0")/run_to_end.sh"
footfall=$1
rm -rf "$2" && mkdir -p "$2/disk" && cd "$2" && out=$PWD || exit 1
export FOOTFALL_CACHE=$out/cache
scene_of_plate "$here/endless.in" "$here/endless_bed.in" >scene.toml
trap 'cd /; umount "$out/disk" 2>/dev/null' EXIT
for size in 16 32 48 64 96 128 192 256 384 512 1024; do
  mount -t tmpfs -o size=${size}k tmpfs disk 2>/dev/null || exit 77
  "$footfall" run scene.toml --ranks 2 --set end_time=1.0 --set output.interval=0.01 --set output.vtk=true --set output.vtk_interval=0.05 --set output.checkpoint_interval=0.11 \
    --set output.plots=false --quiet --out disk/run >said.txt 2>&1 &
  run=$!
  wait_for_end 60 || die "$size kB: still there"
  if [[ $code == 1 ]]; then
    grep -q 'cannot be written\|cannot be brought\|No space left' said.txt || die "$size kB: nothing tells of the disk"
  elif [[ $code != 0 ]]; then
    # Before the first row it is a wrong folder.
    [[ $code == 2 && $(cat disk/run/history.csv 2>/dev/null | wc -l) -le 2 ]] && grep -q 'cannot be made\|cannot be written\|No space left' said.txt || die "$size kB: exit code $code"
  fi
  if [[ -s disk/run/history.csv ]] && (($(wc -l <disk/run/history.csv) > 2)); then
    cells=$(sed -n 2p disk/run/history.csv | tr -cd , | wc -c)
    [[ -z $(tail -c 1 disk/run/history.csv) && $(tail -n 1 disk/run/history.csv | tr -cd , | wc -c) == "$cells" ]] || die "$size kB: the history ends in half a row"
  fi
  sets=$(ls disk/run/checkpoint 2>/dev/null | grep -vc part)
  if ((code != 0 && sets > 0)); then
    mount -o remount,size=64m disk
    "$footfall" run --resume disk/run --quiet >again.txt 2>&1 || die "$size kB: with room again it does not go on: $(cat again.txt)"
  fi
  echo "full at $size kB: exit code $code, $sets sets: $(grep -m 1 'cannot\|No space' said.txt | cut -c1-100)"
  umount disk
done
exit 0
