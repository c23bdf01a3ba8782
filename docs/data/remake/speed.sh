#!/usr/bin/env bash
# Remakes docs/data/speed: first landing, pouring of the bed, build, estimated run times, ratio to stock LIGGGHTS, Simbody, cost against size.
# Leave the machine alone: some twenty minutes. Needs libsimbody-dev, valgrind, python3, gnuplot, g++, debootstrap (as root).
#   docs/data/remake/speed.sh [BUILD [PART...]]     BUILD: the build folder (default build). PART: first bed build time stock simbody size
#   PAIRS       of the landing and stock LIGGGHTS (default 10)
#   SPEED_RUNS  folder of what the benchmarks leave (default runs/speed)
set -euo pipefail
build=$(realpath "${1:-build}")
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
runs=$(realpath -m "${SPEED_RUNS:-runs/speed}")
# shellcheck disable=SC2034  # read by parts.sh
all=(first bed build time stock simbody size)
machine="The machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"

# Each stage ends where the front door says what comes next.
part_first() {
  tests/bench/first_landing.sh bookworm >"$runs/first.log" 2>&1
  awk '/ footfall: building/ { packages = $1 } / Making the bed/ { build = $1 } / Bed: / { bed = $1 } / in all$/ { all = $1 }
       END {
         print "| stage | time [s] |\n|---|---|"
         printf "| Debian packages | %.0f |\n| build, of what a run needs | %.0f |\n| bed | %.0f |\n| landing, 1.0 s of it, with its plots | %.0f |\n| in all | %.0f |\n\n", packages, build - packages, bed - build, all - bed, all
       }' "$runs/first.log"
  echo "$machine."
}
# Landings on beds that were poured in longer and shorter steps, and the beds themselves.
part_bed() {
  local sweep=inputs/sweeps/bed_step.toml seed step at
  "$build/bin/footfall" sweep $sweep --out "$runs/bed_step" >&2
  echo "\`footfall sweep $sweep\`:"
  echo
  grep -h "^[|]" "$runs/bed_step/cases.md"
  echo
  cat "$runs/bed_step/statements.md"
  echo
  echo "The samples, and the beds before the landing (\`footfall compare\`):"
  echo
  echo '| sample | depth, 1.0e-4 s [m] | 1.5e-4 s [m] | neighbours of a grain, 1.0e-4 s | 1.5e-4 s | packing under the pads, 1.0e-4 s | 1.5e-4 s |'
  echo '|---|---|---|---|---|---|---|'
  for seed in $(sed -n 's/^values = \[\([0-9, ]*\)\]$/\1/p' $sweep | tr -d ,); do
    for step in 1.0e-4 1.5e-4; do
      "$build/bin/footfall" run inputs/landing_script --until 1e-3 --force --out "$runs/bed_$step" --set output.plots=false --set particles.ranks=1 --set particles.variables.frames=0.001 \
        --set particles.bed.variables.dt=$step --set particles.bed.variables.seed=$seed >/dev/null
    done
    at=$("$build/bin/footfall" compare "$runs/bed_1.0e-4" "$runs/bed_1.5e-4" | awk '$1 == "0" { print $4 " | " $5 " | " $6 " | " $7 }')
    awk -F, -v seed="$seed" -v at="$at" '$3 == seed { depth[$2] = $6 } END { printf "| %s | %.3f | %.3f | %s |\n", seed, depth["1.0e-4"], depth["1.5e-4"], at }' "$runs/bed_step/runs.csv"
  done
}
# What a run needs, and all that is not needed for it left out.
part_build() {
  local compiler
  echo '| compiler | processor time [s] | on the clock [s] |'
  echo '|---|---|---|'
  for compiler in clang++ g++; do
    CXX=$compiler tests/bench/build_cost.sh | sed -n "s/^processor time of [0-9]* objects \([0-9]*\) s; .* built in \([0-9]*\) s/| $compiler | \1 | \2 |/p"
  done
  echo
  echo "$machine."
}
part_time() { tests/bench/run_time.sh "$build"; echo; echo "$machine."; }
part_stock() {
  local bed said=$runs/stock.log
  bed=$("$build/bin/footfall" run inputs/landing_script --until 1e-3 --force --set output.plots=false --out "$runs/bed" | sed -n 's/^Bed: //p')
  tests/bench/stock_ratio.sh "$build" "$bed" -t 0.3 -p "${PAIRS:-10}" >"$said"
  tests/bench/stock_ratio.sh "$build" "$bed" -r 1 -t 0.1 -p "${PAIRS:-10}" >"$runs/stock_one_rank.log"
  tests/bench/stock_ratio.sh "$build" "$bed" -n 1 -t 0.1 -p "${PAIRS:-10}" >"$runs/stock_every_step.log"
  tests/bench/stock_ratio.sh "$build" "$bed" -c -t 0.01 >"$runs/stock_count.log"
  show_stock
}
show_stock() {
  local said=$runs/stock.log
  awk '/^coupled/ { gsub(/,/, " ")
                    if (!n++) print "| pair | coupled [s] | stock [s] | ratio | ratio of processor time |\n|---|---|---|---|---|"
                    print "| " n " | " $2 " | " $5 " | " $8 " | " $10 " |"
                    for (i = n; i > 1 && ratio[i - 1] > $8; --i) ratio[i] = ratio[i - 1]
                    ratio[i] = $8
                    for (i = 11; i <= NF; ++i) { if ($i == "dem") { d = $(i + 1); all += d; if (!least || d < least) least = d; if (d > most) most = d }
                      if ($i == "mbd") worked += $(i + 1)
                      if ($i == "waited") { all += $(i + 1); waited += $(i + 1); knows = 1 } }
                    lists = $(NF - 2); stock_lists = $NF }
       /median of/ { wall = $0; sub(/.*wall /, "", wall); sub(/,.*/, "", wall); processor = $0; sub(/.*processor /, "", processor); sub(/ .*/, "", processor)
                     print "| median | | | " wall " | " processor " |" }
       END { printf "\nThe middle half of the ratios lies between %.3f and %.3f. Ours built %d neighbour lists and stock %d. The mechanism worked for %.1f %% of the time of the windows", ratio[int((n + 3) / 4)], ratio[n + 1 - int((n + 3) / 4)], lists, stock_lists, 100 * worked / all
             if (knows) printf ", and the grains waited for it and the exchange for %.1f %%", 100 * waited / all
             printf "; the grains took %.0f to %.0f s.\n\n", least, most }' "$said"
  printf '| the same, otherwise | median of ratios | of processor time | pairs |\n|---|---|---|---|\n'
  awk '/median of/ { what = $0; sub(/: median.*/, "", what); sub(/^1 ranks/, "1 rank", what)
         gsub(/,/, ""); for (i = 1; i < NF; ++i) { if ($i == "of") pairs = $(i + 1); if ($i == "wall") wall = $(i + 1); if ($i == "processor") own = $(i + 1) }
         print "| " what " | " wall " | " own " | " pairs " |" }' "$runs/stock_one_rank.log" "$runs/stock_every_step.log"
  sed -n 's/^\(.*\) s, instructions of LIGGGHTS on one rank: .* ratio \(.*\)$/| instructions of LIGGGHTS on one rank, first \1 s | \2 | - | 1 |/p' "$runs/stock_count.log"
  printf '\n%s.\n' "$machine"
}
part_simbody() {
  rm -rf "$runs/simbody"
  tests/bench/simbody/run.sh "$build" "$runs/simbody" >/dev/null
  keep_picture "$runs/simbody/simbody.png" docs/pictures/simbody.png
  printf '%s; runs took turns and the shortest counts.\n\n' "$machine"
  cat "$runs/simbody/simbody.md"
  printf '\nThe same in instructions (valgrind), without those to the first step:\n\n'
  cat "$runs/simbody/simbody_instructions.md"
  printf '\nThe same lander with voltages that change every millisecond, as a controller changes them (`sampled.toml`). Errors of Merson count from the reference of CPodes.\n\n'
  cat "$runs/simbody/simbody_sampled.md"
}
part_size() {
  rm -rf "$runs/size"
  tests/bench/size.sh "$build" "$runs/size" >/dev/null
  keep_picture "$runs/size/size.png" docs/pictures/size.png
  cat "$runs/size/size.md"
}

mkdir -p "$runs"
make_parts docs/data/speed "${@:2}"
