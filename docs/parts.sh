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
