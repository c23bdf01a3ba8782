#!/usr/bin/env bash
# Text goes into gnuplot scripts, shell lines and HTML by the functions of coupler/base/quote.h alone, and nothing is handed to a shell.
set -u
cd "$(dirname "$0")/../.."
failed=0
complain() { echo "$*"; failed=1; }
sources() { grep -rlE "$1" mbd_solver coupler liggghts_fix --include=*.cpp --include=*.h; }

# gnuplot: in a source that writes scripts no literal ends within a quote that a value would go on.
mapfile -t scripts < <(sources 'set terminal|set output|with lines')
((${#scripts[@]} >= 6)) || complain "quoting.sh: finds ${#scripts[@]} sources that write gnuplot scripts: it is blind"
while IFS= read -r line; do
  complain "$line: a value in quotes; use gnuplot_text"
done < <(grep -nE "(^|[^\\\\])(\\\\\"|')\" *(<<|\+) *[A-Za-z(]" "${scripts[@]}" | grep -vE 'InputError|known_names|is not one of|no value|has more|positive\(')
# HTML: tags are written by the pages alone. What page_parts.cpp puts into scripts has its own escapes (PageParts.NoTextOfASceneEndsItsElement).
pages=(mbd_solver/cli/analysis/html_page.cpp mbd_solver/cli/analysis/viewer/view_page.cpp)
while IFS= read -r file; do
  [[ " ${pages[*]} mbd_solver/cli/analysis/viewer/page_parts.cpp " == *" $file "* ]] || complain "$file: writes HTML; html_page.h does that"
done < <(sources '"[^"]*<(p|td|th|h[12]|pre|a|img|table|div|script)[ >]')
grep -nE '(\+|=) *(text|heading|label|line|words|title_?|caption|note|folder)\b' "${pages[@]}" | grep -vE 'html_text|for \(|std::string (text|words) =' &&
  complain "a page holds text that is not escaped"
# Shell: a line is made of shell_word, and the one command that a shell reads is fixed.
while IFS=: read -r file number text; do
  [[ $file == mbd_solver/cli/launch/bed.cpp && $text == *'popen("dpkg-query'* || $file == liggghts_fix/no_programs.cpp ]] ||
    complain "$file:$number: hands something to a shell"
done < <(grep -rnE '\b(popen|system|execl|execlp)\(' mbd_solver coupler liggghts_fix --include=*.cpp | grep -vE ':[0-9]+: *//|System\(|FuzzySystem')
grep -nE 'SBATCH.*<< *(a\.|fs::|out|path)' mbd_solver/cli/experiments/*.cpp && complain "a name in sweep.sbatch past shell_word"
exit $failed
