#!/usr/bin/env bash
# One idea per file: no source that people write has more than 300 lines. web/dist is bundled from web/src.
set -u
cd "$(dirname "$0")/../.."
most=300
failed=0 seen=0
while IFS= read -r -d '' file; do
  seen=$((seen + 1))
  lines=$(wc -l <"$file")
  ((lines <= most)) && continue
  echo "$file: $lines lines, expected at most $most; give what is an idea of its own a file of its own"
  failed=1
done < <(find coupler liggghts_fix mbd_solver \( -name dist -o -name node_modules \) -prune -o \
         -type f -regextype egrep -regex '.*\.(cpp|h|in|js|mjs|css|sh)' -print0)
((seen >= 700)) || { echo "only $seen sources were found: this check is blind"; failed=1; }
exit $failed
