#!/usr/bin/env python3
"""Prints how the stress under a pad at constant speed depends on the grains: docs/data/speed_resistance.txt.
    docs/data/remake/speed_resistance.py FOLDER [REGOLITH]
FOLDER is that of inputs/laws/speed_resistance.toml, REGOLITH that of `footfall ground fit inputs/ground_fits/regolith.toml`.
S(v) is the mean stress between half and one and a half diameters d of the grains below the highest grain. S = a + c d v is fitted over the
speeds. The exponent of a quantity is log(c / c of base) / log(quantity / that of base); a scaling foretells it.
"""
import csv
import math
import pathlib
import sys

BASE = {"young": 1e7, "density": 2600.0, "radius": 0.0125, "gravity": 9.81, "friction": 0.44}
CHANGED = {"base": {}, "modulus / 4": {"young": 2.5e6}, "modulus x 4": {"young": 4e7},
           "gravity of the Moon": {"gravity": 1.63}, "density x 2": {"density": 5200.0}, "friction 0.2": {"friction": 0.2},
           "radius x 0.72": {"radius": 0.009}}
REGOLITH = {"young": 35e6, "density": 2600.0, "radius": 0.02, "gravity": 1.63, "friction": 0.44}
# c goes with these powers
SCALINGS = {"gravity: rho (g / d)^(1/2)": {"density": 1.0, "gravity": 0.5, "radius": -0.5},
            "wave: rho (E / rho_s)^(1/2) / d": {"density": 0.5, "young": 0.5, "radius": -1.0},
            "inertia: rho v / d": {"density": 1.0, "radius": -1.0},
            "between: rho^0.8 E^0.2 v^0.6 / d": {"density": 0.8, "young": 0.2, "radius": -1.0}}


def stress(folder, pad_radius, diameter):
    """Mean over depths of half to one and a half diameters [Pa]."""
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    forces = [float(row["pad.contact.fz"]) for row in rows if 0.5 * diameter < -float(row["pad.z"]) < 1.5 * diameter]
    return sum(forces) / len(forces) / (math.pi * pad_radius**2)


def line(points):
    """a, b of S = a + b v by least squares."""
    n = len(points)
    v, s = sum(p[0] for p in points) / n, sum(p[1] for p in points) / n
    b = sum((p[0] - v) * (p[1] - s) for p in points) / sum((p[0] - v) ** 2 for p in points)
    return s - b * v, b


def foretold(grains, powers):
    return math.prod((grains[key] / BASE[key]) ** power for key, power in powers.items())


def row_of(name, folders, pad_radius, grains):
    diameter = 2.0 * grains["radius"]
    points = [(speed, stress(folder, pad_radius, diameter)) for speed, folder in folders]
    a, b = line(points)
    exponent = math.log(points[-1][1] / points[-2][1]) / math.log(points[-1][0] / points[-2][0])
    return {"name": name, "grains": grains, "points": points, "a": a, "c": b / diameter, "exponent": exponent}


def main():
    runs = pathlib.Path(sys.argv[1]) / "runs"
    rows = []
    for name, change in CHANGED.items():
        label = name.replace(" / ", "___").replace(" ", "_")
        folders = [(float(s), runs / f"grains_{label}__speed_{s}") for s in ("0.5", "1", "2")]
        if all((folder / "history.csv").is_file() for _, folder in folders):  # those that have been run
            rows.append(row_of(name, folders, 0.09, {**BASE, **change}))
    if len(sys.argv) > 2:
        moved = pathlib.Path(sys.argv[2]) / "runs"
        folders = [(float(s), moved / f"motion_{s}_90_0") for s in ("0.6", "1.0", "2.0")]
        rows.append(row_of("regolith", folders, 0.28, REGOLITH))
    print("# Resistance to speed and the grains\nMade by `./footfall sweep inputs/laws/speed_resistance.toml` and "
          "`docs/data/remake/speed_resistance.py`.\n")
    print("| grains | S [kPa] at speeds [m/s] | a [kPa] | c [Pa s/m2] | exponent of v, last two | c over that of base | "
          + " | ".join(SCALINGS) + " | exponent |\n|---" + "|---" * (6 + len(SCALINGS)) + "|")
    for row in rows:
        ratio = row["c"] / rows[0]["c"]
        changed = CHANGED.get(row["name"], {})
        exponent = [f"{math.log(ratio) / math.log(value / BASE[key]):.2f} of {key}" for key, value in changed.items()]
        print(f"| {row['name']} | " + ", ".join(f"{s / 1e3:.1f} at {v:g}" for v, s in row["points"])
              + f" | {row['a'] / 1e3:.1f} | {row['c']:.3g} | {row['exponent']:.2f} | {ratio:.2f} | "
              + " | ".join(f"{foretold(row['grains'], powers):.2f}" for powers in SCALINGS.values())
              + f" | {', '.join(exponent) or '-'} |")
    print()
    for name, powers in SCALINGS.items():
        off = [abs(math.log(row["c"] / rows[0]["c"] / foretold(row["grains"], powers))) for row in rows[1:]]
        print(f"- {name}: off by a factor of {math.exp(sum(off) / len(off)):.2f} in the mean, {math.exp(max(off)):.2f} at most")


main()
