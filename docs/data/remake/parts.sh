# shellcheck shell=bash disable=SC2154
# For the scripts whose data are made in parts: the array `all` names the parts, and part_NAME prints the tables of one.

# make_parts FOLDER [PART...]: the tables of these parts (default: all) into FOLDER/PART.txt.
make_parts() {
  local folder=$1 part tables
  shift
  (($#)) || set -- "${all[@]}"
  tables=$(mktemp)
  for part in "$@"; do
    [[ " ${all[*]} " == *" $part "* ]] || { echo "$0: there is no part \"$part\"; known: ${all[*]}" >&2; exit 2; }
    "part_$part" >"$tables"
    mkdir -p "$folder"
    cp "$tables" "$folder/$part.txt"
  done
  rm -f "$tables"
}

# count_cost FOLDER PART RUNS...: processor seconds of the runs in these folders, beds included, as the line of PART in FOLDER/cost.csv. Nothing if
# one of the folders is missing.
count_cost() {
  local folder=$1 part=$2 runs seconds
  shift 2
  for runs in "$@"; do [[ -d $runs ]] || return 0; done
  seconds=$(docs/data/remake/cost_of_runs.sh "$@")
  { echo part,seconds; grep -vE "^(part|$part)," "$folder/cost.csv" 2>/dev/null || true; echo "$part,$seconds"; } >"$folder/cost.new"
  mv "$folder/cost.new" "$folder/cost.csv"
}

# keep_picture FROM TO [WIDTH]: a copy with few colours, at most WIDTH pixels wide if ImageMagick is installed. Nothing if FROM is missing.
keep_picture() {
  local from=$1 to=$2 width=${3:-680}
  [[ -f $from ]] || return 0
  mkdir -p "$(dirname "$to")"
  cp "$from" "$to"
  if convert -version 2>/dev/null | grep -q ImageMagick; then convert "$from" -resize "${width}x>" -colors 64 "PNG8:$to"; fi
  if command -v pngquant >/dev/null; then pngquant --force --output "$to" 64 "$to"; fi
}
