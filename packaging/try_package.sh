#!/usr/bin/env bash
# packaging/try_package.sh RELEASE DEB... [WHEEL] [--whole] [--tests BUILD] [--keep]: installs the packages, made on this RELEASE (bookworm, trixie), in a clean
# root of it (clean_root.sh, as root), runs the landing there on a small bed, as root and as an ordinary user, builds the C++ example if
# footfall-dev is given, removes everything and looks for leftovers. A wheel is tried before, without any package, and with them.
#   --whole        also the whole landing
#   --tests BUILD  runs the tests of BUILD as an ordinary user, with the installed programs; TESTS: more words for ctest
#   --keep         keeps the clean system in $TRY_ROOT for the next trial
set -euo pipefail
release=${1:?RELEASE} whole=0 keep=0 build='' wheel='' packages=()
shift
while (($#)); do
  case $1 in
    --whole) whole=1 ;;
    --keep) keep=1 ;;
    --tests)
      shift
      build=$(realpath "${1:?--tests needs a build folder}")
      [[ -f $build/CTestTestfile.cmake ]] || { echo "try_package.sh: $build holds no tests" >&2; exit 2; }
      ;;
    *.whl) wheel=$(realpath "$1") ;;
    *) packages+=("$(realpath "$1")") ;;
  esac
  shift
done
((${#packages[@]})) || { echo "try_package.sh: expected packages, as cpack -G DEB makes them" >&2; exit 2; }
((EUID == 0)) || { echo "try_package.sh: needs root, for chroot" >&2; exit 2; }
base=${TRY_ROOT:-$(mktemp -d)}/$release
mkdir -p "${base%/*}"
root=$base.trial
source=
[[ -z $build ]] || source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
die() { echo "try_package.sh: $*" >&2; exit 1; }
clean() {
  for place in dev/shm proc sys "${source#/}"; do [[ -z $place ]] || ! mountpoint -q "$root/$place" || umount "$root/$place"; done
  rm -rf --one-file-system "$root"
}
trap 'clean; ((keep)) || rm -rf "$base"' EXIT

if [[ ! -f $base/.ready ]]; then
  echo "A clean $release in $base"
  ROOT_USER=root "$(dirname "$0")/clean_root.sh" "$release" "$base" true > "$base.log" 2>&1 || { tail "$base.log"; die "no root could be made"; }
  chroot "$base" apt-get update > "$base.log" 2>&1 || { tail "$base.log"; die "no package lists"; }
  touch "$base/.ready"
fi
[[ ! -e $root ]] || clean  # of a trial that was killed
cp -a "$base" "$root"
mount -t proc proc "$root/proc"
mount -t sysfs sysfs "$root/sys"
mount -t tmpfs tmpfs "$root/dev/shm"
# inside COMMAND...: as root; as_user COMMAND: as an ordinary user, in her home.
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive LANG=C.UTF-8 "$@"; }
as_user() { chroot --userspec=tester:tester "$root" env -i PATH=/usr/bin:/bin HOME=/home/tester LANG=C.UTF-8 sh -c "cd && $1"; }
# As in every installed Debian; without it mpirun waits five seconds for the name of the host.
printf '127.0.0.1 localhost %s\n' "$(hostname)" > "$root/etc/hosts"
inside useradd --create-home --shell /bin/sh tester
# All files except those that every installation of a package changes.
files() { (cd "$root" && find . -xdev \( -path ./proc -o -path ./sys -o -path ./home -o -path ./root -o -path ./tmp -o -path ./dev -o -path ./var/cache -o -path ./var/log -o -path ./var/lib/apt \
  -o -path ./var/lib/dpkg -o -path ./trial \) -prune -o -print | sort); }

# Tools of the tests and stock LIGGGHTS, which is only recommended, are installed before.
[[ -z $build ]] || inside apt-get install -y --no-install-recommends cmake liggghts liggghts-doc procps python3 > "$root.log" 2>&1 || { tail "$root.log"; die "no tools for tests"; }
inside dpkg-query -W -f '${Package}\n' | sort > "$root.before"
files > "$root.files_before"
tools=()
# The wheel brings its libraries: the mechanism moves without a package of footfall; a run says what it needs.
if [[ -n $wheel ]]; then
  tools=(python3-venv python3-numpy)
  inside apt-get install -y --no-install-recommends "${tools[@]}" > "$root.log" 2>&1 || { tail "$root.log"; die "no Python for the wheel"; }
  echo "The wheel $(basename "$wheel") alone"
  cp "$wheel" "$root/home/tester" && chmod a+r "$root/home/tester/"*.whl
  cat > "$root/home/tester/wheel.py" << 'PY'
import sys
import footfall as ff
body = {"name": "b", "mass": 2.0, "position": [0, 0, 0], "inertia": [0.1, 0.1, 0.1]}
scene = ff.Scene({"end_time": 0.5, "gravity": [0, 0, -9.81], "bodies": [body]})
with ff.Simulation(scene) as sim:
    sim.step(0.5)
    assert abs(sim["b.z"] + 0.5 * 9.81 * 0.25) < 1e-9, sim["b.z"]
if sys.argv[1] == "alone":
    try:
        ff.run(scene, out="by_wheel")
    except ff.InputError as error:
        assert "FOOTFALL_PROGRAM" in str(error), error
    else:
        raise SystemExit("a run without programs")
else:
    run = ff.run(scene, out="by_wheel")
    assert ff.__file__.startswith(sys.prefix) and abs(run.history["b.z"][-1] + 0.5 * 9.81 * 0.25) < 1e-9
PY
  as_user "python3 -m venv --system-site-packages wheel && wheel/bin/pip install --no-index --quiet *.whl && wheel/bin/python wheel.py alone" > "$root.said" 2>&1 ||
    { tail -n 20 "$root.said"; die "the wheel does not move a mechanism"; }
fi
mkdir "$root/trial"
cp "${packages[@]}" "$root/trial"
chmod -R a+rX "$root/trial"
echo "Installing $(basename -a "${packages[@]}" | tr '\n' ' ')"
inside sh -c 'apt-get install -y --no-install-recommends /trial/*.deb' > "$root.log" 2>&1 || { tail -n 30 "$root.log"; die "cannot be installed"; }
inside sh -c 'dpkg -s footfall' | grep -E '^(Version|Installed-Size|Depends)'
files > "$root.files_installed"
touch "$root/trial/installed"

bed='--set particles.box.size=[3.2,3.2] --set particles.box.depth=0.2 --set particles.box.radius=0.05 --set particles.box.zones.0.size=[0.4,0.4] --set particles.box.zones.0.depth=0.06
  --set particles.box.pour.settle_time=0.05 --ranks 1'
bed=$(tr '\n' ' ' <<< "$bed")
echo "Landing as root"
inside sh -c "cd && footfall run --until 0.01 $bed" > "$root.said" 2>&1 || { tail -n 20 "$root.said"; die "does not run as root"; }
echo "Landing as an ordinary user"
as_user "footfall run --until 0.01 $bed" > "$root.said" 2>&1 || { tail -n 20 "$root.said"; die "does not run as an ordinary user"; }
tail -n 25 "$root.said" | grep -E 'done|grains |plots/overview' || die "has no results"
as_user "footfall new my_wheel --from wheel && footfall check my_wheel && footfall run my_wheel --until 0.02 --quiet && footfall plot runs/my_wheel wheel.v && footfall view runs/my_wheel &&
  footfall report runs/my_wheel" > "$root.said" 2>&1 || { tail -n 20 "$root.said"; die "a new case does not run"; }
((!whole)) || { echo "The whole landing"; as_user "footfall run" > "$root.said" 2>&1 || { tail "$root.said"; die "the landing does not run"; }; tail -n 30 "$root.said"; }
if [[ -d $root/usr/include/footfall ]]; then
  echo "The C++ example against footfall-dev"
  as_user "cp -r /usr/share/footfall/examples/own_mechanism_cpp own && cd own && cmake -S . -B build && cmake --build build &&
    PMIX_MCA_pmdl=^ompi mpirun --oversubscribe -np 1 liggghts_mbd -in in.tamper -screen none : -np 1 build/tamper > tamper.csv" > "$root.said" 2>&1 || { tail -n 30 "$root.said"; die "does not build or run"; }
  tail -n 1 "$root.said"
fi
if [[ -x $root/usr/bin/footfall_fmu ]]; then
  echo "A scene as an FMU, which another scene runs"
  as_user "printf '%s\n' 'end_time = 0.005' '[[bodies]]' 'name = \"block\"' 'mass = 1' 'inertia = [1, 1, 1]' 'position = [0, 0, 0]' > host.toml
    printf '%s\n' '[[signals]]' 'name = \"lander\"' 'kind = \"fmu\"' 'file = \"lander.fmu\"' 'outputs = { v = \"cabin.vz\" }' 'period_ms = 1' >> host.toml
    footfall fmu /usr/share/footfall/inputs/rigid_plane --out lander.fmu &&
    footfall run host.toml --trust-script --quiet" > "$root.said" 2>&1 || { tail -n 20 "$root.said"; die "the FMU does not run"; }
  grep -h 'an FMU' "$root.said"
fi
if [[ -d $root/usr/lib/python3/dist-packages/footfall ]]; then
  echo "The Python example"
  as_user "cp -r /usr/share/footfall/examples/python_landing . && cd python_landing && sed -i 's|../../inputs|/usr/share/footfall/inputs|' * && python3 land.py out && python3 notebook.py" \
    > "$root.said" 2>&1 || { tail -n 20 "$root.said"; die "Python does not land"; }
  tail -n 1 "$root.said"
fi
if [[ -n $wheel ]]; then
  echo "The wheel with the programs of the package"
  as_user "wheel/bin/python wheel.py programs && wheel/bin/pip uninstall -y --quiet footfall" > "$root.said" 2>&1 || { tail -n 20 "$root.said"; die "the wheel does not run a scene"; }
  left=$(find "$root/home/tester/wheel" -iname '*footfall*')
  [[ -z $left ]] || { echo "$left"; die "the wheel leaves this"; }
fi
if [[ -n $build ]]; then
  echo "The tests of $build, with the installed programs"
  mkdir -p "$root/$source" "$root/$build"
  mount --bind "$source" "$root/$source"
  mount -o remount,ro,bind "$root/$source"
  cp -a "$build/." "$root/$build"
  for program in "$root/$build"/bin/*; do
    [[ ! -x $root/usr/bin/${program##*/} ]] || ln -sf "/usr/bin/${program##*/}" "$program"
  done
  inside chown -R tester:tester "$build"
  # Tests that use the installed programs; others contain parts of the sources, or install BUILD.
  as_user "ctest --test-dir '$build' -j3 --output-on-failure --label-exclude '^(unit|physics)$' --exclude-regex '^(app.Install|Install\..*)$' ${TESTS-}" > "$root.tests" 2>&1 ||
    { grep -E 'tests passed|^\s+[0-9]+ - ' "$root.tests"; die "tests fail; $root.tests"; }
  grep -E 'tests passed|Total Test time' "$root.tests"
  umount "$root/$source"
  rm -rf --one-file-system "${root:?}/$build"
fi
[[ -z $(find "$root/usr" "$root/etc" -newer "$root/trial/installed" -type f) ]] || die "a run wrote into the system"

echo "Removing"
# Packages that others only suggest (perl-base: perl) are removed, too.
inside apt-get -o APT::AutoRemove::SuggestsImportant=false -o APT::AutoRemove::RecommendsImportant=false purge -y --autoremove footfall footfall-dev "${tools[@]}" > "$root.log" 2>&1 || { tail "$root.log"; die "cannot be removed"; }
# Only files of the package itself count.
left=$(comm -13 "$root.files_before" <(files) | grep -i footfall || true)
[[ -z $left ]] || { echo "$left"; die "this is left"; }
[[ -z $(inside dpkg-query -W -f '${Package}\n' | grep footfall) ]] || die "the packages are still known"
# apt depends on base-passwd or adduser: once there, adduser stays.
others=$(comm -13 "$root.before" <(inside dpkg-query -W -f '${Package} ${db:Status-Status}\n' | sed -n 's/ installed$//p' | grep -vx adduser | sort))
[[ -z $others ]] || die "packages stay: $others"
echo "Removed without a trace"
