# For the scripts of pages that are made in parts: the array `all` names them, and part_NAME prints the tables of one.

# make_parts FOLDER [PART...]: the tables of these parts (default: all; "page": of none) into FOLDER/made/PART.txt.
make_parts() {
  local folder=$1 part tables
  shift
  (($#)) || set -- "${all[@]}"
  tables=$(mktemp)
  for part in "$@"; do
    [[ $part != page ]] || continue
    [[ " ${all[*]} " == *" $part "* ]] || { echo "$folder.sh: there is no part \"$part\"; known: ${all[*]}" >&2; exit 2; }
    "part_$part" >"$tables"
    mkdir -p "$folder/made"
    cp "$tables" "$folder/made/$part.txt"
  done
  rm -f "$tables"
}

# count_cost FOLDER PART RUNS...: seconds of a core that the runs of a part took which stand in these folders, into FOLDER/made/PART.seconds; nothing when none is there.
count_cost() {
  local folder=$1 part=$2 runs
  shift 2
  for runs in "$@"; do
    [[ ! -d $runs ]] || { docs/cost_of_runs.sh "$@" >"$folder/made/$part.seconds"; return; }
  done
}

# count_whole FOLDER RUNS...: the same of all parts in one go, where a bed that several parts need is made once, into FOLDER/made/whole.seconds; nothing when some of the runs are not there.
count_whole() {
  local folder=$1 runs
  shift
  for runs in "$@"; do [[ -d $runs ]] || return 0; done
  docs/cost_of_runs.sh "$@" >"$folder/made/whole.seconds"
}

# cost_of_pages FOLDER...: a line with the hours of these pages in one go each.
cost_of_pages() {
  local folder
  for folder in "$@"; do [[ -s $folder/made/whole.seconds ]] || return 0; done
  for folder in "$@"; do echo "${folder#docs/} $(<"$folder/made/whole.seconds")"; done | awk '
    { sum += $2; each = each (each ? ", " : "") $1 " " sprintf("%.1f", $2 / 3600) }
    END { printf "All parts in one go, each bed made once (hours of a core): %s%s. That is %.1f hours of two cores.\n", each, (NR > 1 ? sprintf(", together %.1f", sum / 3600) : ""), sum / 7200 }'
}

# cost_of_parts FOLDER: a line with the hours of all parts, and the dearest of them.
cost_of_parts() {
  local made=$1/made part unknown=()
  for part in "${all[@]}"; do [[ -s $made/$part.seconds || ! -f $made/$part.txt ]] || unknown+=("$part"); done
  for part in "${all[@]}"; do [[ ! -s $made/$part.seconds ]] || echo "$part $(<"$made/$part.seconds")"; done | sort -k2 -rn | awk -v unknown="${unknown[*]}" '
    { sum += $2; if (NR <= 5) most = most (most ? ", " : "") $1 " " sprintf("%.1f", $2 / 3600) }
    END {
      printf "The parts of this page%s take %.1f hours of a core, beds included; most of it (hours): %s.", unknown ? " whose runs are at hand" : "", sum / 3600, most
      printf "%s\n", unknown ? " Not counted, as their runs were not kept: " unknown "." : ""
    }'
}
