#!/usr/bin/env bash
# run.sh [LABEL...]: the tests of these labels (default: unit bad_input physics mpi) in a build of its own (build-sanitize) with the address and undefined-behaviour
# sanitizers of clang++ (it compiles them in a third of the time; without it, of g++). Every finding ends its test. Without labels also the tests that have
# threads under the thread sanitizer (build-sanitize-thread), and a part of the unit tests under valgrind, where it is installed, from the plain build.
#   BUILD=FOLDER     the plain build (default build)
#   BUILT=1          takes the tests as they are built; TARGETS: what is built (default all; tests that are not there are counted)
#   LABELS           instead of the default, with valgrind
#   SECONDS_OF_TEST  a test that takes longer, sanitized, is left out and counted (default 120)
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build-sanitize plain=${BUILD:-$root/build}
labels=("$@")
((${#labels[@]})) || labels=(${LABELS:-unit bad_input physics mpi})
[[ -n ${CXX-} ]] || CXX=$(command -v clang++ || command -v g++)
export CXX
[[ -f $build/build.ninja ]] ||
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Sanitize -DCMAKE_CXX_FLAGS=-O1 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
    -DFOOTFALL_SANITIZE=address,undefined >"$build.log" 2>&1 || { cat "$build.log"; exit 1; }
[[ -n ${BUILT-} ]] || cmake --build "$build" -j 2 --target ${TARGETS:-all} >"$build/build.log" 2>&1 || { tail -n 40 "$build/build.log"; exit 1; }
# What Open MPI's plugins keep can be told from ours only while they are there, and by whole stacks.
echo 'int dlclose(void* handle) { (void)handle; return 0; }' | "$CXX" -x c -shared -fPIC -o "$build/kept.so" - && preload=$build/kept.so
[[ $("$CXX" --version) == *clang* ]] || preload=$("$CXX" -print-file-name=libasan.so):$preload  # a runtime of its own comes first
export LD_PRELOAD=$preload
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:fast_unwind_on_malloc=0 LSAN_OPTIONS=suppressions=$here/leaks.txt:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
failed=0
for label in "${labels[@]}"; do
  ctest --test-dir "$build" -L "^$label\$" -E '^structure\.' --timeout "${SECONDS_OF_TEST:-120}" --output-on-failure >"$build/$label.txt" 2>&1
  absent=$(grep -c '\*\*\*Not Run\|_NOT_BUILT' "$build/$label.txt")
  late=$(grep -c '\*\*\*Timeout' "$build/$label.txt") bad=$(grep -c '\*\*\*Failed\|\*\*\*Exception' "$build/$label.txt")
  ((bad == 0)) || failed=1
  echo "$label, address and undefined: $(grep -c ' Passed ' "$build/$label.txt") passed, $bad failed, $late too long, $absent not built"
done
unset LD_PRELOAD
(($#)) && exit $failed
# Threads are in tests alone, where two ends of a conversation run in one process.
threads=$root/build-sanitize-thread threaded=(unit_coupler unit_liggghts_fix unit_coupling two_mass_loopback_test)
[[ -f $threads/build.ninja ]] ||
  cmake -S "$root" -B "$threads" -G Ninja -DCMAKE_BUILD_TYPE=Sanitize -DCMAKE_CXX_FLAGS=-O1 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
    -DFOOTFALL_SANITIZE=thread >"$threads.log" 2>&1 || { cat "$threads.log"; exit 1; }
[[ -n ${BUILT-} ]] || cmake --build "$threads" -j 2 --target "${threaded[@]}" >"$threads/build.log" 2>&1 || { tail -n 40 "$threads/build.log"; exit 1; }
for name in "${threaded[@]}"; do
  [[ -x $threads/bin/$name ]] || continue
  TSAN_OPTIONS=halt_on_error=1 "$threads/bin/$name" --gtest_brief=1 >"$threads/$name.txt" 2>&1 || failed=1
  echo "$name, threads: $(grep -a 'tests* ran\|PASSED' "$threads/$name.txt" | tail -n 1 | sed 's/.*] *//'), $(grep -c 'WARNING: ThreadSanitizer' "$threads/$name.txt") findings"
done
# As much as runs in a few minutes; gtest's own filter where a part is long.
if command -v valgrind >/dev/null; then
  for part in base coupler laws model controllers output integrator run; do
    [[ -x $plain/bin/unit_$part ]] || continue
    valgrind -q --error-exitcode=9 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite --suppressions="$here/valgrind.txt" \
      --log-file="$build/valgrind_$part.txt" "$plain/bin/unit_$part" --gtest_brief=1 >"$build/valgrind_$part.out" 2>&1 || failed=1
    echo "valgrind, unit_$part: $(tail -n 1 "$build/valgrind_$part.out"), $(grep -c 'ERROR SUMMARY\|==.*at 0x' "$build/valgrind_$part.txt") places told"
  done
fi
exit $failed
