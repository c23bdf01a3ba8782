#!/usr/bin/env bash
# The house as its includes draw it: one door per foreign library; which room may look into which; every header by its
# full path; every unit test says which source it mirrors.
set -u
cd "$(dirname "$0")/../.."
failed=0
complain() { echo "$*"; failed=1; }

# door PATTERN ALLOWED...: only these files may include what matches.
door() {
  local pattern=$1 file; shift
  while IFS= read -r file; do
    local allowed=0 name
    for name in "$@"; do [[ $file == $name ]] && allowed=1; done
    ((allowed)) || complain "$file includes $pattern; only $* may"
  done < <(grep -rlE "^#include [<\"]$pattern" coupler mbd_solver liggghts_fix --include=*.h --include=*.cpp)
}
door '(ida|sundials|nvector|sunmatrix|sunlinsol|sunnonlinsol)/' 'mbd_solver/integrator/ida*'
door 'toml\+\+' 'mbd_solver/scene/scene_reader.cpp'
door 'fl/' 'mbd_solver/model/controllers/fuzzy_engine.h'
door 'fcl/' 'mbd_solver/model/surface/*.cpp'
door 'nlopt' 'mbd_solver/cli/calibrate/search.cpp'
door 'muParser' 'mbd_solver/model/signals/expression.cpp'
door 'assimp/' 'mbd_solver/scene/mesh_reader.cpp'
door 'pugixml' 'mbd_solver/output/vtk_writer.cpp'
door 'zlib' 'mbd_solver/cli/analysis/viewer/packed_series.cpp'
door 'mpi\.h' 'coupler/communicator.*' 'coupler/doorbell.*' 'coupler/polite_wait.*' 'coupler/mpi_check.*' 'coupler/abort_guard.*' 'coupler/transport_mpi.*' 'mbd_solver/main.cpp' \
  'liggghts_fix/launcher.cpp' 'liggghts_fix/program_world.*' 'liggghts_fix/last_words.cpp' \
  'liggghts_fix/liggghts_access*.cpp' 'liggghts_fix/fix_*'
door '(coupler/(communicator|doorbell|polite_wait|mpi_check|abort_guard|transport_mpi)\.h)' 'coupler/communicator.*' 'coupler/doorbell.*' \
  'coupler/polite_wait.*' 'coupler/mpi_check.*' 'coupler/abort_guard.*' \
  'coupler/transport_mpi.*' 'mbd_solver/main.cpp' 'liggghts_fix/launcher.cpp' 'liggghts_fix/fix_*' \
  'liggghts_fix/no_programs.cpp'
door '(lammps|fix|fix_[a-z_]*|mesh_module|atom|modify|neighbor|comm|domain|update|error|input|tri_mesh|signal_handling)\.h' \
  'liggghts_fix/fix_*' 'liggghts_fix/mesh_module_*' 'liggghts_fix/liggghts_access*' 'liggghts_fix/launcher.cpp' \
  'liggghts_fix/no_programs.cpp'
while IFS=: read -r file include; do
  complain "$file: $include: coupler/base is plain C++; only locks and whole files talk to the operating system"
done < <(grep -rE '^#include <[A-Za-z_]*[/.]' coupler/base --include=*.h --include=*.cpp |
         grep -vE '^coupler/base/(file_lock|whole_file)\.cpp:#include <(fcntl|signal|sys/file|sys/stat|unistd)\.h>$')

# The rooms, from the ground up: a room may include its own headers, those of the rooms that its row names, and those
# that these may include.
declare -A may=(
  [coupler/base]=''
  [coupler]='coupler/base'
  [liggghts_fix]='coupler'
  [mbd_solver/model/laws]='coupler/base'
  [mbd_solver/model/controllers]='coupler/base'
  [mbd_solver/model]='mbd_solver/model/laws coupler'  # with its joints, elements and signals
  [mbd_solver/fe]='mbd_solver/model'
  [mbd_solver/dynamics]='mbd_solver/model'
  [mbd_solver/integrator]='mbd_solver/dynamics'
  [mbd_solver/scene]='mbd_solver/fe mbd_solver/model/controllers'
  [mbd_solver/build]='mbd_solver/scene mbd_solver/model/controllers'
  [mbd_solver/coupling]='mbd_solver/build mbd_solver/dynamics'
  [mbd_solver/output]='coupler/base'
  [mbd_solver/observe]='mbd_solver/coupling mbd_solver/output'
  [mbd_solver/run]='mbd_solver/observe mbd_solver/integrator'
  [mbd_solver]='mbd_solver/run mbd_solver/cli'  # main.cpp; of cli only the check of an option
  [mbd_solver/cli/grains]='coupler/base'
  [mbd_solver/cli/launch]='mbd_solver/observe'  # check computes the start of a run
  [mbd_solver/cli/analysis]='mbd_solver/cli/grains mbd_solver/cli/launch mbd_solver/output'
  [mbd_solver/cli/experiments]='mbd_solver/cli/analysis mbd_solver/coupling'
  [mbd_solver/cli/calibrate]='mbd_solver/cli/experiments'
  [mbd_solver/cli/rigs]='mbd_solver/cli/experiments'
  [mbd_solver/cli]='mbd_solver/cli/calibrate mbd_solver/cli/rigs'
)
# room FILE: the nearest folder around it that the table knows.
room() {
  room=${1%/*}
  until [[ -v may[$room] || $room != */* ]]; do room=${room%/*}; done
}
# reach ROOM: all that it may include, in `reached`.
reach() {
  local next
  [[ $reached == *" $1 "* ]] && return
  reached+="$1 "
  for next in ${may[$1]}; do reach "$next"; done
}
declare -A reached_from=()
for room in "${!may[@]}"; do
  reached=' '
  reach "$room"
  reached_from[$room]=$reached
done
while IFS=: read -r file include; do
  header=${include#*\"}
  header=${header%%\"*}
  room "$file"; from=$room
  room "$header"; to=$room
  [[ -v may[$from] ]] || { complain "$file stands in no room of the table in tests/structure/one_door.sh"; continue; }
  [[ ${reached_from[$from]} == *" $to "* ]] || complain "$file includes $header: $from may not look into $to"
done < <(grep -rE '^#include "(coupler|mbd_solver|liggghts_fix)/' coupler mbd_solver liggghts_fix --include=*.h --include=*.cpp)

# Full paths, from the root of the checkout. liggghts_fix sees LIGGGHTS' headers as LIGGGHTS names them.
while IFS=: read -r file include; do
  complain "$file: $include: expected the header's full path"
done < <(grep -rE '^#include "' coupler mbd_solver tests --include=*.h --include=*.cpp |
         grep -vE '^[^:]*:#include "(coupler|mbd_solver|liggghts_fix|tests)/')
while IFS=: read -r file include; do
  header=${include#*\"}
  [[ -f liggghts_fix/${header%%\"*} ]] && complain "$file: $include: expected the header's full path"
done < <(grep -rE '^#include "[^/"]*"' liggghts_fix --include=*.h --include=*.cpp)

# tests/unit/ROOM/NAME_test.cpp tests NAME.h, or its first comment names the sources with their paths.
for file in tests/unit/*/*_test.cpp; do
  name=${file##*/}
  grep -qE "^#include \"(coupler|mbd_solver|liggghts_fix)/([a-z_]*/)*${name%_test.cpp}\.h\"" "$file" && continue
  source=$(sed -n '1,/^[^/]/{/^\/\//p}' "$file" | grep -oE '(coupler|mbd_solver|liggghts_fix)/[a-z_/]*\.(h|cpp)' | head -n 1)
  [[ -n $source && -f $source ]] || complain "$file: neither includes ${name%_test.cpp}.h nor names the path of its source in its first comment"
done
exit $failed
