# Completion of footfall for bash: commands and options as --help lists them, otherwise files.
_footfall() {
  local word=${COMP_WORDS[COMP_CWORD]} pattern='--[a-z][a-z-]*' command=()
  ((COMP_CWORD > 1)) && command=("${COMP_WORDS[1]}") || pattern='^  [a-z]+'
  [[ $COMP_CWORD -gt 1 && $word != -* ]] || mapfile -t COMPREPLY < <(
    compgen -W "$("${COMP_WORDS[0]}" "${command[@]}" --help 2>/dev/null | grep -oE -- "$pattern" | sort -u)" -- "$word")
}
complete -o default -F _footfall footfall
