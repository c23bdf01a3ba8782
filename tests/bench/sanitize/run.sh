#!/usr/bin/env bash
# run.sh [LABEL...]: the tests of these labels (default: all tests of --all) in a build of its own (build-sanitize) with the address and undefined-behaviour sanitizers of
# clang++ (without it, of g++). Every finding ends its test. Tests that cannot hold there are named in left_out.txt, with the reasons. Two more names, both of the default:
#   threads          tests that have threads, under the thread sanitizer (build-sanitize-thread)
#   valgrind         some unit tests and two programs under valgrind, where it is installed, from the plain build
# The result of each is a line in build-sanitize/NAME.line, which docs/data takes over.
#   BUILD=FOLDER     the plain build (default build)
#   BUILT=1          takes the tests as they are built; TARGETS: what is built (default all)
#   SECONDS_OF_TEST  a test that takes longer is ended and counted, whatever limit it has in the plain build (default 900); TESTS_AT_ONCE (default 1)
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
build=$root/build-sanitize plain=$(cd "${BUILD:-$root/build}" 2>/dev/null && pwd)
labels=("$@")
((${#labels[@]})) || labels=(unit coupled app physics validation fuzz threads valgrind)
[[ -n ${CXX-} ]] || CXX=$(command -v clang++ || command -v g++)
export CXX
compiler=$("$CXX" --version | sed -n '1s/.*clang version \([0-9.]*\).*/clang++ \1/p; 1s/^g++.* \([0-9.]*\)$/g++ \1/p')
commit() { echo "$(git -C "$root" rev-parse --short HEAD 2>/dev/null || echo "no commit") ($(date +%F))"; }
failed=0 built=0
say() { echo "$1, $3; at $(cat "$2/commit" 2>/dev/null || commit)" | tee "$build/$1.line"; } # NAME BUILD TEXT
mkdir -p "$build"

build_here() { # FOLDER SANITIZERS TARGET...
  local folder=$1
  [[ -f $folder/build.ninja ]] ||
    cmake --preset sanitize -S "$root" -B "$folder" -DFOOTFALL_SANITIZE="$2" >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
  [[ -n ${BUILT-} ]] && return
  cmake --build "$folder" -j 2 --target "${@:3}" >"$folder/build.log" 2>&1 || { tail -n 40 "$folder/build.log"; exit 1; }
  commit >"$folder/commit"
}

# A group of tests has failed when one of its tests has that is not left out by name. Reports of an allocator that is out of memory do not count: they come from readers
# that are not ours, in processes of their own (read_apart.h).
of_label() { # LABEL
  local log=$build/$1.txt names bad
  find "$build/tests" -name '*.cmake' -exec sed -i -E "s/TIMEOUT \"?[0-9]+\"?/TIMEOUT ${SECONDS_OF_TEST:-900}/g" {} +
  (
    # What Open MPI's plugins hold can be told from ours only while they are loaded.
    export LD_PRELOAD=$preload
    export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:fast_unwind_on_malloc=0 LSAN_OPTIONS=suppressions=$here/leaks.txt:print_suppressions=0
    export UBSAN_OPTIONS=print_stacktrace=1 LDFLAGS=-fsanitize=address,undefined
    ctest --test-dir "$build" -L "^$1\$" -L 'tier_(quick|all)' -E '^structure\.|endurance' -j "${TESTS_AT_ONCE:-1}" --output-on-failure >"$log" 2>&1
  )
  names=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).* ms)$/\1/p' "$log" | grep -vxF -f <(sed -n 's/^\([^# ][^ ]*\) .*/\1/p' "$here/left_out.txt") | paste -sd' ')
  bad=$(wc -w <<<"$names")
  ((bad == 0)) || failed=1
  say "$1" "$build" "address and undefined ($compiler): $(grep -c ' Passed ' "$log") groups passed, $bad tests failed${names:+ ($names)}, $(
    grep 'ERROR: AddressSanitizer\|ERROR: LeakSanitizer\|runtime error: ' "$log" | grep -vc 'allocator is out of memory') reports of a sanitizer, $(
    grep -c '\*\*\*Timeout' "$log") too long"
}

threads() {
  local folder=$root/build-sanitize-thread names=(unit_coupler unit_liggghts_fix unit_coupling unit_run) name said=""
  build_here "$folder" thread "${names[@]}"
  for name in "${names[@]}"; do
    TSAN_OPTIONS=halt_on_error=1 "$folder/bin/$name" --gtest_brief=1 >"$folder/$name.txt" 2>&1 || failed=1
    said+="${said:+; }$name $(sed -n 's/.*\] *\([0-9]* tests*\) from.* ran.*/\1/p' "$folder/$name.txt" | tail -n 1), $(grep -c 'WARNING: ThreadSanitizer' "$folder/$name.txt") findings"
  done
  say threads "$folder" "thread sanitizer ($compiler): $said"
}

# Left out: tests that count requests of the heap with a malloc of their own, which valgrind replaces.
valgrind_part() {
  local part said="" bad=0
  command -v valgrind >/dev/null || { echo "valgrind is missing (a Debian package)"; return; }
  under() { # NAME COMMAND...
    valgrind -q --trace-children=yes --trace-children-skip='*gnuplot*' --error-exitcode=9 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
      --suppressions="$here/valgrind.txt" --log-file="$build/valgrind_$1.%p.txt" "${@:2}" >"$build/valgrind_$1.out" 2>&1 || { failed=1; bad=$((bad + 1)); said+=" failed: $1;"; }
  }
  rm -f "$build"/valgrind_*
  for part in base coupler model integrator run; do
    under "$part" "$plain/bin/unit_$part" --gtest_brief=1 --gtest_filter='-*WithoutTheHeap*:*TakesNoMemory*'
    said+=" unit_$part $(sed -n 's/.*\] *\([0-9]* tests*\) from.* ran.*/\1/p' "$build/valgrind_$part.out" | tail -n 1);"
  done
  under check "$plain/bin/footfall" check "$root/inputs/reference/scene.toml"
  under plane "$plain/bin/mbd_solver" "$root/inputs/rigid_plane/scene.toml" --set end_time=0.01 --out "$build/valgrind_plane"
  rm -rf "$build/valgrind_plane"
  say valgrind /nowhere "memcheck and leaks:$said footfall check of the reference scene; mbd_solver on the rigid plane with flexible legs: $bad failed"
}

preload=$build/loaded.so
for name in "${labels[@]}"; do
  case $name in
    threads) threads ;;
    valgrind) valgrind_part ;;
    *)
      ((built)) || build_here "$build" address,undefined ${TARGETS:-tests_all}
      built=1
      echo 'int dlclose(void* handle) { (void)handle; return 0; }' | "$CXX" -x c -shared -fPIC -o "$build/loaded.so" - || exit 1
      [[ $compiler == clang* ]] || preload=$("$CXX" -print-file-name=libasan.so):$build/loaded.so  # a runtime of its own comes first
      of_label "$name"
      ;;
  esac
done
exit $failed
