"""footfall from Python: multibody mechanisms, alone or on grains.

    import footfall as ff
    scene = ff.Scene("landing.toml")
    scene.set("initial.velocity", [0, 0, -5])
    run = ff.run(scene, out="landing")          # what `footfall run` does
    run.history["cabin.az"]                     # numpy, m/s2

    with ff.Simulation(scene) as sim:           # the mechanism in this process
        while not sim.finished:
            sim.set_signal("thrust", 3000.0)    # of kind "host" in the scene
            sim.step(sim.time + 1e-3)

All numbers are SI: m, kg, s, N, rad, K.
"""

from ._core import __version__
from .errors import ArgumentError, Error, FileError, Finding, InputError, InternalError, NumericalError, PartnerError
from .runs import History, Run, Sweep, load, program, run, sweep
from .scene import Entries, Entry, Scene
from .simulation import Simulation, State

__all__ = [
    "ArgumentError", "Entries", "Entry", "Error", "FileError", "Finding", "History", "InputError", "InternalError", "NumericalError",
    "PartnerError", "Run", "Scene", "Simulation", "State", "Sweep", "__version__", "load", "program", "run", "sweep",
]
