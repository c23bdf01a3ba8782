#!/usr/bin/env bash
# install.sh BUILD SOURCE: installs the build next to it, then lives from that alone, as an ordinary user who cannot write to it: beds go into
# the user's cache, results into the working folder. The C++ example and a program of the solver are built against it.
set -euo pipefail
export LC_ALL=C.UTF-8  # decimal points of awk
build=$1 source=$2
export CMAKE_GENERATOR=Ninja  # make may be missing
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
die() { echo "install.sh: $*"; exit 1; }
prefix=$work/opt/footfall
cmake --install "$build" --prefix "$prefix" > "$work/installed"
chmod -R a-w "$prefix"
mkdir "$work/home" "$work/here"
chmod 755 "$work"
user=()
if ((EUID == 0)); then
  chown 65534:65534 "$work/home" "$work/here"
  user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
fi
# as_user COMMAND...: with nothing of our environment.
sanitizers=()  # tests/bench/sanitize/run.sh says by these how to link, and what is no finding
for name in CXX LDFLAGS LD_PRELOAD ASAN_OPTIONS LSAN_OPTIONS UBSAN_OPTIONS; do [[ -z ${!name-} ]] || sanitizers+=("$name=${!name}"); done
as_user() { (cd "$work/here" && "${user[@]}" env -i HOME="$work/home" PATH="$prefix/bin:/usr/bin:/bin" LANG=C.UTF-8 TMPDIR="$work/here" "${sanitizers[@]}" "$@"); }
touch "$work/before"

files=(bin/footfall bin/footfall_studies bin/mbd_solver bin/liggghts_mbd share/footfall/inputs/landing_mr/scene.toml share/bash-completion/completions/footfall
  share/doc/footfall/README.md)
! command -v help2man > /dev/null || files+=(share/man/man1/footfall.1.gz share/man/man1/footfall-run.1.gz)
for file in "${files[@]}"; do
  [[ -s $prefix/$file ]] || die "$file is not installed"
done
as_user footfall --version > /dev/null
as_user footfall check > "$work/said" 2>&1 || { cat "$work/said"; die "the landing does not check"; }
grep -q "$prefix/share/footfall/inputs/landing_mr" <(as_user footfall run --help) || die "the landing is not taken from the installation"
as_user footfall new my_wheel --from wheel > /dev/null
as_user footfall run my_wheel --until 0.02 > "$work/said" 2>&1 || { cat "$work/said"; die "a case does not run"; }
grep -q "opt/footfall/share/footfall/inputs/box/in.grains" "$work/here/runs/my_wheel/liggghts.log" "$work/said" || die "the bed's scripts are not taken from the installation"
[[ -s $work/here/runs/my_wheel/plots/overview.png ]] || die "the run drew no plots"
[[ -n $(find "$work/home/.cache/footfall" -name bed.restart) ]] || die "the bed is not in the user's cache"
as_user footfall plot runs/my_wheel wheel.v > /dev/null
as_user footfall view runs/my_wheel > /dev/null
as_user footfall report runs/my_wheel > /dev/null
# A bed's script that is broken there shows that footfall reads this script.
cp -r "$prefix/share/footfall/inputs/box" "$work/box"
diff -r "$source/inputs/box" "$work/box" || die "the scripts of inputs/box are not installed as they are"
chmod -R u+w "$prefix/share/footfall/inputs/box" && echo 'no LIGGGHTS script' > "$prefix/share/footfall/inputs/box/in.bed"
as_user footfall run my_wheel --quiet --until 0.01 --out other --set particles.box.seed=7 > "$work/said" 2>&1 && die "a bed was made with another script than the installed one"
cp "$work/box/in.bed" "$prefix/share/footfall/inputs/box/in.bed" && chmod -R a-w "$prefix" && touch "$work/before"
# The landing itself, from the read-only folder, on a bed that is poured in seconds.
as_user footfall run --until 0.01 --quiet --ranks 1 --out landing --set particles.box.size=[3.2,3.2] \
  --set particles.box.depth=0.2 --set particles.box.radius=0.05 --set particles.box.zones.0.size=[0.4,0.4] --set particles.box.zones.0.depth=0.06 \
  --set particles.box.pour.settle_time=0.05 > "$work/said" 2>&1 || { cat "$work/said"; die "the landing does not run"; }
grep -q '"status": "done"' "$work/here/landing/summary.json" || die "the landing is not done"
code=0; as_user footfall test > "$work/said" 2>&1 || code=$?
[[ $code == 2 ]] && grep -q 'holds no tests' "$work/said" || die "footfall test of an installation: $code"
[[ -z $(find "$prefix" -newer "$work/before") ]] || die "something was written into the installation"

# built NAME SOURCE: against the installation alone.
built() {
  cp -r "$2" "$work/$1" && chmod -R u+w "$work/$1"
  cmake -S "$work/$1" -B "$work/$1/build" -DCMAKE_PREFIX_PATH="$prefix" > "$work/said" 2>&1 && cmake --build "$work/$1/build" >> "$work/said" 2>&1 ||
    { tail -n 40 "$work/said"; die "$1 does not build"; }
}
built own_mechanism "$prefix/share/footfall/examples/own_mechanism_cpp"
(($(wc -l < "$work/own_mechanism/tamper.cpp") < 100)) || die "tamper.cpp has a hundred lines"
cd "$work/own_mechanism"
((EUID == 0)) && export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mpirun --oversubscribe --bind-to none -np 1 "$prefix/bin/liggghts_mbd" -in in.tamper -screen none : -np 1 build/tamper > tamper.csv 2> said || { cat said; die "the example does not run"; }
# The momentum of the plate is the impulse of all forces on it: to the digits that are printed.
awk '/^momentum/ { d = $2 - $6; if (d < 0) d = -d; exit !(d < 2e-9) }' <(grep '^momentum' said | sed 's/,//g' | awk '{print $1, $2, $3, $4, $5, $6}') || { cat said; die "momentum and impulse differ"; }
awk -F, 'NR > 1 && $4 > f { f = $4 } END { exit !(f > 40) }' tamper.csv || die "the plate touched no grains"

built own_solver "$source/tests/app/own_solver"
"$work/own_solver/build/own_solver" "$prefix/share/footfall/inputs/rigid_plane/scene.toml" 0.01 | grep '^t = 0.01 s' > /dev/null || die "the solver does not run in another program"
