#!/usr/bin/env bash
# commands.sh FOOTFALL DOCS/COMMANDS.MD README.MD: every subcommand has its --help and its line in the page, the page has no other,
# and the README names the page. The front door of the checkout knows for which of them footfall_studies need not be built.
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
alone=$(mktemp -d)
cp "$footfall" "$alone/footfall"
for command in $listed; do
  ! "$alone/footfall" "$command" --help >/dev/null 2>&1 || echo "$command"
done >"$alone/own"
grep -oE '^  run( \| [a-z]+)+\)' "$(dirname "$readme")/footfall" | tr -d ' )' | tr '|' '\n' | sort >"$alone/told"
if ! difference=$(diff <(echo "test" | sort - "$alone/told") "$alone/own"); then
  echo "commands that ./footfall builds footfall alone for (<), and those that footfall has itself (>), differ:"; echo "$difference"; failed=1
fi
rm -rf "$alone"
grep -q 'docs/reference/commands.md' "$readme" || { echo "$readme does not name docs/reference/commands.md"; failed=1; }
exit $failed
