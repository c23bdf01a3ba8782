#!/usr/bin/env bash
# commands.sh FOOTFALL DOCS/COMMANDS.MD README.MD: every subcommand has its --help and its line in the page, the page has no other,
# and the README names the page.
set -u
footfall=$1 page=$2 readme=$3
failed=0
listed=$("$footfall" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]\+\) .*/\1/p' | sort)
described=$(sed -n 's/^| `footfall \([a-z]\+\)[ `].*/\1/p' "$page" | sort)
[ "$(wc -w <<<"$listed")" -gt 1 ] || { echo "footfall --help lists no subcommands"; failed=1; }
if ! difference=$(diff <(echo "$listed") <(echo "$described")); then
  echo "subcommands of footfall --help (<) and of $page (>) differ:"; echo "$difference"; failed=1
fi
for command in $listed; do
  "$footfall" "$command" --help >/dev/null || { echo "footfall $command --help fails"; failed=1; }
done
grep -q 'docs/commands.md' "$readme" || { echo "$readme does not name docs/commands.md"; failed=1; }
exit $failed
