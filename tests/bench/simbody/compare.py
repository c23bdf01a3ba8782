"""compare.py SOLVER LANDER SCENE WORK OUT REPEATS: runs both programs and writes OUT/simbody.csv and OUT/simbody.md.

Error: the largest, over height and four strokes, of the root mean square difference to the same program at its tightest tolerance, as a share of the
largest change of that column in the reference. Rows every 1 ms. Processor time of footfall is that of the whole program without what it takes to the
first step; Simbody's program measures its integration itself, rows included.
"""
import csv
import os
import resource
import subprocess
import sys

solver, lander, scene, work, out, repeats = sys.argv[1:7]
repeats = int(repeats)
TOLERANCES = ["1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7"]
TIGHT = {"footfall": "1e-9", "cpodes": "1e-8"}


def processor_time(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, text


def columns(file, names):
    with open(file) as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return [[float(row[name]) for row in rows] for name in names]


def footfall(tolerance):
    run = os.path.join(work, "run")
    words = [solver, scene, "--quiet", "--keep-every", "0", "--out", run, "--set", "solver.rtol=" + tolerance,
             "--set", "solver.atol=%g" % (0.01 * float(tolerance))]
    start, _ = processor_time(words + ["--until", "1e-6"])
    whole, _ = processor_time(words)
    names = ["cabin.z"] + ["leg_%d_primary.stroke" % k for k in (1, 2, 3, 4)]
    with open(os.path.join(run, "summary.json")) as file:
        text = file.read()
    count = lambda key: int(text.split('"%s": ' % key)[1].split(",")[0])
    return whole - start, columns(os.path.join(run, "history.csv"), names), count("steps"), count("residuals")


def cpodes(tolerance):
    rows = os.path.join(work, "rows.csv")
    text = subprocess.run([lander, "cpodes", tolerance, "1", rows], check=True, capture_output=True, text=True).stdout.split()
    return float(text[5]), columns(rows, ["cabin.z"] + ["stroke.%d" % k for k in (1, 2, 3, 4)]), int(text[1]), int(text[3])


def error(result, reference):
    worst = 0.0
    for a, b in zip(result, reference):
        n = min(len(a), len(b))
        rms = (sum((a[i] - b[i]) ** 2 for i in range(n)) / n) ** 0.5
        worst = max(worst, rms / max(abs(x - b[0]) for x in b))
    return worst


programs = {"footfall": footfall, "cpodes": cpodes}
references = {name: programs[name](TIGHT[name])[1] for name in programs}
between = error(references["footfall"], references["cpodes"])
best = {}
for _ in range(repeats):
    for tolerance in TOLERANCES:
        for name, run in programs.items():
            time, result, steps, evaluations = run(tolerance)
            key = (name, tolerance)
            time = max(time, 1e-4)
            if key not in best or time < best[key][1]:
                best[key] = (error(result, references[name]), time, steps, evaluations)

with open(os.path.join(out, "simbody.csv"), "w") as file:
    file.write("program,tolerance,error,processor_s,steps,evaluations\n")
    for name in programs:
        for tolerance in TOLERANCES:
            file.write("%s,%s,%.3g,%.4g,%d,%d\n" % ((name, tolerance) + best[name, tolerance]))


def time_at(name, level):
    """Straight between points on logarithmic scales; None where the curve does not cross."""
    from math import exp, log
    points = [best[name, t][:2] for t in TOLERANCES]
    for (e0, t0), (e1, t1) in zip(points, points[1:]):
        if e0 >= level >= e1 and e0 > e1:
            s = (log(e0) - log(level)) / (log(e0) - log(e1))
            return exp(log(t0) + s * (log(t1) - log(t0)))
    return points[0][1] if points[0][0] < level else None  # the loosest tolerance is better than that


with open(os.path.join(out, "simbody.md"), "w") as file:
    file.write("Height and strokes of the two programs at their tightest tolerances agree to %.1e.\n\n" % between)
    file.write("| program | tolerance | error | processor time [s] | steps | evaluations |\n|---|---|---|---|---|---|\n")
    for name in programs:
        for tolerance in TOLERANCES:
            file.write("| %s | %s | %.1e | %.3f | %d | %d |\n" % ((name, tolerance) + best[name, tolerance]))
    file.write("\n| error | footfall [s] | Simbody [s] | ratio |\n|---|---|---|---|\n")
    for level in (1e-2, 1e-3, 1e-4, 1e-5):
        ours, theirs = time_at("footfall", level), time_at("cpodes", level)
        cell = lambda x: "not reached" if x is None else "%.3f" % x
        ratio = "%.2f" % (ours / theirs) if ours and theirs else "-"
        file.write("| %g | %s | %s | %s |\n" % (level, cell(ours), cell(theirs), ratio))
