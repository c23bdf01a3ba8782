#!/usr/bin/env bash
# The table of README.md is complete: it lists exactly those functions that the program defines and that one of its
# libraries (LIGGGHTS, MPI, C) defines as well, and each has its own .cpp here.
#   check_list.sh BUILD/bin/liggghts_mbd
set -eu
program=$1
folder=$(cd "$(dirname "$0")" && pwd)

# Strong functions only: inline functions and templates (W) are the same code in both.
defined() { nm -D --defined-only "$2" | awk -v types="$1" 'index(types, $2) { sub(/@.*/, "", $3); print $3 }'; }
mapfile -t libraries < <(ldd "$program" | grep -oE '/[^ ]*lib(liggghts|mpi|mpi_cxx|c)\.so[^ ]*')
((${#libraries[@]} >= 3)) || { echo "$program: LIGGGHTS, MPI or the C library is not among its libraries"; exit 1; }

found=$(comm -12 <(defined T "$program" | sort -u) \
  <(for library in "${libraries[@]}"; do defined TWi "$library"; done | sort -u) | c++filt | sort)
listed=$(sed -n 's/^| `\([^`]*\)` |.*/\1/p' "$folder/README.md" | sort)
[[ -n $listed ]] || { echo "README.md lists no symbol: this check is blind"; exit 1; }

failed=0
while IFS= read -r symbol; do
  [[ -z $symbol ]] || { echo "$symbol is replaced but not listed in liggghts_fix/replaced/README.md"; failed=1; }
done < <(comm -23 <(echo "$found") <(echo "$listed"))
while IFS= read -r symbol; do
  [[ -z $symbol ]] || { echo "$symbol is listed in liggghts_fix/replaced/README.md but not replaced"; failed=1; }
done < <(comm -13 <(echo "$found") <(echo "$listed"))
files=$(find "$folder" -name '*.cpp' | wc -l)
(($(wc -l <<< "$listed") == files)) || { echo "$files files replace $(wc -l <<< "$listed") symbols; expected one file each"; failed=1; }
exit $failed
