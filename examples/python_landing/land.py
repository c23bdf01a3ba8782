"""Lands the lander and plots it: python3 land.py [FOLDER]."""
import sys

import footfall as ff

scene = ff.Scene("../../inputs/rigid_plane")
scene.set("initial.velocity", [0, 0, -3.0])
run = ff.run(scene, out=sys.argv[1] if len(sys.argv) > 1 else None, until=0.05, force=True)
print(f"largest acceleration of the cabin: {run.history['cabin.az'].max():.1f} m/s2 in {run.history['time'][-1]:.3g} s")
run.plot("cabin.az", "cabin.vz", file=run.folder + "/landing.svg")
