#!/usr/bin/env bash
# Remakes docs/speed.md with its pictures: the mechanism beside Simbody, and its cost against size. Some ten minutes; needs libsimbody-dev, valgrind, python3, gnuplot.
#   docs/speed.sh BUILD [RUNS]     RUNS (default runs/speed): what is there already is taken, not measured again
set -euo pipefail
build=$(realpath "$1") runs=$(realpath -m "${2:-runs/speed}")
cd "$(dirname "$0")/.."
[[ -f $runs/simbody/simbody.md ]] || tests/bench/simbody/run.sh "$build" "$runs/simbody" > /dev/null
[[ -f $runs/size/size.md ]] || tests/bench/size.sh "$build" "$runs/size" > /dev/null
cp "$runs/simbody/simbody.png" docs/speed_simbody.png
cp "$runs/size/size.png" docs/speed_size.png
{
  cat docs/speed.txt
  printf '\n## Beside Simbody\n\nThe rigid lander of `tests/bench/simbody/scene.toml` in both programs: 13 bodies, gas, MR and two spring-dampers a leg, rows every 1 ms. CPodes is BDF with Newton.\n'
  printf 'The machine: %s, %s cores; runs took turns and the shortest counts.\n\n' "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)"
  cat "$runs/simbody/simbody.md"
  printf '\n`tests/bench/simbody/run.sh build`\n\n![error against processor time](speed_simbody.png)\n'
  printf '\n## Cost against size\n\nChains of rigid rods, and ten rods with more and more modes, in steps of fixed length.\n\n'
  cat "$runs/size/size.md"
  printf '\n`tests/bench/size.sh build`\n\n![instructions of a step against size](speed_size.png)\n'
} > docs/speed.md
