#!/usr/bin/env bash
# The table of liggghts_fix/replaced/README.md is complete: it lists exactly those functions that the program defines and that
# one of its libraries (LIGGGHTS, MPI, C) defines as well; each has its own .cpp there, and each test that it names exists.
#   replaced_symbols.sh BUILD/bin/liggghts_mbd
set -eu
cd "$(dirname "$0")/../.."
program=$1
folder=liggghts_fix/replaced

# Strong functions only: inline functions and templates (W) are the same code in both.
defined() { nm -D --defined-only "$2" | awk -v types="$1" 'index(types, $2) { sub(/@.*/, "", $3); print $3 }'; }
mapfile -t libraries < <(ldd "$program" | grep -oE '/[^ ]*lib(liggghts|mpi|mpi_cxx|c)\.so[^ ]*')
((${#libraries[@]} >= 3)) || { echo "$program: LIGGGHTS, MPI or the C library is not among its libraries"; exit 1; }

found=$(comm -12 <(defined T "$program" | sort -u) \
  <(for library in "${libraries[@]}"; do defined TWi "$library"; done | sort -u) | c++filt |
  sed 's/^non-virtual thunk to //; s/<.*> >::/<...>::/' | sort -u)  # instances of a template and their thunks are one function
listed=$(grep '^| `' "$folder/README.md" | sed 's/` |.*/`/' | grep -oE '`[^`]+`' | tr -d '`' | sort)  # the first cell has one or several symbols
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

# The tests of the last column: Suite.Name, a file of bad input, or a case of tests/app/by_force.sh.
tests=$(sed -n 's/^| `[^|]*` |.*| \([^|]*\) |$/\1/p' "$folder/README.md" | sed 's/ ([^)]*)//; s/, /\n/g' | sort -u)
[[ -n $tests ]] || { echo "README.md names no test: this check is blind"; exit 1; }
while IFS= read -r test; do
  case $test in
    as\ *) ;;
    BadInput\ *) grep -rqE "\b${test#BadInput }\b" tests/app/bad_input* || { echo "README.md names $test: there is no such input"; failed=1; } ;;
    by_force.sh\ *) grep -qE "^ +${test##* }\)" tests/app/by_force.sh || { echo "README.md names $test: there is no such case"; failed=1; } ;;
    *.*) grep -rqE "TEST(_[FP])?\(${test%.*}, ${test#*.}\)" tests --include=*_test.cpp || { echo "README.md names $test: there is no such test"; failed=1; } ;;
    *) echo "README.md names $test: expected Suite.Name, BadInput NAME or by_force.sh CASE"; failed=1 ;;
  esac
done <<< "$tests"
exit $failed
