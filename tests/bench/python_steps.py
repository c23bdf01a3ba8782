#!/usr/bin/env python3
"""python_steps.py: what leading a simulation from Python costs, against the program, and whether thousands of landings keep their memory.

PYTHONPATH and FOOTFALL_PROGRAM as ./footfall python sets them. Processor times of one machine state: program and module by turns.
"""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

try:
    import numpy
except ImportError:
    sys.exit(77)

import footfall as ff

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANDINGS = int(sys.argv[1]) if len(sys.argv) > 1 else 1000

# A rigid lander of 3.4 kg on four sprung legs and a plane, 1 s.
LANDER = {
    "end_time": 1.0,
    "bodies": [{"name": "cabin", "mass": 3.0, "shape": {"kind": "cylinder", "centre": [0, 0, 0.16], "axis": "z", "radius": 0.07, "length": 0.1}},
               {"name": "foot_{leg}", "mass": 0.1, "shape": {"kind": "dish", "centre": [0.09, 0, 0], "axis": "z", "radius": 0.035, "depth": 0.008,
                                                          "thickness": 0.003}}],
    "arrays": {"leg": {"count": 4, "step_deg": 90}},
    "joints": [{"name": "leg_{leg}", "kind": "prismatic", "bodies": ["cabin", "foot_{leg}"], "point": [0.09, 0, 0.1], "axis": "z",
                "displacement": {"spring": {"stiffness": 1500, "damping": 60}, "stops": {"min": -0.001, "max": 0.04, "stiffness": 1e5}}}],
    "boundaries": [{"body": "foot_{leg}", "surface": {}}],
    "ground": {"kind": "plane", "plane": {"stiffness": 5e5, "restitution": 0.4, "friction": 0.3, "friction_speed": 0.01}},
    "gravity": [0, 0, -1.63],
    "initial": {"clearance": 0.02, "velocity": [0.05, 0, -0.5], "pitch_deg": 4},
    "signals": [{"name": "thrust", "kind": "host"}],
    "forces": [{"name": "engine", "body": "cabin", "point": [0, 0, 0.11], "direction": [0, 0, 1], "force": {"signal": "thrust"}}],
    "output": {"plots": False},
}


def processor_time_of_program(scene, out):
    """Of mbd_solver alone, without `footfall run` around it [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    solver = pathlib.Path(ff.program()).with_name("mbd_solver")
    words = [str(solver), scene._as_file(out), "--out", out, "--quiet"]
    subprocess.run(words, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def processor_time_of_steps(scene, step):
    """Of a simulation from its making to its end, with the acceleration read after each step [s]."""
    begin, peak = time.process_time(), 0.0
    sim = ff.Simulation(scene)
    count = round(sim.end_time / step)
    for k in range(1, count + 1):
        sim.step(k * step)
        peak = max(peak, abs(sim["cabin.az"]))
    return time.process_time() - begin


def memory():
    """Resident [MB]."""
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGESIZE") / 2**20


def main():
    place = tempfile.mkdtemp(prefix="footfall-steps-")
    for name, scene in (("rigid lander", ff.Scene(LANDER, folder=place)),
                        ("lander of inputs/rigid_plane, 0.1 s", ff.Scene(ROOT / "inputs/rigid_plane", settings={"end_time": 0.1}))):
        if scene.file:  # mbd_solver takes no settings of this script
            text = f'base = "{scene.file}"\nend_time = 0.1\n'
            scene = ff.Scene(text, folder=place)
        program, steps = [], []
        for k in range(5):
            program.append(processor_time_of_program(scene, f"{place}/{name[:5]}{k}"))
            steps.append(processor_time_of_steps(scene, 1e-3))
        ratio = min(steps) / min(program)
        print(f"{name}: program {min(program):.3f} s, steps of 1 ms {min(steps):.3f} s: {100 * (ratio - 1):+.1f} %")
    scene, sizes, peaks = ff.Scene(LANDER), [], []
    begin = time.process_time()
    for k in range(LANDINGS):
        sim = ff.Simulation(scene)
        sim.set_signal("thrust", 0.01 * k)
        peaks.append(numpy.abs(sim.sample(1.0, 0.02, ["cabin.az"])["cabin.az"]).max())
        sizes.append(memory())
    early = sizes[min(len(sizes) - 1, 50)]
    print(f"{LANDINGS} landings of 1 s: {1e3 * (time.process_time() - begin) / LANDINGS:.1f} ms each; memory {early:.1f} MB after 51, {sizes[-1]:.1f} MB at the end")
    return 0 if sizes[-1] < 1.05 * early + 1 else 1


sys.exit(main())
