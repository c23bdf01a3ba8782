#!/usr/bin/env bash
# new.sh FOOTFALL OUT: every case of `footfall new --list` is made, checks, and runs at once (shortened, on the small beds of its own or,
# where the bed is large, on a smaller one); what is there is not written over.
set -euo pipefail
footfall=$1 out=$2
rm -rf "$out" && mkdir -p "$out" && cd "$out"
die() { echo "new.sh: $*"; exit 1; }
# Smaller beds where pouring takes long.
declare -A smaller=(
  [lander]="--set particles.bed.variables.width=1.1 --set particles.variables.width=1.1 --set particles.bed.variables.depth=0.12 --set particles.bed.variables.fine=0.4
    --set particles.bed.variables.fine_depth=0.06 --set particles.bed.variables.rest=0.05 --ranks 1"
  [drop]="--set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42 --set particles.bed.variables.width=0.42
    --set particles.bed.variables.depth=0.2 --set particles.bed.variables.settle=0.5"
)
cases=0
while read -r name _; do
  cases=$((cases + 1))
  "$footfall" new "my_$name" --from "$name" > said
  grep -q "run my_$name" said || die "$name: does not say how to go on"
  [[ $(wc -l < "my_$name/README.md") == 3 ]] || die "$name: README.md has not three lines"
  "$footfall" check "my_$name" > said 2>&1 || { cat said; die "$name: does not check"; }
  read -ra settings <<< "$(tr '\n' ' ' <<< "${smaller[$name]-}")"
  "$footfall" run "my_$name" --until 0.01 --quiet --out "run_$name" "${settings[@]}" > said 2>&1 || { cat said; die "$name: does not run"; }
  grep -q '"status": "done"' "run_$name/summary.json" || die "$name: is not done"
  # The copy lives without what it was copied from.
  if grep -q -e "inputs/regolith" -e "inputs/dropped" "run_$name/liggghts.log" 2>/dev/null; then die "$name: reads files of the program"; fi
done < <("$footfall" new --list)
((cases >= 10)) || die "only $cases cases"

# refused EXPECTED ARGUMENTS...
refused() {
  local expected=$1 code=0; shift
  "$footfall" new "$@" > refused 2>&1 || code=$?
  [[ $code == 2 ]] && grep -q -e "$expected" refused || { cat refused; die "not refused: $*"; }
}
refused 'is there already' my_wheel --from wheel
refused 'Did you mean "wheel"' other --from whel
refused 'as in' other
refused 'letters, digits' 'my case' --from wheel
[[ ! -e other && ! -e 'my case' ]] || die "something was made of what was refused"
