#!/usr/bin/env bash
# Every link of the pages leads somewhere: to a file, and to a heading of it. README.md has at most 150 lines; every page of docs/ is linked by another page.
set -u
cd "$(dirname "$0")/../.."
failed=0
# The headings of a file as anchors, found once.
declare -A known
anchors_of() { [[ -v known[$1] ]] || known[$1]=$'\n'$(anchors "$1")$'\n'; }
anchors() { grep -E '^#+ ' "$1" | sed -E 's/^#+ //; s/[`*]//g' | tr '[:upper:]' '[:lower:]' | sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'; }
linked=" README.md "
for page in *.md docs/*.md docs/*/*.md docs/*/*/*.md examples/*.md examples/*/README.md .github/*.md; do
  [[ -f $page ]] || continue
  while IFS= read -r target; do
    [[ $target == http* || $target == mailto* ]] && continue
    file=${target%%#*} anchor=""
    [[ $target == *#* ]] && anchor=${target#*#}
    path=$page
    folder=./
    [[ $page == */* ]] && folder=${page%/*}/
    [[ -n $file ]] && path=$folder$file && path=${path#./}
    while [[ $path =~ ^(.*/)?[^/.][^/]*/\.\./(.*)$ ]]; do path=${BASH_REMATCH[1]}${BASH_REMATCH[2]}; done
    linked+="$path "
    [[ -e $path ]] || { echo "$page: link to $target: there is no $path"; failed=1; continue; }
    [[ -z $anchor ]] || { anchors_of "$path"; [[ ${known[$path]} == *$'\n'"$anchor"$'\n'* ]]; } || { echo "$page: link to $target: $path has no such heading"; failed=1; }
  done < <(sed -E '/^```/,/^```/d; s/`[^`]*`//g' "$page" | grep -oE '\]\([^) ]+' | sed 's/^](//'; grep -oE '<img src="[^"]+' "$page" | sed 's/.*"//')
done
for page in docs/*.md docs/*/*.md docs/*/*/*.md; do
  [[ $linked == *" $page "* ]] || { echo "$page: no page links to it"; failed=1; }
done
(($(wc -l <README.md) <= 150)) || { echo "README.md has $(wc -l <README.md) lines, expected at most 150"; failed=1; }
exit $failed
