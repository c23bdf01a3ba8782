#!/usr/bin/env bash
# The house style as tools see it. A tool or a history that is missing is said in one line and is no failure.
#   style.sh          clang-format on the C++ files changed since origin/main (else in the last 5 commits), and as much
#                     clang-tidy on the changed .cpp files as its time allows
#   style.sh --all    clang-format on the whole tree
set -u
cd "$(dirname "$0")/../.."
# A folder of its own: the front door builds whole libraries as one source, and clang-tidy wants to know each.
build=${FOOTFALL_BUILD:-build}/style
deadline=$((EPOCHSECONDS + 15))  # [s], of clang-tidy
failed=0

sources() { grep -E '^(coupler|mbd_solver|liggghts_fix|tests)/.*\.(h|cpp)$'; }
base=$(git merge-base HEAD origin/main 2>/dev/null) || base=$(git rev-list -n 6 HEAD 2>/dev/null | tail -n 1)
changed() {
  [[ -n $base ]] || { echo "style: no history here; nothing is known to have changed" >&2; return; }
  { git diff --name-only --diff-filter=d "$base"; git ls-files --others --exclude-standard; } | sources | sort -u
}

if [[ ${1-} == --all ]]; then
  mapfile -t files < <(find coupler mbd_solver liggghts_fix tests -type f | sources)
else
  mapfile -t files < <(changed)
fi
((${#files[@]})) || exit 0

if ! command -v clang-format >/dev/null; then
  echo "style: skipped, clang-format is missing (a Debian package)"
elif ! clang-format --dry-run -Werror "${files[@]}"; then
  echo "style: run  clang-format -i  on the files named above"
  failed=1
fi
[[ ${1-} == --all ]] && exit $failed

mapfile -t files < <(printf '%s\n' "${files[@]}" | grep '\.cpp$')
((${#files[@]})) || exit $failed
if ! command -v clang-tidy >/dev/null; then
  echo "style: clang-tidy is missing (a Debian package)"
  exit $failed
fi
[[ -f $build/compile_commands.json ]] || cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null 2>&1
if [[ ! -f $build/compile_commands.json ]]; then
  echo "style: no clang-tidy, $build is not configured"
  exit $failed
fi
# Each core takes the next file; who is not done in time is stopped. Only changed lines are judged.
tidy() {
  local left=$((deadline - EPOCHSECONDS)) lines found
  ((left > 0)) || { echo "not reached: $1"; return; }
  lines=$(git diff -U0 "$base" -- "$1" | sed -nE 's/^@@ .* \+([0-9]+)(,([0-9]+))? @@.*/\1 \3/p' |
          while read -r from count; do printf '[%d,%d],' "$from" $((from + ${count:-1} - 1)); done)
  found=$(timeout "$left" clang-tidy -p "$build" --quiet \
          --line-filter="[{\"name\":\"$1\"${lines:+,\"lines\":[${lines%,}]}}]" "$1" 2>/dev/null)
  (($? == 124)) && { echo "not reached: $1"; return; }
  [[ -z $found ]] || printf '%s\n' "$found"
}
export -f tidy
export build base deadline
said=$(printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c 'tidy {}')
left_out=$(grep -c '^not reached: ' <<<"$said")
((left_out)) && echo "style: clang-tidy had no time for $left_out of ${#files[@]} files"
if grep -qE ' (warning|error): .*\[[a-z]' <<<"$said"; then
  grep -v '^not reached: ' <<<"$said"
  failed=1
fi
exit $failed
