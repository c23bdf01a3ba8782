#!/usr/bin/env bash
# Every style that liggghts_mbd registers is named in the first line of a page of docs/reference/fixes, in LIGGGHTS' own form ("# fix STYLE command",
# "# fix STYLE, STYLE commands"), and every keyword that its reader knows has a line there. A page of no style, and a line of no keyword, fail as well.
set -u
cd "$(dirname "$0")/../.."
failed=0
complain() { echo "$*"; failed=1; }

styles=$(grep -ohE 'register_fix_style\(lmp, "[^"]+"' liggghts_fix/*.cpp | sed 's/.*"\(.*\)"/\1/')
# The loop of make_meshes_resumable registers all styles that begin so.
prefix=$(sed -n 's/.*style\.rfind("\([^"]*\)", 0) != 0) continue;.*/\1/p' liggghts_fix/access/liggghts_access.cpp)
[[ -n $prefix ]] || complain "liggghts_access.cpp: the prefix of the meshes was not found"
styles+=$'\n'$prefix
(($(wc -l <<<"$styles") >= 5)) || complain "only these registered styles were found: $styles"

# The words that a reader compares or lists; those that it refuses have no line.
keywords_of() {
  case $1 in
    couple/mbd) grep -oE 'keyword == "[a-z_]+"|words\[3\] != "[a-z_]+"' coupler/couple_mbd_arguments.cpp ;;
    couple/mbd/geometry) grep -oE 'strcmp\(arg\[3\], "[a-z_]+"' liggghts_fix/couple/fix_couple_mbd_geometry.cpp ;;
    wall/gran/beam)
      grep -oE '(word (!=|==)) "[a-z_]+"' liggghts_fix/link/beam_arguments.cpp
      grep 'kModelKeywords =' liggghts_fix/link/beam_arguments.cpp | grep -oE '"[a-z_]+"' ;;
    insert/exact) grep -oE 'strcmp\(arg\[iarg\], "[a-z_]+"' liggghts_fix/couple/fix_insert_exact.cpp ;;
    remove/region) grep -oE 'strcmp\(arg\[i\], "[a-z_]+"' liggghts_fix/couple/fix_remove_region.cpp ;;
    bed/follow) grep -oE 'strcmp\(arg\[i\], "[a-z_]+"' liggghts_fix/couple/fix_bed_follow.cpp ;;
    mesh/surface) grep -oE 'strcmp\(words\[3\], "[a-z_]+"' liggghts_fix/access/liggghts_access.cpp ;;
  esac | sed -E 's/.*"([a-z_]+)"/\1/' | sort -u
}

styles_of() { sed -nE '1s/^# fix (.*) commands?$/\1/p' "$1" | sed 's/, /\n/g'; }

headings="Syntax Examples Description Restart Restrictions"
paged=""
for page in docs/reference/fixes/*.md; do
  [[ $page == */README.md ]] && continue
  found=$(sed -nE 's/^## ([A-Za-z]+).*/\1/p' "$page" | tr '\n' ' ')
  [[ ${found% } == "$headings" ]] || complain "$page: headings are \"${found% }\", expected \"$headings\""
  grep -qF "($(basename "$page"))" docs/reference/fixes/README.md || complain "docs/reference/fixes/README.md has no link to $page"
  [[ $page == docs/reference/fixes/audit.md ]] && continue  # no fix: counts next to them
  here=$(styles_of "$page")
  [[ -n $here ]] || complain "$page: the first line must be: # fix STYLE command"
  for style in $here; do grep -qxF "$style" <<<"$styles" || complain "$page: the style $style is not registered"; done
  paged+=$here$'\n'
  told=$(sed -n '/^## Syntax/,/^## Examples/p' "$page" | grep -E '^\| `' | cut -d'|' -f2 | grep -oE '`[a-z_]+`' | tr -d '`' | sort -u)
  difference=$(diff <(for style in $here; do keywords_of "$style"; done | sort -u) <(echo -n "${told:+$told$'\n'}")) ||
    complain "$page: keywords of the reader (<) and of the table under Syntax (>) differ:"$'\n'"$difference"
done
for style in $styles; do grep -qxF "$style" <<<"$paged" || complain "fix $style has no page in docs/reference/fixes"; done
exit $failed
