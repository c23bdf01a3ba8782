#!/usr/bin/env bash
# Comments point to docs/explanation/theory.md by section number ("theory 6.2"): every such section exists, and no comment points in another way.
set -u
cd "$(dirname "$0")/../.."
failed=0
sources() { grep -rnE "$1" coupler mbd_solver liggghts_fix tests inputs examples --include=*.h --include=*.cpp --include=*.toml --include=*.sh --include=in.* --exclude-dir=structure; }

while IFS=: read -r file line text; do
  for number in $(grep -oE '\b[Tt]heory [0-9]+(\.[0-9]+)?' <<<"$text" | grep -oE '[0-9.]+$'); do
    grep -qE "^##+ ${number//./\\.} " docs/explanation/theory.md || { echo "$file:$line: theory $number: docs/explanation/theory.md has no such section"; failed=1; }
  done
done < <(sources '\b[Tt]heory [0-9]')

if sources '(//|#).*([Tt]heory|docs)(:|, section|, bodies|, coupling)|(//|#).*docs: *(theory|errata)'; then
  echo "point to a section of docs/explanation/theory.md by its number, as in: theory 6.2"; failed=1
fi
exit $failed
