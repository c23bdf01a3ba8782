#!/usr/bin/env bash
# full_disk_grains.sh FOOTFALL OUT CASE: in a coupled run that is under way a file may not grow any more, or finds the disk full; the run ends soon with exit code 1 and
# the file's name, and no half set is taken for a checkpoint.
#   CASE   motion (of the surfaces, by the mechanism), restart (of LIGGGHTS, in a checkpoint), pictures, memory (the mechanism's part of a checkpoint)
set -u
source "$(dirname "$0")/run_to_end.sh"
case=$3
# No row, picture or checkpoint comes before the limit but those of the case.
case $case in
  motion) options=() program=mbd_solver limit=20000 name=motion/plate.csv ;;
  pictures) options=(--set output.vtk=true --set output.vtk_interval=0.2) program=mbd_solver limit=unlimited name=bodies_ ;;
  memory) options=(--set output.checkpoint_interval=0.5) program=mbd_solver limit=2000 name='run.txt\|plate.csv' ;;
  restart) options=(--set output.checkpoint_interval=0.5) program=liggghts_mbd limit=1000 name=grains.restart ;;
esac
start_run "$1" "$2" window --set end_time=1e4 --keep-every 0 "${options[@]}"
# Pictures alone: the file of the motion grows in each window, so that a limit for all files would meet it first.
[[ $case != pictures ]] || for n in {0000..0999}; do ln -s /dev/full "run/bodies_$n.vtu.part"; done
for id in $(processes_of $program); do prlimit --pid "$id" --fsize=$limit || die "prlimit is missing"; done
sleep 0.3
before=" $(ls run/checkpoint 2>/dev/null | tr '\n' ' ')" start=$SECONDS
wait_for_end 60 || die "$case: still there: $(processes_of "" | tr '\n' ' ')"
echo "$case: exit code $code after $((SECONDS - start)) s"
[[ $code == 1 ]] || die "$case: exit code $code, expected 1"
grep -q "\($name\)[^ ]*: cannot be written" said.txt || die "$case: the message does not name the file"
for set in run/checkpoint/*; do
  [[ $set == *.part || ! -e $set || $before == *" ${set##*/} "* ]] || die "$case: half a set passes for a checkpoint: $set"
done
exit 0
