#!/usr/bin/env bash
# help.sh FOOTFALL OUT: every command and every option of --help stands in the man pages and in the completion of both shells; the pages are
# pages to man, the completions to their shells, and bash completes by them.
set -euo pipefail
footfall=$1 out=$2
rm -rf "$out" && mkdir -p "$out"
die() { echo "help.sh: $*"; exit 1; }
"$footfall" help --write "$out"
commands=$("$footfall" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z]\+\) .*/\1/p')
(($(wc -w <<< "$commands") >= 12)) || die "--help lists too few commands"
# options COMMAND: as --help lists them.
options() { "$footfall" "$1" --help | sed -n '/^Options:/,$ s/^  \(-[^ ]*\).*/\1/p' | tr ',' '\n'; }
plain() { sed 's/\\-/-/g; s/\\f[BIR]//g' "$1"; }
count=0
for command in $commands; do
  plain "$out/footfall.1" | grep -E "^footfall $command( |\$)" > /dev/null || die "footfall.1 lacks $command"
  page=$out/footfall-$command.1
  grep -q "    $command) words=" "$out/footfall.bash" || die "footfall.bash lacks $command"
  grep -q "    '$command:" "$out/_footfall" || die "_footfall lacks $command"
  for option in $(options "$command"); do
    count=$((count + 1))
    plain "$page" | grep -E -- "(^|, )$option( |,|\$)" > /dev/null || die "$page lacks $option"
    grep -E "^    $command\) words=" "$out/footfall.bash" | grep -E -- "[' ]$option[' ]" > /dev/null || die "footfall.bash lacks $command $option"
    sed -n "/^    $command) _arguments/,/;;/p" "$out/_footfall" | grep -F -- "$option[" > /dev/null || die "_footfall lacks $command $option"
  done
done
((count > 60)) || die "only $count options were looked for"
! "$footfall" --help | grep "^  help" > /dev/null || die "the hidden command is listed"
"$footfall" help --man run | diff - "$out/footfall-run.1"
"$footfall" help run | grep -- --resume > /dev/null || die "footfall help run says nothing of --resume"

if command -v man > /dev/null; then
  for page in "$out"/*.1; do
    complaints=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 "$page" 2>&1 > /dev/null | grep -v 'cannot set locale' || true)
    [[ -z $complaints ]] || die "$page: $complaints"
  done
fi
bash -n "$out/footfall.bash"
command -v zsh > /dev/null && zsh -n "$out/_footfall"
# complete WORD...: what bash offers for the last word.
complete_words() {
  bash -c 'compopt() { :; }; . "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _footfall; printf "%s\n" "${COMPREPLY[@]}"' _ "$out/footfall.bash" "$@"
}
[[ $(complete_words "$footfall" surf) == surfaces ]] || die "bash does not complete surf"
[[ $(complete_words "$footfall" run --res) == --resume ]] || die "bash does not complete run --res"
complete_words "$footfall" new x --from "" | grep -x wheel > /dev/null || die "bash does not offer the case wheel"

# What is misspelt is guessed, command or option.
told() { "$footfall" "$@" 2>&1 || [[ $? == 2 ]]; }
told rnu | grep 'Did you mean "run"?' > /dev/null || die "a misspelt command is not guessed"
told run --untl=1 | grep 'Did you mean "--until"?' > /dev/null || die "a misspelt option is not guessed"
