#!/usr/bin/env bash
# slurm.sh FOOTFALL OUT: a Slurm of this machine (munged, slurmctld, slurmd; Debian's packages munge, slurmctld, slurmd, slurm-client) runs inputs/slurm/pair.sbatch, which is ended by a
# signal as at the end of its time, queued again, and continues to its end; and the job array of a sweep. Needs root; exit code 77 without.
set -u
footfall=$(realpath "$1") here=$(cd "$(dirname "$0")" && pwd)
inputs=$here/../../inputs
rm -rf "$2" && mkdir -p "$2" && cd "$2" && out=$PWD || exit 1
die() { echo "slurm.sh: $*" >&2; tail -n 5 "$out"/*.log >&2; exit 1; }
for tool in munged slurmctld slurmd sbatch; do command -v $tool >/dev/null || { echo "slurm.sh: $tool is missing"; exit 77; }; done
((EUID == 0)) || { echo "slurm.sh: needs root"; exit 77; }
export SLURM_CONF=$out/slurm.conf OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 FOOTFALL=$footfall FOOTFALL_CACHE=$out/cache
host=$(hostname -s)
cat >slurm.conf <<END
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$out/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
SlurmctldPort=26817
SlurmdPort=26818
SlurmctldPidFile=$out/slurmctld.pid
SlurmdPidFile=$out/slurmd.pid
StateSaveLocation=$out/state
SlurmdSpoolDir=$out/spool
SlurmctldLogFile=$out/slurmctld.log
SlurmdLogFile=$out/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
JobRequeue=1
MinJobAge=300
BatchStartTimeout=10
NodeName=$host NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=60 State=UP OverSubscribe=FORCE:4
SlurmdParameters=config_overrides
END
mkdir state spool
dd if=/dev/urandom of=munge.key bs=1 count=1024 2>/dev/null && chmod 400 munge.key
started=()
trap 'scancel --quiet --user root 2>/dev/null; sleep 1; kill "${started[@]}" 2>/dev/null' EXIT
munged --force --foreground --key-file="$out/munge.key" --socket="$out/munge.socket" --pid-file="$out/munge.pid" --log-file="$out/munge.log" --seed-file="$out/munge.seed" 2>/dev/null &
started+=($!)
for ((k = 0; k < 50; ++k)); do [[ -S munge.socket ]] && break; sleep 0.1; done
slurmctld -D -i >ctld.log 2>&1 & started+=($!)
slurmd -D >d.log 2>&1 & started+=($!)
for ((k = 0; k < 100; ++k)); do sinfo -h -o %T 2>/dev/null | grep -q idle && break; sleep 0.2; done
sinfo -h -o %T | grep -q idle || die "the node does not come up: $(sinfo 2>&1)"

state() { scontrol show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z]*\).*/\1/p'; }
wait_for() { # JOB STATE SECONDS
  for ((k = 0; k < $3 * 5; ++k)); do
    [[ $(state "$1") == "$2" ]] && return
    [[ $(state "$1") == FAILED ]] && break
    sleep 0.2
  done
  die "job $1 is $(state "$1"), not $2: $(tail -n 5 slurm-$1.out)"
}
small=(--set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42 --set particles.bed.variables.width=0.42
  --set particles.bed.variables.depth=0.2 --set particles.bed.variables.settle=0.3 --set output.plots=false --quiet)
# The batch script, ended as at the end of its time.
job=$(sbatch --parsable --ntasks=3 "$inputs/slurm/pair.sbatch" "$inputs/dropped_sphere" "$out/run" --until 0.3 "${small[@]}") || die "sbatch"
for ((k = 0; k < 600; ++k)); do [[ -f run/history.csv ]] && (($(wc -l <run/history.csv) > 20)) && break; sleep 0.1; done
rows=$(wc -l <run/history.csv)
scancel --signal=TERM --batch "$job"
for ((k = 0; k < 300; ++k)); do (($(scontrol show job "$job" | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p') > 0)) && break; sleep 0.2; done
scontrol show job "$job" | grep -q 'Restarts=1' || die "the job was not queued again: $(scontrol show job "$job")"
grep -q '"status": "interrupted"' run/summary.json || die "the run was not interrupted"
sleep 8  # Slurm wants the end of the first try on its books before it starts the next; it would wait two minutes by itself
scontrol update JobId="$job" StartTime=now 2>/dev/null
wait_for "$job" COMPLETED 120
grep -q '"status": "done"' run/summary.json || die "the run is not done"
echo "job $job: interrupted behind row $((rows - 1)), queued again, done with $(($(wc -l <run/history.csv) - 1)) rows on $(sed -n 's/.*NumTasks=\([0-9]*\).*/\1/p' <(scontrol show job "$job")) tasks"

# A sweep as a job array: beds, array, tables.
cat >radius.toml <<END
title = "Radius"
scene = "$inputs/rigid_plane/scene.toml"
until = 0.02
settings = ["flexible=false"]
[[parameters]]
name = "speed"
settings = ["initial.velocity=[0,0,-{value}]"]
values = [2, 3]
[[figures]]
name = "peak [g]"
key = "peak_acceleration_g"
END
"$footfall" sweep radius.toml --out sweep --slurm >sweep.txt || die "--slurm"
array=$(sbatch --parsable sweep/sweep.sbatch) || die "sbatch of the array"
for ((k = 0; k < 600; ++k)); do [[ -z $(squeue -h -j "$array" 2>/dev/null) ]] && break; sleep 0.2; done
"$footfall" sweep radius.toml --out sweep --merge >merge.txt || die "--merge: $(tail -n 3 merge.txt)"
echo "array $array: $(ls sweep/runs/*.done.json | wc -l) runs; $(grep -c '^| speed' sweep/cases.md) rows of the table"
