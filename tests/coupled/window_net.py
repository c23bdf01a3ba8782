#!/usr/bin/env python3
"""Random coupled scenes at some coupling interval against the same scenes at one DEM step.

Wherever the largest contact force or the work of the grains is more than 5 % off, the run must warn of its coupling
interval or stop, and the interval that it advises must be right within 5 %, warn in turn, or be a single DEM step.
    window_net.py BIN FOLDER FIRST COUNT
BIN: folder of liggghts_mbd and mbd_solver; FOLDER: where runs go; seeds FIRST ... FIRST + COUNT - 1.
Grains lie apart from each other on a floor, so that no chaos makes two runs differ.
"""
import csv
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys

OFF = 0.05  # of the largest force, of the largest work
CODES = re.compile(r"(W065[0-4]|W0659|W1640|E064[678])")
DT = 2e-5  # [s]


def material(rng):
    return {"young": rng.choice([5e6, 1e7, 3e7]), "restitution": rng.uniform(0.2, 0.9), "radius": rng.choice([0.01, 0.02])}


def script(m, every, bodies, grains_above):
    r = m["radius"]
    z = "0.0" if not grains_above else "0.06"
    lines = f"""atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
hard_particles yes
region box block -0.3 0.3 -0.3 0.3 -0.1 0.6 units box
create_box 2 box
neighbor 0.008 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {m['young']} 2e11
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 {' '.join([str(m['restitution'])] * 4)}
fix m4 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
pair_style gran model hertz tangential history
pair_coeff * *
timestep {DT}
"""
    step = 2.5 * r
    for i in range(3):
        for j in range(3):
            lines += f"create_atoms 1 single {(i - 1) * step} {(j - 1) * step} {float(z) + r} units box\n"
    lines += f"""set group all diameter {2 * r} density 2600
fix floor all wall/gran model hertz tangential history primitive type 1 zplane -0.0001
fix gravity all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
"""
    for body in bodies:
        lines += f"fix g_{body} all couple/mbd/geometry body {body}\nfix m_{body} all mesh/surface fix g_{body} type 2\n"
    meshes = " ".join("m_" + b for b in bodies)
    lines += f"fix contact all wall/gran model hertz tangential history mesh n_meshes {len(bodies)} meshes {meshes}\n"
    lines += f"fix mbd all couple/mbd every {every} " + " ".join(f"mesh m_{b} {b}" for b in bodies) + "\n"
    return lines + "thermo 100000\nrun 1000000\n"


def body(name, mass, z, size=0.14, thick=0.02):
    return f"""[[bodies]]
name = "{name}"
mass = {mass}
shape = {{ kind = "box", size = [{size}, {size}, {thick}], centre = [0, 0, {z + 0.5 * thick}] }}
[[boundaries]]
body = "{name}"
surface = {{}}
"""


def head(end, more=""):
    return f"""end_time = {end}
gravity = [0, 0, -9.81]
ground = {{ kind = "particles" }}
particles = {{ script = "in.grains" }}
{more}"""


TAIL = "[output]\nplots = false\nvtk = false\ninterval = 1e-4\n"


def prescribed(rng, m):
    top = 2 * m["radius"]
    kind = rng.choice(["tray", "press", "table", "circle"])
    sideways = "{ polynomial = [0] }"
    if kind == "tray":  # grains on a tray that vibrates
        amplitude, frequency = rng.choice([(5e-4, 100), (2e-3, 30), (2e-4, 200)])
        motion = f"z = {{ amplitude = {amplitude}, frequency = {frequency} }}"
        where = 0.06 - 0.02
    elif kind == "press":
        motion = f"z = {{ polynomial = [0, {-rng.uniform(0, 0.1)}, {-rng.uniform(0.5, 5)}] }}"
        where = top + 0.0005
    elif kind == "circle":  # touches and leaves
        amplitude, frequency = rng.choice([(1.2e-3, 40), (5e-4, 100)])
        motion = f"z = {{ amplitude = {-amplitude}, frequency = {frequency} }}"
        sideways = f"{{ amplitude = {amplitude}, frequency = {frequency}, phase_deg = 30 }}"
        where = top + amplitude * rng.uniform(0.3, 0.9)
    else:
        deep = 0.05 * m["radius"]
        motion = f"z = {{ table = [[0, 0], [0.01, {-deep / 2}], [0.02, {-deep}], [0.03, {-deep / 3}], [0.06, 0]] }}"
        where = top
    scene = head(0.03) + body("plate", rng.uniform(0.5, 20), where) + f"""[[joints]]
name = "p"
kind = "prescribed"
bodies = ["ground", "plate"]
point = [0, 0, 0]
axis = "z"
axis2 = "x"
[joints.motion]
x = {sideways}
y = {{ polynomial = [0] }}
{motion}
rotation = {{ polynomial = [0] }}
hold_other_rotations = true
"""
    return scene, ["plate"], kind == "tray"


def driven(rng, m):
    mass = rng.uniform(0.5, 5)
    command = rng.choice(["{ polynomial = [%g] }" % -rng.uniform(0, 30),
                          "{ amplitude = %g, frequency = %g }" % (rng.uniform(5, 50), rng.choice([20, 100, 300])),
                          "{ signal = \"on\" }", "{ signal = \"touched\" }"])
    scene = head(0.04) + body("plate", mass, 2 * m["radius"] + rng.uniform(0, 0.001)) + f"""[[joints]]
name = "slide"
kind = "prismatic"
bodies = ["ground", "plate"]
point = [0, 0, 0]
axis = "z"
[[drives]]
name = "motor"
kind = "torque"
joint = "slide"
command = {command}
"""
    if "touched" in command:  # by a load
        scene += f"""[[signals]]
name = "touched"
kind = "expression"
input = "state.pushes * {-rng.uniform(20, 200)}"
[[states]]
name = "waits"
[[states]]
name = "pushes"
[[events]]
name = "touch"
to = "pushes"
when = "{rng.choice(['plate.contact.fz', 'plate.az'])} > {rng.uniform(10, 60)}"
[initial]
velocity = [0, 0, {-rng.uniform(0, 0.5)}]
"""
    if "\"on\"" in command:
        scene += f"""[[signals]]
name = "on"
kind = "expression"
input = "time > {rng.uniform(0.005, 0.03)} ? {-rng.uniform(20, 200)} : 0"
period = {rng.choice([1e-3, 2e-3, 5e-3])}
"""
    return scene, ["plate"], False


def suspended(rng, m):
    foot, frequency = rng.uniform(0.2, 2), rng.choice([10, 30, 100, 300])
    stiffness = foot * (2 * math.pi * frequency) ** 2
    speed = rng.uniform(0, 0.5)
    scene = head(0.04) + body("foot", foot, 2 * m["radius"] + 0.0005) + f"""[[bodies]]
name = "carrier"
mass = {rng.uniform(2, 20)}
inertia = [1, 1, 1]
position = [0, 0, 0.3]
[[joints]]
name = "rail"
kind = "prismatic"
bodies = ["ground", "carrier"]
point = [0, 0, 0.3]
axis = "z"
[[joints]]
name = "leg"
kind = "prismatic"
bodies = ["carrier", "foot"]
point = [0, 0, 0.1]
axis = "z"
[joints.displacement.spring]
stiffness = {stiffness}
damping = {rng.uniform(0, 0.1) * 2 * math.sqrt(stiffness * foot)}
[initial]
velocity = [0, 0, {-speed}]
"""
    return scene, ["foot"], False


def free(rng, m):
    scene = head(0.04) + body("block", rng.choice([0.05, 0.3, 2, 20]), 2 * m["radius"] + rng.uniform(1e-4, 1e-3))
    scene += f"[initial]\nvelocity = [0, 0, {-rng.uniform(0, 1)}]\n"
    return scene, ["block"], False


def run(binaries, folder, scene, grains, auto=False):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for name, text in (("scene.toml", scene), ("in.grains", grains)):
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)
    line = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", "1", binaries + "/liggghts_mbd", "-in", "in.grains",
            "-screen", "none", ":", "-np", "1", binaries + "/mbd_solver", "scene.toml", "--out", "out", "--quiet"]
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=300)
    text = done.stdout + done.stderr
    result = {"code": done.returncode, "text": text, "said": sorted(set(CODES.findall(text)))}
    if done.returncode == 0:
        with open(os.path.join(folder, "out", "summary.json")) as file:
            summary = json.load(file)
        result["force"] = summary["max_contact_force_N"]
        with open(os.path.join(folder, "out", "history.csv")) as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        column, steps = rows[0].index("work.contact"), rows[0].index("coupling.substeps")
        fixed = [row for row in rows[1:] if abs(math.remainder(float(row[0]), float(row[steps]) * DT or 1)) < 1e-9]
        ends = rows[-1:] if auto else fixed
        result["work"] = [(float(row[0]), float(row[column])) for row in ends]
        result["most_work"] = max(abs(work) for _, work in result["work"])
    return result


def at(rows, time):
    """Linear interpolation."""
    for (t0, w0), (t1, w1) in zip(rows, rows[1:]):
        if time <= t1:
            return w0 + (w1 - w0) * (time - t0) / (t1 - t0)
    return rows[-1][1]


def off(result, reference):
    """Largest relative error of the force, and of the work at ends of coupling intervals: rows within one have its mean load. Where
    the run chooses them, only the end of the run is known."""
    if result["code"] != 0:
        return math.inf
    force = abs(result["force"] - reference["force"]) / max(reference["force"], 1e-9)
    scale = max(reference["most_work"], reference["floor"])
    work = max(abs(w - at(reference["work"], t)) for t, w in result["work"]) / scale
    return max(force, work)


def advised(text):
    found = [int(n) for n in re.findall(r"(?:`every |max_substeps = )(\d+)", text)]
    return min(found) if found else None


def check(binaries, folder, seed):
    rng = random.Random(seed)
    m = material(rng)
    scene, bodies, above = rng.choice([prescribed, driven, suspended, free])(rng, m)
    scene += TAIL
    every = rng.choice([2, 3, 5, 10, 20, 50, 100, "auto", "auto"])
    runs = lambda n, name: run(binaries, os.path.join(folder, f"{seed}_{name}"), scene, script(m, n, bodies, above), n == "auto")
    reference = runs(1, "1")
    if reference["code"] != 0:
        return f"seed {seed}: the run with one DEM step failed: {reference['text'][-600:]}", ""
    # Energy of a grain that moves by a hundredth of its radius under its weight: less work is noise.
    reference["floor"] = 2600 * 4.2 * m["radius"] ** 3 * 9.81 * 0.01 * m["radius"]
    result = runs(every, "n")
    error = off(result, reference)
    note = f"seed {seed}: every {every}: {100 * error:.3g} % off, says {result['said']}"
    if error <= OFF:
        return "", note
    if not result["said"]:
        return note + " although it is wrong", note
    n = advised(result["text"])
    if n is None or n == 1:
        return "", note
    again = runs(n, "advised")
    better = off(again, reference)
    note += f"; advised {n}: {100 * better:.3g} % off, says {again['said']}"
    return (note if better > OFF and not again["said"] else ""), note


def main():
    binaries, folder, first, count = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
    os.environ.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
    wrong = []
    for seed in range(first, first + count):
        fault, note = check(binaries, folder, seed)
        print(fault or note, flush=True)
        if fault:
            wrong.append(fault)
    print(f"{count - len(wrong)} of {count} scenes are right, or warn with the right advice")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
