#!/bin/bash
# A wheel (radius 0.06 m, slip 0.2, 1.5 kg) drives five lengths of a patch of 0.64 m that follows, and the same way on one long bed of the
# same width and depth; both are periodic. One rank each; a sample of the long bed takes some ten minutes.
#   tests/bench/long_bed.sh BUILD OUT [SEED...]      default: seeds 1 to 5; runs that are done are kept
# Then a table: means over the five lengths, of each sample, and their mean and spread.
build=$1 out=$2
shift 2
seeds=${*:-1 2 3 4 5}
source=$(cd "$(dirname "$0")/../.." && pwd)
set -e
mkdir -p "$out"
grep -v '^follow' "$source/tests/app/follow.toml" > "$out/long.toml"
end=7.4  # 0.5 m at 0.5 m/s, then 3.2 m

drive() { # NAME SCENE SETTINGS...
  local name=$1 scene=$2
  shift 2
  grep -qs '"status": "done"' "$out/$name/summary.json" && return
  nice -n 5 "$build/bin/footfall" run "$scene" --quiet --force --set end_time=$end --set particles.box.depth=0.08 --set bodies.wheel.mass=1 \
    --set bodies.axle.mass=0.5 --set bodies.wheel.shape.length=0.08 --set boundaries.wheel.surface.element_size=0.02 \
    --set output.interval=0.01 --set particles.ranks=1 "$@" --out "$out/$name"
}
for seed in $seeds; do drive "patch_$seed" "$source/tests/app/follow.toml" --set "particles.box.size=[0.64,0.24]" --set "particles.box.seed=$seed"; done &
patches=$!
for seed in $seeds; do
  drive "long_$seed" "$out/long.toml" --set "particles.box.size=[4.55,0.24]" --set "particles.box.centre=[1.925,0]" \
    --set particles.box.periodic=true --set "particles.box.seed=$seed"
done
wait $patches

python3 - "$out" $seeds <<'EOF'
import csv, json, statistics as s, sys
out, seeds = sys.argv[1], sys.argv[2:]
columns = ['wheel.contact.fx', 'wheel.contact.my', 'wheel.z']
print('bed seed: pull [N], torque [N m], height of the axle [mm], each over five lengths; grains added, removed')
for bed in ('patch', 'long'):
    means = []
    for seed in seeds:
        rows = [r for r in csv.DictReader(l for l in open(f'{out}/{bed}_{seed}/history.csv') if l[0] != '#')
                if 1.0 <= float(r['time']) < 7.4]
        means.append([s.mean(float(r[c]) for r in rows) * k for c, k in zip(columns, (1, 1, 1e3))])
        counts = json.load(open(f'{out}/{bed}_{seed}/summary.json')).get('bed', {})
        print(bed, seed, *('%.4g' % m for m in means[-1]), counts.get('grains_added', ''), counts.get('grains_removed', ''))
    for k, name in enumerate(('pull', 'torque', 'height')):
        values = [m[k] for m in means]
        print(bed, name, '%.4g +- %.2g' % (s.mean(values), s.stdev(values) if len(values) > 1 else 0.0))
EOF
