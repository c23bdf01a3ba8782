#!/usr/bin/env python3
"""Writes docs/data/measured/table.txt again: instruments measured in dry sand against a soil without grains, which is calibrated on
the plate of 80 mm alone. A minute.
    docs/data/remake/measured.py [--footfall PROGRAM] [--runs FOLDER] [--only plate|wheel|pressed|reece|grains] [--table FILE]
    docs/data/remake/measured.py --grains    runs on grains, for grains.csv and grains.txt: ten minutes
With --only the rows of one instrument are compared with those of the table: exit code 1 if one differs by more than 2 %;
"grains" compares grains.txt with grains.csv.
"""
import argparse
import csv
import math
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA = ROOT / "docs/data/measured"
LAWS = {"sand-rft.toml": "resistive force theory", "sand-sinkage.toml": "pressure and sinkage"}
CALIBRATED = "plate of 80 mm"
STUDENT = 4.303  # two-sided 95 % of three tests
RADIUS = 0.058  # of the wheel [m]
SPEED = 0.05  # of the wheel over the ground [m/s]
GRAIN_RADIUS = 0.004  # [m]
SEEDS = (1, 2)  # of the beds of grains
HALF_SPEED = ", half the speed"


def rows_of(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def run(options, scene, out, settings):
    command = [options.footfall, "run", ROOT / "inputs/measured" / scene, "--out", out, "--force", "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"measured.py: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return rows_of(out / "history.csv")


def column(history, name):
    return [float(row[name]) for row in history]


def steady(history, name):
    values = column(history, name)
    last = values[int(0.6 * len(values)):]
    return sum(last) / len(last)


def force_at(history, sinkage):
    depth = [-z for z in column(history, "plate.z")]
    depth = [d - depth[0] for d in depth]
    force = column(history, "plate.contact.fz")
    for k in range(1, len(depth)):
        if depth[k] >= sinkage:
            w = (sinkage - depth[k - 1]) / (depth[k] - depth[k - 1])
            return force[k - 1] + w * (force[k] - force[k - 1])
    sys.exit(f"measured.py: the plate does not reach {sinkage} m")


def name_of_pressed(instrument, width):
    return f"plate of {width} mm" if instrument == "plate" else "smooth wheel, pressed down"


def name_of_force(row):
    return f"force at {row['sinkage_mm']} mm [N]"


def pressed(options, law, instrument):
    """Rows of plates, or of the wheel that does not turn."""
    rows = [row for row in rows_of(DATA / "plates.csv") if row["instrument"] == instrument]
    for width in dict.fromkeys(row["width_mm"] for row in rows):
        scene = "plate.toml" if instrument == "plate" else "pressed_wheel.toml"
        settings = [f"ground.soil={law}"]
        if instrument == "plate":
            settings.append(f"bodies.plate.shape.radius={float(width) / 2000}")
        history = run(options, scene, options.runs / f"{instrument}_{width}_{law[:-5]}", settings)
        for row in rows:
            if row["width_mm"] != width:
                continue
            yield (name_of_pressed(instrument, width), name_of_force(row), float(row["force_N"]), float(row["deviation_N"]),
                   force_at(history, float(row["sinkage_mm"]) / 1000))


def driven(options, law):
    for row in rows_of(DATA / "wheels.csv"):
        if row["wheel"] != "smooth":
            continue
        slip, load = float(row["slip"]), float(row["load_N"])
        rolled = SPEED / (1 - slip) if slip > 0 else SPEED * (1 + slip)  # [m/s]
        history = run(options, "wheel.toml", options.runs / f"wheel_{row['slip']}_{law[:-5]}",
                      [f"ground.soil={law}", f"joints.hub.motion.rotation.polynomial=[0,{rolled / RADIUS:.6g}]",
                       f"forces.load.force.polynomial=[{load - 9.81:.5g}]"])
        what = f"smooth wheel, slip {slip:.2f}"
        yield (what, "pull [N]", float(row["pull_N"]), float(row["pull_deviation_N"]), steady(history, "wheel.contact.fx"))
        yield (what, "sinkage [mm]", float(row["sinkage_mm"]), float(row["sinkage_deviation_mm"]),
               1000 * (RADIUS - steady(history, "wheel.z")))
        yield (what, "torque [N m]", None, None, -steady(history, "wheel.contact.my"))


def measured_force(what, number):
    """Mean and half the 95 % interval."""
    for row in rows_of(DATA / "plates.csv"):
        if (name_of_pressed(row["instrument"], row["width_mm"]), name_of_force(row)) == (what, number):
            return float(row["force_N"]), STUDENT * float(row["deviation_N"]) / math.sqrt(3)
    sys.exit(f"measured.py: plates.csv has no {number} of {what}, which grains.csv has")


def mean_force_at(history, sinkage, start):
    """Mean of the rows within 1 mm of a sinkage, as grains push a plate in jerks; the plate starts at this height above the ground."""
    depth = [-z for z in column(history, "plate.z")]
    force = column(history, "plate.contact.fz")
    near = [f for d, f in zip(depth, force) if abs(d - depth[0] - start - sinkage) <= 0.001]
    if not near:
        sys.exit(f"measured.py: the plate does not reach {sinkage} m")
    return statistics.mean(near)


def pressed_on_grains(options, out, settings, of):
    """Name and force of each row of an instrument (kind, width), which starts at the highest grain, one radius above the mean surface."""
    scene = "plate_grains.toml" if of[0] == "plate" else "pressed_wheel_grains.toml"
    history = run(options, scene, options.runs / out, settings)
    for row in rows_of(DATA / "plates.csv"):
        sinkage = float(row["sinkage_mm"]) / 1000
        if (row["instrument"], row["width_mm"]) == of and sinkage <= 0.025:
            yield name_of_force(row), mean_force_at(history, sinkage, GRAIN_RADIUS)


def on_grains(options):
    """Rows of the instruments on grains: what, number, seed of the bed, value."""
    for seed in SEEDS:
        bed = [f"particles.box.radius={GRAIN_RADIUS}", f"particles.box.seed={seed}"]
        for of in dict.fromkeys((row["instrument"], row["width_mm"]) for row in rows_of(DATA / "plates.csv")):
            width = [f"bodies.plate.shape.radius={float(of[1]) / 2000}"] if of[0] == "plate" else []
            out = f"grains_{of[0]}_{of[1]}_{seed}"
            for number, value in pressed_on_grains(options, out, bed + width, of):
                yield name_of_pressed(*of), number, seed, value
    slow = ["joints.press.motion.z.polynomial=[0,-0.05]", "end_time=0.68"]
    for number, value in pressed_on_grains(options, "grains_slow", slow, ("plate", "80")):
        yield CALIBRATED + HALF_SPEED, number, SEEDS[0], value


def theory_of_wong_and_reece(slip):
    """Pull [N], torque [N m] and sinkage [mm] of a driven rigid wheel [Wong and Reece, J. Terramechanics 4, 1967], by bisection over the angle of entry t1
    until the load is carried. sigma = k r^n (cos t - cos t1)^n in front of tm = (c1 + c2 slip) t1, behind it of the mirrored angle;
    tau = (c + sigma tan phi) (1 - exp(-j / K)), j = r (t1 - t - (1 - slip) (sin t1 - sin t)). Constants of their loose sand, c1 and c2 measured."""
    r, b, load = 0.6274, 0.3048, 9275.0
    k, n, c, friction, shear, c1, c2 = 6.489e5, 1.15, 827.0, 0.6032, 0.0381, 0.18, 0.32
    steps = 2000

    def sums(t1):
        tm = (c1 + c2 * slip) * t1
        lift = pull = torque = 0.0
        for i in range(steps):
            t = t1 * (i + 0.5) / steps
            front = t if t > tm else t1 - t / tm * (t1 - tm)
            sigma = k * r**n * max(0.0, math.cos(front) - math.cos(t1))**n
            j = r * (t1 - t - (1 - slip) * (math.sin(t1) - math.sin(t)))
            tau = (c + sigma * friction) * (1 - math.exp(-j / shear))
            lift += (sigma * math.cos(t) + tau * math.sin(t)) * t1 / steps
            pull += (tau * math.cos(t) - sigma * math.sin(t)) * t1 / steps
            torque += tau * t1 / steps
        return b * r * lift, b * r * pull, b * r * r * torque

    low, high = 1e-3, 1.5
    for _ in range(50):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if sums(middle)[0] < load else (low, middle)
    _, pull, torque = sums(low)
    return pull, torque, 1000 * r * (1 - math.cos(low))


def wong_and_reece(options):
    radius, speed = 0.6274, 0.4
    for slip in (0.1, 0.2, 0.4):
        pull, torque, sinkage = theory_of_wong_and_reece(slip)
        history = run(options, "wong_reece.toml", options.runs / f"wong_reece_{slip}",
                      [f"joints.hub.motion.rotation.polynomial=[0,{speed / (1 - slip) / radius:.6g}]"])
        what = f"wheel of Wong and Reece, slip {slip}"
        yield what, "pull [N]", pull, steady(history, "wheel.contact.fx")
        yield what, "torque [N m]", torque, -steady(history, "wheel.contact.my")
        yield what, "sinkage [mm]", sinkage, 1000 * (radius - steady(history, "wheel.z"))


def verdict(measured, interval, told):
    if measured is None:
        return "not measured"
    if abs(told - measured) <= interval:
        return "within"
    return f"{100 * (told / measured - 1):+.0f} %" if told * measured > 0 else "another sign"


def write_grains(options):
    """Writes grains.csv: every number of every bed."""
    rows = list(on_grains(options))
    with open(DATA / "grains.csv", "w") as file:
        file.write("# Instruments of plates.csv on grains: docs/data/remake/measured.py --grains\n")
        file.write("instrument,number,seed,value\n")
        for what, number, seed, value in rows:
            file.write(f'"{what}",{number},{seed},{value:.4g}\n')


def table_of_grains():
    """The rows of grains.csv as a table: means and standard deviations over the beds, and verdicts."""
    told = {}
    for row in rows_of(DATA / "grains.csv"):
        told.setdefault((row["instrument"], row["number"]), []).append(float(row["value"]))
    lines = ["| instrument | number | measured | grains of 8 mm | verdict |", "|---|---|---|---|---|"]
    for (what, number), values in told.items():
        mean = statistics.mean(values)
        scatter = f" +- {statistics.stdev(values):.2g}" if len(values) > 1 else ""
        measured, interval = measured_force(what.removesuffix(HALF_SPEED), number)
        said = "calibrated" if what == CALIBRATED else verdict(measured, interval, mean)
        lines.append(f"| {what} | {number} | {measured:.3g} +- {interval:.2g} | {mean:.3g}{scatter} | {said} |")
    return "\n".join(lines) + "\n"


def check_grains():
    """Whether grains.txt is the table of grains.csv: exit code."""
    if table_of_grains() == (DATA / "grains.txt").read_text():
        return 0
    print("measured.py: docs/data/measured/grains.txt is not the table of grains.csv; write it again with --grains")
    return 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--footfall", default=str(ROOT / "footfall"))
    parser.add_argument("--runs", type=pathlib.Path, default=ROOT / "runs/measured")
    parser.add_argument("--only", choices=["plate", "wheel", "pressed", "reece", "grains"])
    parser.add_argument("--table", type=pathlib.Path, default=DATA / "table.txt")
    parser.add_argument("--grains", action="store_true")
    options = parser.parse_args()
    if options.grains:
        write_grains(options)
        (DATA / "grains.txt").write_text(table_of_grains())
        return 0
    if options.only == "grains":
        return check_grains()
    told = {}
    for law in LAWS:
        parts = []
        if options.only in (None, "plate"):
            parts.append(pressed(options, law, "plate"))
        if options.only in (None, "pressed"):
            parts.append(pressed(options, law, "wheel"))
        if options.only in (None, "wheel"):
            parts.append(driven(options, law))
        for part in parts:
            for what, number, measured, deviation, value in part:
                told.setdefault((what, number, measured, deviation), []).append(value)
    lines = ["| instrument | number | measured | " + " | ".join(f"{name} | verdict" for name in LAWS.values()) + " |",
             "|---|---|---|" + "---|---|" * len(LAWS)]
    for (what, number, measured, deviation), values in told.items():
        interval = None if measured is None else STUDENT * deviation / math.sqrt(3)
        cells = [what, number, "" if measured is None else f"{measured:.3g} +- {interval:.2g}"]
        for value in values:
            cells += [f"{value:.3g}", "calibrated" if what == CALIBRATED else verdict(measured, interval, value)]
        lines.append("| " + " | ".join(cells) + " |")
    lines += ["", "| instrument | number | their theory, with their measured constants | pressure and sinkage | difference |", "|---|---|---|---|---|"]
    if options.only in (None, "reece"):
        for what, number, theory, value in wong_and_reece(options):
            lines.append(f"| {what} | {number} | {theory:.3g} | {value:.3g} | {100 * (value / theory - 1):+.0f} % |")
    if options.only is None:
        options.table.write_text("\n".join(lines) + "\n")
        print("\n".join(lines))
        return 0
    known = {tuple(line.split(" | ")[:2]): line for line in options.table.read_text().splitlines()}
    wrong = rows = 0
    for line in lines:
        cells, before = line.strip("| ").split(" | "), known.get(tuple(line.split(" | ")[:2]), "").strip("| ").split(" | ")
        if len(cells) < 5 or cells[0] == "instrument":
            continue
        rows += 1
        for k in (3, 5) if len(cells) > 5 else (3,):
            if len(before) <= k or abs(float(cells[k]) - float(before[k])) > 0.02 * abs(float(before[k])) + 0.02:
                print(f"measured.py: {cells[0]}, {cells[1]}: {cells[k]}, in the table {before[k] if len(before) > k else 'none'}")
                wrong += 1
    print(f"measured.py: {rows} rows, {wrong} numbers differ from the table")
    return 1 if wrong or rows == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
