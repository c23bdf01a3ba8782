#!/usr/bin/env bash
# Every link of README.md and docs/ leads somewhere: to a file, and to a heading of it. README.md has at most 150 lines and links every page of docs/.
set -u
cd "$(dirname "$0")/../.."
failed=0
anchors() { grep -E '^#+ ' "$1" | sed -E 's/^#+ //; s/[`*]//g' | tr '[:upper:]' '[:lower:]' | sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'; }
linked=" README.md "
for page in README.md docs/*.md docs/*/*.md examples/*/README.md; do
  [[ -f $page ]] || continue
  while IFS= read -r target; do
    [[ $target == http* || $target == mailto* ]] && continue
    file=${target%%#*} anchor=""
    [[ $target == *#* ]] && anchor=${target#*#}
    path=$page
    [[ -n $file ]] && path=$(realpath -m --relative-to=. "$(dirname "$page")/$file")
    linked+="$path "
    [[ -e $path ]] || { echo "$page: link to $target: there is no $path"; failed=1; continue; }
    [[ -z $anchor ]] || anchors "$path" | grep -qxF "$anchor" || { echo "$page: link to $target: $path has no such heading"; failed=1; }
  done < <(sed -E '/^```/,/^```/d; s/`[^`]*`//g' "$page" | grep -oE '\]\([^) ]+' | sed 's/^](//'; grep -oE '<img src="[^"]+' "$page" | sed 's/.*"//')
done
for page in docs/*.md docs/tutorials/*.md; do
  grep -qF "]($page" README.md || { echo "README.md does not link $page"; failed=1; }
done
for page in docs/fixes/*.md; do
  [[ $linked == *" $page "* ]] || { echo "$page: no page links to it"; failed=1; }
done
(($(wc -l <README.md) <= 150)) || { echo "README.md has $(wc -l <README.md) lines, expected at most 150"; failed=1; }
exit $failed
