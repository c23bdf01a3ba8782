#!/usr/bin/env bash
# two_hosts.sh FOOTFALL OUT: a coupled run across two hosts over TCP. The hosts are two network namespaces of this machine, with names of their own: neither reaches the other but by
# the cable between them. LIGGGHTS has a rank on each, the mechanism lives on the second. The history must equal the same run's on one host, byte by byte.
# Needs root and iproute2; exit code 77 without.
set -u
footfall=$(realpath "$1")
inputs=$(cd "$(dirname "$0")/../../inputs" && pwd)
rm -rf "$2" && mkdir -p "$2" && cd "$2" && out=$PWD || exit 1
die() { echo "two_hosts.sh: $*" >&2; exit 1; }
a=fa$$ b=fb$$
((EUID == 0)) && command -v ip >/dev/null && ip netns add $a 2>/dev/null || { echo "two_hosts.sh: no right to make a network namespace"; exit 77; }
trap 'ip netns pids $b | xargs -r kill -KILL; ip netns pids $a | xargs -r kill -KILL; ip netns del $a; ip netns del $b' EXIT
ip netns add $b
ip link add va$$ netns $a type veth peer name vb$$ netns $b
ip -n $a addr add 10.77.0.1/24 dev va$$
ip -n $b addr add 10.77.0.2/24 dev vb$$
for end in "$a lo" "$b lo" "$a va$$" "$b vb$$"; do ip -n ${end% *} link set ${end#* } up; done

scene=("$inputs/dropped_sphere" --ranks 2 --until 0.02 --set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42
  --set particles.bed.variables.width=0.42 --set particles.bed.variables.depth=0.2 --set particles.bed.variables.settle=0.3 --set output.plots=false)
FOOTFALL_CACHE=$out/cache "$footfall" run "${scene[@]}" --out run >said.txt 2>&1 || { cat said.txt; die "the run on one host"; }
line=$(grep -o 'mpirun --oversub.*bin/mbd_solver .*' said.txt | tail -n 1)
[[ -n $line ]] || die "the run does not say how it was started"
mv run one && mkdir run

# What mpirun calls instead of ssh: agent HOST COMMAND...
cat >agent <<END
#!/bin/sh
shift
exec ip netns exec $b unshare --uts sh -c "hostname second; \$*"
END
chmod +x agent
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
options="--mca plm_rsh_agent $out/agent --mca pml ob1 --mca btl tcp,self --host 10.77.0.1:1,10.77.0.2:2 --display-map"
timeout 100 ip netns exec $a unshare --uts sh -c "hostname first; ${line/mpirun --oversubscribe/mpirun $options}" >two.txt 2>&1 </dev/null ||
  { tail -n 30 two.txt; die "the run on two hosts"; }
cmp one/history.csv run/history.csv || die "another history than on one host"
grep 'Data for node\|Process OMPI' two.txt
echo "$(ip -n $b -s link show vb$$ | awk '/RX:/ { getline; print $1 }') bytes came to the second host; the history equals the run on one host to the byte"
