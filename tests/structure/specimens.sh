#!/usr/bin/env bash
# Every force element has a specimen between flexible bodies, so that its forces are held against its derivatives and its
# energy against its work. The angles that a gear counts stand there as parts of gears.
set -u
cd "$(dirname "$0")/../.."
specimens=tests/unit/dynamics/random_model.h
all_forces=$(sed -n '/^inline .*all_forces(/,/^}/p' "$specimens")
[[ $all_forces == *make_unique* ]] || { echo "$specimens: all_forces was not found"; exit 1; }
failed=0 seen=0
for name in $(grep -rhoE 'class [A-Za-z]+( final)? : public ForceElement' mbd_solver | cut -d ' ' -f 2 | sort -u); do
  seen=$((seen + 1))
  [[ $name == TurnCounter ]] && grep -q 'add_gear(' "$specimens" && continue
  header=$(grep -rlE "class $name( final)? :" mbd_solver)
  made_by=$name  # itself, or a function of the specimens that returns it
  while IFS= read -r maker; do made_by+="|$maker"; done < <(
    grep -oE "^inline std::unique_ptr<(ForceElement|$name)> [a-z_]+" "$specimens" | awk '{print $NF}' |
    while read -r function; do
      sed -n "/^inline .* $function(/,/^}/p" "$specimens" | grep -q "make_unique<$name>" && echo "$function"
    done)
  grep -qE "\b($made_by)\b" <<<"$all_forces" && continue
  echo "$header: $name has no specimen in all_forces of $specimens"
  failed=1
done
((seen >= 7)) || { echo "only $seen force elements were found: this check is blind"; failed=1; }
exit $failed
