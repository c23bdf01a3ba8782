#!/usr/bin/env bash
# run.sh [LABEL...]: the tests of these labels (default: all, the whole suite) in a build of its own (build-sanitize) with the address and
# undefined-behaviour sanitizers of clang++ (it compiles them in a third of the time; without it, of g++). Every finding ends its test. What cannot hold under them
# is left out by name: left_out.txt, with the reasons. Two more names stand for what has no label; both are part of the default:
#   threads          the tests that have threads, under the thread sanitizer (build-sanitize-thread)
#   valgrind         a part of the unit tests and three programs under valgrind, where it is installed, from the plain build
# What each came to is kept as a line in build-sanitize/NAME.line; docs/data/remake/reliability.sh makes its page of these.
#   BUILD=FOLDER     the plain build (default build)
#   BUILT=1          takes the tests as they are built; TARGETS: what is built (default all; tests that are not there are counted)
#   LABELS           instead of the default
#   GO_ON=1          goes on with a label that was cut off, of the same build: what has passed is not run again
#   SECONDS_OF_TEST  a test that takes longer, sanitized, is ended and counted, whatever limit it has in the plain build (default 900); TESTS_AT_ONCE (default 1)
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build-sanitize plain=$(cd "${BUILD:-$root/build}" 2>/dev/null && pwd)
labels=("$@")
((${#labels[@]})) || labels=(${LABELS:-unit bad_input physics mpi dem example accuracy stock threads valgrind})
[[ -n ${CXX-} ]] || CXX=$(command -v clang++ || command -v g++)
export CXX
compiler=$("$CXX" --version | sed -n '1s/.*clang version \([0-9.]*\).*/clang++ \1/p; 1s/^g++.* \([0-9.]*\)$/g++ \1/p')
commit() { echo "$(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo "no commit") ($(date +%F))"; }
failed=0 built=0
# say NAME BUILD TEXT: for people, and for the page; with the commit that was built.
say() { echo "$1, $3; at $(cat "$2/commit" 2>/dev/null || commit)" | tee "$build/$1.line"; }

build_here() { # FOLDER SANITIZERS TARGET...
  local folder=$1
  [[ -f $folder/build.ninja ]] ||
    cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Sanitize -DCMAKE_CXX_FLAGS=-O1 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
      -DFOOTFALL_SANITIZE="$2" >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
  [[ -n ${BUILT-} ]] && return
  cmake --build "$folder" -j 2 --target "${@:3}" >"$folder/build.log" 2>&1 || { tail -n 40 "$folder/build.log"; exit 1; }
  commit >"$folder/commit"
}

# of_label LABEL: its tests with the address and undefined sanitizers. Reports of an allocator that is out of memory are of no account: they come from readers that
# are not ours, in processes of their own that may ask for too much (scene/read_apart.h); what that comes to is told by the test.
of_label() {
  local label=$1 left_out absent late bad names log=$build/$1.txt chosen numbers=()
  left_out=$(sed -n 's/^\([^# ][^ ]*\) .*/\1/p' "$here/left_out.txt" | paste -sd'|')
  find "$build/tests" -name '*.cmake' -exec sed -i -E "s/TIMEOUT \"?[0-9]+\"?/TIMEOUT ${SECONDS_OF_TEST:-900}/g" {} +
  (
    export LD_PRELOAD=$preload
    export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:fast_unwind_on_malloc=0 LSAN_OPTIONS=suppressions=$here/leaks.txt:print_suppressions=0
    export UBSAN_OPTIONS=print_stacktrace=1 LDFLAGS=-fsanitize=address,undefined
    chosen=(-L "^$label\$" -E "^structure\.|^($left_out)( .*)?\$")
    if [[ -n ${GO_ON-} && -f $log ]]; then
      sed -i -n '/ Passed /p' "$log"
      # By name: numbers move when a test is added.
      mapfile -t numbers < <(ctest --test-dir "$build" -N "${chosen[@]}" |
        awk 'function name() { sub(/^.*Test *#[0-9]*: /, ""); sub(/  # .*/, ""); sub(/ \.\.\.+ .*/, ""); return $0 }
             NR == FNR { passed[name()] = 1; next }
             match($0, /^ *Test *#[0-9]+: /) { number = $0; sub(/^ *Test *#/, "", number); sub(/:.*/, "", number); if (!(name() in passed)) print number }' "$log" -)
      ((${#numbers[@]})) || exit 0
      chosen=(-I "0,0,0,$(IFS=,; echo "${numbers[*]}")")
    else
      : >"$log"
    fi
    ctest --test-dir "$build" "${chosen[@]}" -j "${TESTS_AT_ONCE:-1}" --timeout "${SECONDS_OF_TEST:-900}" --output-on-failure >>"$log" 2>&1
  )
  absent=$(grep -c '\*\*\*Not Run\|_NOT_BUILT' "$log")
  late=$(grep -c '\*\*\*Timeout' "$log") bad=$(grep -c '\*\*\*Failed\|\*\*\*Exception' "$log")
  names=$(sed -n 's/^ *[0-9]*\/[0-9]* Test *#[0-9]*: \([^ ]*\) .*\*\*\*\(Failed\|Exception\).*/\1/p' "$log" | paste -sd' ')
  ((bad == 0)) || failed=1
  say "$label" "$build" "address and undefined ($compiler): $(grep -c ' Passed ' "$log") passed, $bad failed${names:+ ($names)}, $(
    grep 'ERROR: AddressSanitizer\|ERROR: LeakSanitizer\|runtime error: ' "$log" | grep -vc 'allocator is out of memory') reports of a sanitizer, $late too long, $absent not built, $(
    ctest --test-dir "$build" -N -L "^$label\$" -R "^($left_out)( .*)?\$" | sed -n 's/^Total Tests: //p') left out by name"
}

# Threads are in tests alone, where two ends of a conversation run in one process.
threads() {
  local folder=$root/build-sanitize-thread names=(unit_coupler unit_liggghts_fix unit_coupling dem_loopback) name said="" ran found
  build_here "$folder" thread "${names[@]}"
  for name in "${names[@]}"; do
    [[ -x $folder/bin/$name ]] || { said+="${said:+; }$name not built"; continue; }
    TSAN_OPTIONS=halt_on_error=1 "$folder/bin/$name" --gtest_brief=1 >"$folder/$name.txt" 2>&1 || failed=1 bad=1
    ran=$(sed -n 's/.*\] *\([0-9]* tests*\) from.* ran.*/\1/p' "$folder/$name.txt" | tail -n 1) found=$(grep -c 'WARNING: ThreadSanitizer' "$folder/$name.txt")
    said+="${said:+; }$name ${ran:-0 tests}, $(grep -ac '^\[  FAILED  \] [^ ]*$\|^\[  FAILED  \] .*ms)$' "$folder/$name.txt") failed, $found findings"
  done
  say threads "$folder" "thread sanitizer ($compiler): $said"
}

# As much as runs in a few minutes. Leaks of gnuplot and its libraries are theirs. Left out: tests that count requests of the heap with an operator new of their
# own, which valgrind replaces; and the verdict of the coupled run on its memory, which is valgrind's here.
valgrind_part() {
  local part said="" bad=0
  command -v valgrind >/dev/null || { echo "valgrind is missing (a Debian package)"; return; }
  under() { # NAME COMMAND...
    local name=$1 code
    valgrind -q --trace-children=yes --trace-children-skip='*gnuplot*' --error-exitcode=9 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
      --suppressions="$here/valgrind.txt" --log-file="$build/valgrind_$name.%p.txt" "${@:2}" >"$build/valgrind_$name.out" 2>&1
    code=$?
    ((code == 0 || (code != 9 && ${own_verdict:-1} == 0))) || { failed=1; bad=$((bad + 1)); said+=" failed: $name;"; }
  }
  rm -f "$build"/valgrind_*
  for part in base coupler laws model controllers output integrator run; do
    [[ -x $plain/bin/unit_$part ]] || { said+=" not built: unit_$part;"; continue; }
    under "$part" "$plain/bin/unit_$part" --gtest_brief=1 --gtest_filter='-*WithoutTheHeap*:*TakesNoMemory*'
    said+=" unit_$part $(sed -n 's/.*\] *\([0-9]* tests*\) from.* ran.*/\1/p' "$build/valgrind_$part.out" | tail -n 1);"
  done
  under check "$plain/bin/footfall" check "$root/inputs/reference/scene.toml"
  under plane "$plain/bin/mbd_solver" "$root/inputs/rigid_plane/scene.toml" --set end_time=0.01 --out "$build/valgrind_plane"
  own_verdict=0 under loopback "$plain/bin/endurance_loopback" 200
  rm -rf "$build/valgrind_plane"
  say valgrind /nowhere "memcheck and leaks:$said footfall check of the scene of every key; mbd_solver on the rigid plane with flexible legs; a coupled run in one process: $bad failed, $(
    cat "$build"/valgrind_*.*.txt | grep -c '==.*at 0x') places told"
}

# What Open MPI's plugins keep can be told from ours only while they are there, and by whole stacks.
preload=$build/kept.so
for name in "${labels[@]}"; do
  case $name in
    threads) threads ;;
    valgrind) mkdir -p "$build"; valgrind_part ;;
    *)
      ((built)) || build_here "$build" address,undefined ${TARGETS:-all}
      built=1
      echo 'int dlclose(void* handle) { (void)handle; return 0; }' | "$CXX" -x c -shared -fPIC -o "$build/kept.so" - || exit 1
      [[ $compiler == clang* ]] || preload=$("$CXX" -print-file-name=libasan.so):$build/kept.so  # a runtime of its own comes first
      of_label "$name"
      ;;
  esac
done
exit $failed
