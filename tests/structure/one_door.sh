#!/usr/bin/env bash
# One door per foreign library, and dependencies one way: mbd_solver -> coupler <- liggghts_fix; model and dynamics know nothing of scene, run, output.
set -u
cd "$(dirname "$0")/../.."
failed=0
# door PATTERN ALLOWED...: only these files may include what matches.
door() {
  local pattern=$1 file; shift
  while IFS= read -r file; do
    local allowed=0 name
    for name in "$@"; do [[ $file == $name ]] && allowed=1; done
    if ((!allowed)); then echo "$file includes $pattern; only $* may"; failed=1; fi
  done < <(grep -rlE "^#include [<\"]$pattern" coupler mbd_solver liggghts_fix --include=*.h --include=*.cpp)
}
door '(ida|sundials|nvector|sunmatrix|sunlinsol)/' 'mbd_solver/integrator/ida*'
door 'toml\+\+' 'mbd_solver/scene/scene_reader.cpp'
door 'fl/' 'mbd_solver/model/controllers/fuzzy_engine.h'
door 'assimp/' 'mbd_solver/scene/mesh_reader.cpp'
door 'pugixml' 'mbd_solver/output/vtk_writer.cpp'
door 'mpi\.h' 'coupler/communicator.h' 'coupler/transport_mpi.*' 'mbd_solver/main.cpp' 'liggghts_fix/*'
door '(lammps|fix|fix_mesh_surface|mesh_module|atom|modify|fix_wall_gran|neighbor|comm|domain|update|error)\.h' 'liggghts_fix/fix_*' 'liggghts_fix/mesh_module_*' 'liggghts_fix/liggghts_access.*' 'liggghts_fix/launcher.cpp'
if grep -rnE '^#include "(mbd_solver|liggghts_fix)/' coupler; then echo "coupler must not know the two programs"; failed=1; fi
if grep -rnE '^#include "mbd_solver/' liggghts_fix; then echo "liggghts_fix must not know mbd_solver"; failed=1; fi
if grep -rnE '^#include "mbd_solver/(scene|build|coupling|observe|run|output|cli)/' mbd_solver/fe mbd_solver/model mbd_solver/dynamics mbd_solver/integrator; then
  echo "fe, model, dynamics and integrator must not know scene, build, coupling, observe, run, output or cli"; failed=1; fi
exit $failed
