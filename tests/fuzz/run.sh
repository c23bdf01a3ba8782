#!/usr/bin/env bash
# run.sh [SECONDS [KIND...]]: each kind of input with libFuzzer for so many seconds (default 60; an hour each: run.sh 3600), in a build of its own (build-fuzz) with
# clang. Readers of one kind share its time. A target's own name does as well.
# Undefined behaviour is a finding as a crash is (pointer-overflow excepted: Eigen adds an offset to the null pointer of an empty matrix).
# What is new goes to build-fuzz/corpus; findings to build-fuzz/findings. A finding that is mended is copied to tests/fuzz/corpus/NAME, where the tests replay it.
# A go begins with these and with what earlier goes have kept in tests/fuzz/grown.tar.gz: as few inputs as reach what they have reached.
# What each go came to is added to a ledger: KIND NAME INPUTS SECONDS FINDINGS COMMIT DATE, a line for each commit and day; the seconds are those of a processor, so
# that an hour may be made of many goes on machines that do other things as well. docs/reliability.sh makes its page of docs/fuzzed.txt.
#   LEDGER    (default build-fuzz/fuzzed.txt)
#   JOBS      targets at once (default 1)
#   SEED      the same inputs every time, as many as there is time for (default: others every time)
#   BUILT=1   takes the targets as they are built
#   KEEP=1    puts what is new into grown.tar.gz at the end
set -euo pipefail
TIMEFORMAT='%U %S'
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
seconds=${1:-60}; shift || true
build=$root/build-fuzz
echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, long) { return 0; }' | clang++ -x c++ -fsanitize=fuzzer - -o /dev/null 2>/dev/null ||
  { echo "run.sh: clang++ or its libFuzzer is missing (Debian packages: clang libclang-rt-dev)"; exit 2; }
declare -A targets=([scene]=scene [experiment]="experiment calibration" [fll]=fll [mesh]="mesh_stl mesh_obj mesh_ply" [mtx]=mtx [modal]=modal
  [csv]="two_columns history" [read_back]="summary start" [checkpoint]=checkpoint [bed]=bed [messages]=messages)
kinds=("$@")
((${#kinds[@]})) || kinds=(messages fll mesh read_back csv modal mtx experiment scene checkpoint bed)
names=()
for kind in "${kinds[@]}"; do names+=(${targets[$kind]-$kind}); done
share() { # TARGET: its seconds
  local kind of=1
  for kind in "${kinds[@]}"; do [[ " ${targets[$kind]-} " == *" $1 "* ]] && of=$(wc -w <<<"${targets[$kind]}"); done
  echo $(((seconds + of - 1) / of))
}
if [[ ! -f $build/build.ninja ]]; then
  CXX=clang++ CC=clang cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Fuzz -DFOOTFALL_FUZZ=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
    -DCMAKE_CXX_FLAGS="-O1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-sanitize=pointer-overflow -DFOOTFALL_SANITIZED -w" >/dev/null
fi
if [[ -z ${BUILT-} ]]; then
  cmake --build "$build" --target "${names[@]/#/libfuzzer_}"
  echo "$(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo none) $(date +%F)" >"$build/commit"
fi
[[ -w /dev/shm ]] && export TMPDIR=/dev/shm  # every input is a file
grown=$(mktemp -d)  # of this call: another one may run beside it
trap 'rm -rf "$grown"' EXIT
tar -xzf "$here/grown.tar.gz" -C "$grown"
# All that was found, as few of it as reach the same places.
keep_grown() {
  local name merged=$build/merged
  rm -rf "$merged"
  for name in ${targets[*]}; do
    mkdir -p "$merged/$name" "$build/corpus/$name" "$grown/$name"
    # A merge runs every input once more in a process of its own, which a reader in a third process does not stand.
    [[ -x $build/bin/libfuzzer_$name && $name != mesh_* ]] || { cp -r "$grown/$name/." "$build/corpus/$name/." "$merged/$name"; continue; }
    ASAN_OPTIONS=$asan "$build/bin/libfuzzer_$name" -merge=1 -max_len=65536 "$merged/$name" "$grown/$name" "$build/corpus/$name" >"$build/findings/$name.merge" 2>&1
  done
  tar --sort=name --mtime=2026-01-01 --owner=0 --group=0 --numeric-owner -C "$merged" -cf - . | gzip -9n >"$here/grown.tar.gz"
}
asan=detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=1024:symbolize=0
ledger=${LEDGER:-$build/fuzzed.txt}
kind_of() { # TARGET
  local kind
  for kind in "${!targets[@]}"; do [[ " ${targets[$kind]} " != *" $1 "* ]] || echo "$kind"; done
}
keep() { # NAME INPUTS SECONDS FINDINGS
  (
    flock 9
    { cat "$ledger" 2>/dev/null || true; echo "$(kind_of "$1") $* $(cat "$build/commit")"; } |
      awk '{ k = $1 " " $2 " " $6 " " $7; if (!(k in n)) order[++lines] = k; n[k] += $3; s[k] += $4; f[k] += $5 }
           END { for (i = 1; i <= lines; ++i) { k = order[i]; split(k, w, " "); print w[1], w[2], n[k], s[k], f[k], w[3], w[4] } }' >"$ledger.new" && mv "$ledger.new" "$ledger"
  ) 9>"$build/ledger.lock"
}
one() {
  local name=$1 mine
  mine=$(share "$1")
  mkdir -p "$build/corpus/$name" "$build/findings/$name"
  # Files larger than 64 kB say nothing new; a reader that needs 10 s for one hangs.
  # On the clock on the wall, which runs on where the machine does something else: an input counts as a finding when it needs 10 s of processor time.
  local failed=0 end=$((SECONDS + mine)) late done_now runs=0 spent=0 log=$build/findings/$name.log
  : >"$log.all"
  # In an order that does not depend on the disk.
  find "$here/corpus/$name" "$grown/$name" -type f 2>/dev/null | sort | paste -sd, >"$build/findings/$name.begin"
  while ((end - SECONDS > 0)); do
    rm -f "$build/findings/$name"/timeout-*
    { time fuzz_once "$name" $((end - SECONDS)) || failed=1; } 2>"$log.time"
    spent=$(awk -v so_far="$spent" '{ print so_far + $1 + $2 }' "$log.time")
    done_now=$(sed -n 's/^#\([0-9]*\).*/\1/p; s/^Done \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
    runs=$((runs + ${done_now:-0}))
    cat "$log" >>"$log.all"
    late=$(compgen -G "$build/findings/$name/timeout-*" | head -n 1 || true)
    [[ -n $late ]] || break
    (ulimit -t 10; quietly "$build/bin/libfuzzer_$name" "$late") || break
    failed=0
  done
  if ((failed)); then # once more, with the names of places
    "$build/bin/libfuzzer_$name" "$(find "$build/findings/$name" -type f -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2-)" >>"$log" 2>&1 || true
    echo "$name: a finding, see $log"
  fi
  keep "$name" "$runs" "${spent%.*}" "$failed"
  echo "$name: $runs inputs in $spent s$( ((failed)) && grep -a '^SUMMARY' "$log" | tail -n 1 | sed 's/^/, /')"
  return $failed
}
quietly() { "$@" >/dev/null 2>&1; }
# A reader that is not ours may end in its own process (scene/read_apart.h): its report has no names of places, which would take seconds, and it gets no more
# memory at once than outside of the sanitizers.
fuzz_once() { # NAME SECONDS
  local name=$1
  ASAN_OPTIONS=$asan UBSAN_OPTIONS=print_stacktrace=1 "$build/bin/libfuzzer_$name" -max_total_time="$2" -seed="${SEED:-0}" -max_len=65536 \
    -timeout=10 -rss_limit_mb=4096 -artifact_prefix="$build/findings/$name/" -seed_inputs=@"$build/findings/$name.begin" "$build/corpus/$name" \
    >"$build/findings/$name.log" 2>&1
}
failed=0
for name in "${names[@]}"; do
  one "$name" &
  while (($(jobs -pr | wc -l) >= ${JOBS:-1})); do wait -n || failed=1; done
done
while [[ -n $(jobs -pr) ]]; do wait -n || failed=1; done
[[ -z ${KEEP-} ]] || keep_grown
exit $failed
