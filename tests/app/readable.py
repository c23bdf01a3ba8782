#!/usr/bin/env python3
"""readable.py RUN: what other programs read of a run with grains and a wheel. history.csv is one line of comment, one of names, then numbers alone
(pandas where it is installed); summary.json names all versions and the machine; drawings have names and velocities; grains.pvd and bodies.pvd
have the same times within a coupling interval, and a .vtp holds the grains."""
import base64, csv, json, math, os, struct, sys, zlib
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
grains = [(float(e.get("timestep")), e.get("file")) for e in xml.parse(run + "/grains.pvd").iter("DataSet")]
times = [time for time, _ in drawn]
assert len(grains) >= 4 and all(min(abs(time - t) for t in times) < 1e-3 for time, _ in grains), (grains, times)

# An array of a .vtp: a header of four numbers (one block, its bytes, 0, its bytes as zlib) and the block, each in base64.
def packed(array):
    text = array.text.strip()
    blocks, size, last, small = struct.unpack("<4I", base64.b64decode(text[:24])[:16])
    block = base64.b64decode(text[24:])
    assert (blocks, last, small) == (1, 0, len(block))
    bytes = zlib.decompress(block)
    assert len(bytes) == size
    return struct.unpack("<%d%s" % (size // 4, {"Float32": "f", "Int32": "i"}[array.get("type")]), bytes)

# The last dump, which the .vtp holds whole and replaces.
assert not any(name.startswith("grains_") and name.endswith(".vtk") and "boundingBox" not in name for name in os.listdir(run))
piece = next(xml.parse(os.path.join(run, grains[-1][1])).iter("Piece"))
arrays = {a.get("Name"): a for a in piece.iter("DataArray")}
n = int(piece.get("NumberOfPoints"))
assert n > 1000
ids = packed(arrays["id"])
assert list(ids) == sorted(set(ids)) and len(ids) == len(packed(arrays["type"])) == n
for name, components in (("Points", 3), ("velocity", 3), ("radius", 1)):
    found = packed(arrays[name])
    assert len(found) == components * n and all(math.isfinite(x) for x in found), name
assert min(packed(arrays["radius"])) > 1e-4 and max(map(abs, packed(arrays["velocity"]))) > 0.01
compile(open(run + "/paraview.py").read(), "paraview.py", "exec")
