#!/usr/bin/env python3
"""Prints how well soils without grains foretell the landings of inputs/sweeps/landings_foretold.toml: docs/data/landings_foretold.txt.
    docs/data/remake/landings_foretold.py FOLDER [FOLDER...]
FOLDERs are those of the sweep, or of parts of it. A landing is called wrong where soil and grains are on different sides of a limit,
here the median of the grains, where wrong calls are most frequent; and on average over limits between all values of the grains. Near the
limit is what is within 10 % of it on the grains.
"""
import csv
import json
import pathlib
import statistics
import sys

# name, digits; sinkage counts from the highest grain under the pads, where the soil begins
METRICS = {"peak acceleration [g]": 2, "stroke [m]": 3, "descent [m]": 3, "deepest point of a pad [m]": 3,
           "middles of the pads, mean [m]": 3}
NEAR = 0.10


def of_history(folder):
    """Largest stroke, and mean of the depths that the middles of the pads reach [m]."""
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    struts = [name for name in rows[0] if name.endswith("_primary.stroke")]
    pads = [name for name in rows[0] if name.startswith("footpad_") and name.endswith(".z") and name.count(".") == 1]
    return (max(float(row[name]) for row in rows for name in struts),
            statistics.mean(-min(float(row[name]) for row in rows) for name in pads))


def runs_of(folders):
    """metrics[ground][landing]"""
    found = {}
    for top in folders:
        for folder in sorted(pathlib.Path(top, "runs").glob("ground_*__landing_*")):
            if not (folder / "summary.json").is_file():
                continue
            ground, landing = folder.name[len("ground_"):].split("__landing_")
            summary = json.loads((folder / "summary.json").read_text())
            if summary["status"] != "done":
                continue
            stroke, middles = of_history(folder)
            found.setdefault(ground.replace("__", ", ").replace("_", " "), {})[landing] = [
                summary["peak_acceleration_g"], stroke, summary["max_descent_m"], summary["max_sinkage_m"], middles]
    return found


def verdict(grains, soil):
    """Deviations [%] and wrong calls of pairs."""
    deviation = [100.0 * (s / g - 1.0) for g, s in zip(grains, soil)]
    limit = statistics.median(grains)
    wrong = [(g > limit) != (s > limit) for g, s in zip(grains, soil)]
    cuts = sorted(grains)
    limits = [0.5 * (a + b) for a, b in zip(cuts, cuts[1:])]
    share = statistics.mean((g > x) != (s > x) for x in limits for g, s in zip(grains, soil)) if limits else 0.0
    near = [abs(g / limit - 1.0) <= NEAR for g in grains]
    return {"median": statistics.median(map(abs, deviation)), "mean": statistics.mean(deviation),
            "worst": max(deviation, key=abs), "limit": limit, "share": 100.0 * share, "wrong": sum(wrong), "of": len(grains),
            "wrong_near": sum(w and n for w, n in zip(wrong, near)), "near": sum(near)}


def main():
    found = runs_of(sys.argv[1:])
    grains = found.pop("grains")
    print("# Landings foretold by a soil without grains\nMade by `./footfall sweep inputs/sweeps/landings_foretold.toml` and "
          "`docs/data/remake/landings_foretold.py`. Each cell: soil, grains.\n")
    for ground, soil in found.items():
        both = [name for name in sorted(grains) if name in soil]
        print(f"## {ground}\n\n| landing | " + " | ".join(METRICS) + " |\n|---" + "|---" * len(METRICS) + "|")
        for name in both:
            cells = [f"{soil[name][k]:.{d}f}, {grains[name][k]:.{d}f} ({100 * (soil[name][k] / grains[name][k] - 1):+.0f} %)"
                     for k, d in enumerate(METRICS.values())]
            print(f"| {name.replace('__', ', ').replace('_m_s', ' m/s').replace('_', ' ')} | " + " | ".join(cells) + " |")
        print(f"\n| {len(both)} landings | deviation, median | mean | largest | limit | called wrong | of those near it | "
              "mean over all limits |\n|---|---|---|---|---|---|---|---|")
        for k, (metric, digits) in enumerate(METRICS.items()):
            v = verdict([grains[name][k] for name in both], [soil[name][k] for name in both])
            print(f"| {metric} | {v['median']:.0f} % | {v['mean']:+.0f} % | {v['worst']:+.0f} % | {v['limit']:.{digits}f} | "
                  f"{v['wrong']} of {v['of']} | {v['wrong_near']} of {v['near']} | {v['share']:.0f} % |")
        print()


main()
