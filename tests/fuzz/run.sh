#!/usr/bin/env bash
# run.sh [SECONDS [TARGET...]]: each reader of targets.cpp with libFuzzer for so many seconds (default 60), in a build of its own (build-fuzz) with clang.
# Undefined behaviour is a finding as a crash is (pointer-overflow excepted: Eigen adds an offset to the null pointer of an empty matrix).
# Findings go to build-fuzz/findings. A finding that is corrected becomes a file of the corpus: run.sh keep TARGET FILE.
# Each run adds a line to a ledger: TARGET INPUTS SECONDS FINDINGS COMMIT DATE, in processor seconds.
#   LEDGER  (default build-fuzz/fuzzed.txt)    JOBS  targets at once (default 1)    BUILT=1  takes the program as it is built
#   SEED    the same inputs every time         KEEP=1  puts what is new into grown.tar.gz, which later runs begin with
set -euo pipefail
TIMEFORMAT='%U %S'
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build-fuzz work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pack() { tar --sort=name --mtime=2026-01-01 --owner=0 --group=0 --numeric-owner -C "$1" -cf - . | gzip -9n >"$2"; } # FOLDER FILE
mkdir "$work/corpus" "$work/grown"
tar -xzf "$here/corpus.tar.gz" -C "$work/corpus"
tar -xzf "$here/grown.tar.gz" -C "$work/grown"
if [[ ${1-} == keep ]]; then
  cp "$3" "$work/corpus/$2/" && pack "$work/corpus" "$here/corpus.tar.gz"
  exit
fi
seconds=${1:-60}; shift || true
names=("$@")
((${#names[@]})) || mapfile -t names < <(ls "$work/corpus")
echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, long) { return 0; }' | clang++ -x c++ -fsanitize=fuzzer - -o /dev/null 2>/dev/null ||
  { echo "run.sh: clang++ or its libFuzzer is missing (Debian packages: clang libclang-rt-dev)"; exit 2; }
[[ -f $build/build.ninja ]] ||
  cmake --preset fuzz -S "$root" -B "$build" >/dev/null
[[ -n ${BUILT-} ]] || cmake --build "$build" --target libfuzzer
commit="$(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo none) $(date +%F)"
ledger=${LEDGER:-$build/fuzzed.txt}
[[ -w /dev/shm ]] && export TMPDIR=/dev/shm  # every input is a file
# A reader that is not ours may end in its own process (read_apart.h): its report has no names of places, which would take seconds, and it
# gets no more memory at once than outside of the sanitizers.
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=1024:symbolize=0 UBSAN_OPTIONS=print_stacktrace=1
fuzz() { FOOTFALL_FUZZ_TARGET=$1 "$build/bin/libfuzzer" "${@:2}"; } # TARGET OPTION...

one() { # TARGET
  local name=$1 failed=0 end=$((SECONDS + seconds)) runs=0 spent=0 log=$build/findings/$1.log late
  mkdir -p "$build/corpus/$name" "$build/findings/$name" "$work/grown/$name"
  find "$work/corpus/$name" "$work/grown/$name" -type f 2>/dev/null | sort | paste -sd, >"$work/$name.begin" # in an order that does not depend on the disk
  while ((end > SECONDS)); do
    rm -f "$build/findings/$name"/timeout-*
    { time fuzz "$name" -max_total_time=$((end - SECONDS)) -seed="${SEED:-0}" -max_len=65536 -timeout=10 -rss_limit_mb=4096 -artifact_prefix="$build/findings/$name/" \
        -seed_inputs=@"$work/$name.begin" "$build/corpus/$name" >"$log" 2>&1 || failed=1; } 2>"$work/$name.time"
    spent=$(awk -v so_far="$spent" '{ print so_far + $1 + $2 }' "$work/$name.time")
    runs=$((runs + $(sed -n 's/^#\([0-9]*\).*/\1/p; s/^Done \([0-9]*\) .*/\1/p' "$log" | tail -n 1)))
    # libFuzzer measures wall time: an input counts as a finding when it needs 10 s of processor time.
    late=$(compgen -G "$build/findings/$name/timeout-*" | head -n 1 || true)
    [[ -n $late ]] && (ulimit -t 10; fuzz "$name" "$late" >/dev/null 2>&1) || break
    failed=0
  done
  ((failed == 0)) || echo "$name: a finding in $build/findings/$name, see $log"
  echo "$name: $runs inputs in $spent s$( ((failed)) && grep -a '^SUMMARY' "$log" | tail -n 1 | sed 's/^/, /')"
  (flock 9; echo "$name $runs ${spent%.*} $failed $commit" >>"$ledger") 9>"$build/ledger.lock"
  return $failed
}
failed=0
for name in "${names[@]}"; do
  one "$name" &
  while (($(jobs -pr | wc -l) >= ${JOBS:-1})); do wait -n || failed=1; done
done
while [[ -n $(jobs -pr) ]]; do wait -n || failed=1; done
if [[ -n ${KEEP-} ]]; then # as few inputs as reach the same places
  for name in "${names[@]}"; do
    [[ $name == mesh_* ]] && continue  # a merge runs each input in a process of its own, which a reader in a third process does not stand
    mkdir "$work/merged"
    fuzz "$name" -merge=1 -max_len=65536 "$work/merged" "$work/grown/$name" "$build/corpus/$name" >"$build/findings/$name.merge" 2>&1
    rm -rf "$work/grown/$name" && mv "$work/merged" "$work/grown/$name"
  done
  pack "$work/grown" "$here/grown.tar.gz"
fi
exit $failed
