#!/usr/bin/env bash
# rigs.sh FOOTFALL OUT NAME [OPTION...]: the short form of a rig, or NAME = messages: what it says to what cannot be.
set -u
here=$(cd "$(dirname "$0")" && pwd)
footfall=$1 out=$2 name=$3; shift 3
die() { echo "rigs.sh: $*"; exit 1; }
rm -rf "$out" && mkdir -p "$out" && cd "$out" || die "cannot make $out"

says() {  # CODE PATTERN WORDS...
  local code=$1 pattern=$2 text got; shift 2
  text=$("$footfall" "$@" 2>&1); got=$?
  [[ $got -eq $code ]] || die "$*: exit $got instead of $code: $text"
  grep -q -- "$pattern" <<<"$text" || die "$*: says: $text"
}
if [[ $name == messages ]]; then
  says 2 'there is no such rig. Known rigs: plate, cone, .*Did you mean "plate"?' rig plat
  says 2 'expected earth, moon, mars, or a number' rig plate --gravity venus
  says 2 'the rig varies this key itself, as its "width"; copy ' rig plate --set 'bodies.plate.shape.size=[1,1,1]'
  says 2 'the rig varies this key itself, as its "seed"; --samples says' rig plate --set particles.box.seed=4
  inputs=$(cd "$here/../../inputs/rigs" && pwd)
  sed -e "s#\"scenes/#\"$inputs/scenes/#" -e 's/^values = \[1, 2, 3\]/values = [11, 12, 13]/' "$inputs/plate.toml" >own.toml
  says 2 'names 3 values of its "seed"; copy it, add values' rig plate --file own.toml --samples 4 --list
  says 2 'unknown key' rig plate --set particles.box.colour=3 --list
  says 2 'there is no soil "mud"' rig plate --set particles.soil=mud --list
  # What an evaluation could not use is said before anything runs.
  says 2 'this rig needs a body named "cone"' rig cone --file "$inputs/plate.toml" --list
  says 2 'body "cone": the rig expects the mesh cone.stl' rig cone --set "bodies.cone.shape.file=ring.stl" --list
  says 2 'joint "hub": motion.rotation: the rig expects polynomial = \[0, RATE\]' rig wheel --set 'joints.hub.motion.rotation={table=[[0,0],[1,2],[9,20]]}' --list
  sed -e "s#\"scenes/#\"$inputs/scenes/#" -e 's/polynomial=\[0,5\]/polynomial=[0,0]/' "$inputs/wheel.toml" >still.toml
  says 2 'the wheel does not turn, and has no slip' rig wheel --file still.toml --list
  says 2 'this rig needs particles.box.frames' rig repose --set particles.box.frames=0 --list
  exit 0
fi
"$footfall" rig "$name" --short --out out "$@" >log.txt 2>&1 || { cat log.txt; die "the short form failed"; }
for file in $name.md $name.csv ${name}_samples.csv ${name}_curves.csv; do [[ -s out/$file ]] || die "$file is missing"; done
grep -q '^| answer | unit | mean' out/$name.md || die "$name.md has no table"
cat out/$name.md
# A steep slope has points enough for a line.
[[ $name != repose ]] || ! grep -q 'not found' out/$name.md || die "no angle was found"
# The same command again does no run again.
"$footfall" rig "$name" --short --out out "$@" >again.txt 2>&1 || die "a second time it fails"
grep -q '^0 runs to do' again.txt || die "it runs again: $(grep 'runs to do' again.txt)"
