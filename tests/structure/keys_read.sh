#!/usr/bin/env bash
# A key that is read must do something: every member that a description of keys fills is read elsewhere, by more than a
# check. Members are known by their names alone, so one that shares its name with another member is not told.
set -u
cd "$(dirname "$0")/../.."
mapfile -t described < <(find mbd_solver -name 'fields_*.cpp' -o -name '*_fields.cpp')
((${#described[@]} >= 9)) || { echo "only these descriptions of keys were found: ${described[*]}"; exit 1; }
filled=$(grep -hv 'one\.key' "${described[@]}" |  # the loop of a list of keys
         grep -oE '[ (&{][a-z_]+(\.[A-Za-z_0-9]+)+ *[,)}]' | grep -oE '[A-Za-z_0-9]+ *[,)}]$' |
         tr -d ' ,)}' | sort -u)
(($(wc -l <<<"$filled") >= 250)) || { echo "only these members were found: $filled"; exit 1; }
read_somewhere=$(find mbd_solver -name '*.cpp' -o -name '*.h' |
                 grep -vE '/(fields_[a-z]+|[a-z]+_fields|check_[a-z]+)\.cpp$' | xargs sed 's,//.*,,' |
                 grep -oE '(\.|->)[A-Za-z_0-9]+' | sed -E 's/^(\.|->)//' | sort -u)
failed=0
while IFS= read -r member; do
  echo "$(grep -lE "\.$member\b" "${described[@]}" | head -n 1): $member: a key fills it and nothing reads it"
  failed=1
done < <(comm -23 <(printf '%s\n' "$filled") <(printf '%s\n' "$read_somewhere"))
exit $failed
