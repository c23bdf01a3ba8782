"""compare.py SOLVER LANDER SCENES WORK OUT REPEATS: runs both programs and writes OUT/simbody.csv and OUT/simbody.md, the same two as simbody_sampled.*
for voltages that change every millisecond, and OUT/simbody_instructions.md.

Error: the largest, over height and four strokes, of the root mean square difference to the same program at its tightest tolerance, as a share of the
largest change of that column in the reference. Rows every 1 ms. Processor time of footfall: of the whole program, without the shortest time that it takes to
the first step; Simbody's program measures its integration itself, rows included.
"""
import csv
import os
import resource
import subprocess
import sys

solver, lander, scenes, work, out, repeats = sys.argv[1:7]
repeats = int(repeats)
TOLERANCES = ["1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7"]
TIGHT = {"footfall": "1e-9", "cpodes": "1e-8", "merson": "1e-8"}
SHOWN = {"footfall": "footfall", "cpodes": "Simbody, CPodes", "merson": "Simbody, Merson"}


def processor_time(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, text


def columns(file, names):
    with open(file) as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return [[float(row[name]) for row in rows] for name in names]


starts = []  # what footfall takes to the first step [s], of all its runs


RUN = os.path.join(work, "run")


def footfall_words(tolerance, sampled):
    scene = os.path.join(scenes, "sampled.toml" if sampled else "scene.toml")
    return [solver, scene, "--quiet", "--keep-every", "0", "--out", RUN, "--set", "solver.rtol=" + tolerance,
            "--set", "solver.atol=%g" % (0.01 * float(tolerance))]


def footfall(tolerance, sampled):
    words = footfall_words(tolerance, sampled)
    starts.append(processor_time(words + ["--until", "1e-6"])[0])
    whole, _ = processor_time(words)
    names = ["cabin.z"] + ["leg_%d_primary.stroke" % k for k in (1, 2, 3, 4)]
    with open(os.path.join(RUN, "summary.json")) as file:
        text = file.read()
    count = lambda key: int(text.split('"%s": ' % key)[1].split(",")[0])
    return whole, columns(os.path.join(RUN, "history.csv"), names), count("steps"), count("residuals")


def simbody(integrator):
    def run(tolerance, sampled):
        rows = os.path.join(work, "rows.csv")
        words = [lander, integrator, tolerance, "1", rows] + ["sampled"] * sampled
        text = subprocess.run(words, check=True, capture_output=True, text=True).stdout.split()
        return float(text[5]), columns(rows, ["cabin.z"] + ["stroke.%d" % k for k in (1, 2, 3, 4)]), int(text[1]), int(text[3])
    return run


def error(result, reference):
    worst = 0.0
    for a, b in zip(result, reference):
        n = min(len(a), len(b))
        rms = (sum((a[i] - b[i]) ** 2 for i in range(n)) / n) ** 0.5
        worst = max(worst, rms / max(abs(x - b[0]) for x in b))
    return worst


def time_at(best, name, level):
    """Straight between points on logarithmic scales; None where the curve does not cross."""
    from math import exp, log
    points = [best[name, t][:2] for t in TOLERANCES]
    for (e0, t0), (e1, t1) in zip(points, points[1:]):
        if e0 >= level >= e1 and e0 > e1:
            s = (log(e0) - log(level)) / (log(e0) - log(e1))
            return exp(log(t0) + s * (log(t1) - log(t0)))
    return points[0][1] if points[0][0] < level else None  # the loosest tolerance is better than that


def compare(name, sampled, programs):
    references = {program: run(TIGHT[program], sampled)[1] for program, run in programs.items()}
    best = {}
    for _ in range(repeats):
        for tolerance in TOLERANCES:
            for program, run in programs.items():
                time, result, steps, evaluations = run(tolerance, sampled)
                key = (program, tolerance)
                if key not in best or time < best[key][1]:
                    best[key] = (error(result, references["cpodes" if program == "merson" else program]), time, steps, evaluations)
    for program, tolerance in best:
        if program == "footfall":
            of_error, time, *work = best[program, tolerance]
            best[program, tolerance] = (of_error, max(time - min(starts), 1e-4), *work)
    with open(os.path.join(out, name + ".csv"), "w") as file:
        file.write("program,tolerance,error,processor_s,steps,evaluations\n")
        for program in programs:
            for tolerance in TOLERANCES:
                file.write("%s,%s,%.3g,%.4g,%d,%d\n" % ((program, tolerance) + best[program, tolerance]))
    with open(os.path.join(out, name + ".md"), "w") as file:
        file.write("Height and strokes of footfall and CPodes at their tightest tolerances agree to %.1e.\n\n"
                   % error(references["footfall"], references["cpodes"]))
        file.write("| program | tolerance | error | processor time [s] | steps | evaluations |\n|---|---|---|---|---|---|\n")
        for program in programs:
            for tolerance in TOLERANCES:
                file.write("| %s | %s | %.1e | %.3f | %d | %d |\n" % ((SHOWN[program], tolerance) + best[program, tolerance]))
        rivals = [program for program in programs if program != "footfall"]
        file.write("\n| error | footfall [s] |" + "".join(" %s [s] | ratio |" % SHOWN[rival] for rival in rivals) + "\n")
        file.write("|---|---|" + "---|---|" * len(rivals) + "\n")
        cell = lambda x: "not reached" if x is None else "%.3f" % x
        for level in (1e-2, 1e-3, 1e-4, 1e-5):
            ours = time_at(best, "footfall", level)
            line = "| %g | %s |" % (level, cell(ours))
            for rival in rivals:
                theirs = time_at(best, rival, level)
                line += " %s | %s |" % (cell(theirs), "%.2f" % (ours / theirs) if ours and theirs else "-")
            file.write(line + "\n")


compare("simbody", False, {"footfall": footfall, "cpodes": simbody("cpodes")})
compare("simbody_sampled", True, {"footfall": footfall, "cpodes": simbody("cpodes"), "merson": simbody("merson")})


def instructions(words):
    text = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"] + words, check=True, capture_output=True, text=True).stderr
    return int(text.split("refs:")[1].split()[0].replace(",", ""))


def count():
    """Instructions of the constant voltages, without those to the first step: they do not depend on the load of the machine."""
    ours = lambda tolerance, more: instructions(footfall_words(tolerance, False) + more)
    theirs = lambda tolerance, end: instructions([lander, "cpodes", tolerance, end, os.path.join(work, "rows.csv")])
    with open(os.path.join(out, "simbody_instructions.md"), "w") as file:
        file.write("| tolerance | instructions of footfall | of Simbody, CPodes | ratio |\n|---|---|---|---|\n")
        for tolerance in TOLERANCES[:4]:
            a = ours(tolerance, []) - ours(tolerance, ["--until", "1e-6"])
            b = theirs(tolerance, "1") - theirs(tolerance, "1e-6")
            file.write("| %s | %.3g | %.3g | %.2f |\n" % (tolerance, a, b, a / b))


count()
