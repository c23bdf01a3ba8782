#!/usr/bin/env bash
# command_lines.sh FOOTFALL: a command line that cannot be read ends with code 2 and one line: where, what is, what was
# expected, what to do.
set -u
footfall=$1
failed=0
# says REGEX WORD...: what `footfall WORD...` says.
says() {
  local expected=$1 said code; shift
  said=$("$footfall" "$@" 2>&1); code=$?
  [[ $code == 2 ]] || { echo "footfall $*: exit code $code, expected 2"; failed=1; }
  grep -qE -- "$expected" <<<"$said" || { echo "footfall $*: says \"$said\", expected $expected"; failed=1; }
  [[ $(wc -l <<<"$said") == 1 ]] || { echo "footfall $*: says more than one line: $said"; failed=1; }
}
for command in compare watch view pictures plot report; do
  says "^footfall $command: DIR is missing, expected: folder of a run.*\. \`footfall $command --help\` tells what there is\.$" $command
done
says '^footfall rig: NAME is missing, expected: plate: ' rig
says '^footfall calibrate: FILE is missing, expected: calibration, as in inputs/calibrations\. ' calibrate
says '^missing\.toml: no such file; expected a calibration \(TOML\), as in inputs/calibrations$' calibrate missing.toml
for command in sweep accuracy; do
  says "^footfall $command: FILE is missing, expected: experiment, as in inputs/sweeps and inputs/accuracy\. " $command
  says '^missing\.toml: no such file; expected an experiment \(TOML\), as in inputs/sweeps and inputs/accuracy$' $command missing.toml
  says '^/: is a folder; expected an experiment \(TOML\)' $command /
done
says '^footfall: the command is missing, expected one of: run, new, check, .*\. `footfall --help` tells what each does\.$'
says '^footfall run: --ranks is given without its value, expected: --ranks NUMBER: LIGGGHTS processes\. ' run --ranks
says '^footfall run: --ranks: is "many", expected a number above zero\. ' run --ranks many
says '^footfall run: --keep-every: is "-1", expected zero or a number above\. ' run --keep-every -1
says '^footfall view: --frames: is "1", expected a number from 2 to 100000\. ' view DIR --frames 1
says '^footfall view: --frames: is "2\.5", expected a whole number: ' view DIR --frames 2.5
says '^footfall pictures: --times: is "soon", expected a number: ' pictures DIR --times soon
says '^footfall run: SCENE cannot stand beside --resume; leave one of them out\. ' run scene.toml --resume DIR
says '^footfall check: --ranks means nothing without --time; add it\. ' check scene.toml --ranks 2
says '^footfall check: not expected here: more\. `footfall check --help` tells what there is\.$' check scene.toml more
says '^footfall compare: not expected here: --qiet\. Did you mean "--quiet"\? ' compare DIR --qiet
exit $failed
