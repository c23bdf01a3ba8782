#!/usr/bin/env bash
# readable.sh FOOTFALL OUT: what other programs read of a run. history.csv is one line of comment, one of names, then numbers alone (pandas where it
# is installed); summary.json names all versions and the machine; drawings have names and velocities; grains and bodies step together.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out"
"$footfall" run "$here/../../examples/02_wheel" --until 0.04 --set particles.box.frames=0.01 --set output.vtk_interval=0.01 --quiet --out "$out/run"
command -v python3 > /dev/null || { echo "no python3 here: not read"; exit 0; }
python3 - "$out/run" <<'PY'
import csv, json, math, os, sys
import xml.etree.ElementTree as xml
run = sys.argv[1]
lines = open(run + "/history.csv").read().split("\n")
assert lines[-1] == "" and lines[0].startswith("# units: ") and not any(line.startswith("#") for line in lines[1:])
rows = list(csv.reader(lines[1:-1]))
names, units = rows[0], lines[0][len("# units: "):].split(",")
assert len(names) == len(set(names)) == len(units) and names[0] == "time", "names and units"
assert len(rows) > 10
for row in rows[1:]:
    assert len(row) == len(names) and all(math.isfinite(float(cell)) for cell in row)
try:
    import pandas
except ImportError:
    print("no pandas here: the form alone was read")
else:
    frame = pandas.read_csv(run + "/history.csv", comment="#")
    assert list(frame.columns) == names and len(frame) == len(rows) - 1 and all(kind == "float64" or kind == "int64" for kind in frame.dtypes)

summary = json.load(open(run + "/summary.json"))
versions = summary["versions"]
for name in ("footfall", "LIGGGHTS", "MPI", "SUNDIALS", "compiler"):
    assert any(c.isdigit() for c in versions[name]), name
assert summary["machine"]["cores"] >= 1 and summary["machine"]["system"]
assert json.load(open(run + "/run.json"))["end_time_s"] == 0.04

drawn = [(float(e.get("timestep")), e.get("file")) for e in xml.parse(run + "/bodies.pvd").iter("DataSet")]
grid = xml.parse(os.path.join(run, drawn[-1][1]))
arrays = {a.get("Name"): a for a in grid.iter("DataArray")}
codes = [int(c) for c in arrays["body_names"].text.split()]
assert "".join(chr(c) if c else " " for c in codes).split() == ["wheel", "axle"], codes
velocity = [float(v) for v in arrays["velocity"].text.split()]
assert len(velocity) == len(arrays["Points"].text.split()) and max(map(abs, velocity)) > 0.01
series = [name for name in os.listdir(run) if name.endswith(".vtk.series")]
assert len(series) == 1
grains = [entry["time"] for entry in json.load(open(os.path.join(run, series[0])))["files"]]
times = [time for time, _ in drawn]
assert len(grains) >= 4 and all(time in times for time in grains), (grains, times)
compile(open(run + "/paraview.py").read(), "paraview.py", "exec")
PY
