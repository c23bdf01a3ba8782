"""A landing, cell by cell. Editors with notebooks run the cells; so does python3 notebook.py."""
# %% The scene, looked at before anything runs
import numpy as np

import footfall as ff

scene = ff.Scene("lander.toml")
print(len(scene.bodies), "bodies;", f"the cabin has {scene.bodies['cabin'].mass:.0f} kg")
print([str(finding) for finding in scene.check()])

# %% One landing, step by step
with ff.Simulation(scene) as sim:
    while not sim.finished and sim.time < 0.1:
        fall = -sim["cabin.vz"]
        for leg in range(1, 5):
            sim.set_signal(f"voltage_{leg}", min(1.0, 0.2 * fall))
        sim.step(sim.time + 1e-3)
    print(f"t = {sim.time:.3f} s, {sim.energy_balance:.1e} of the energy is not accounted for")

# %% The same from a state in memory, twice: what one voltage changes
with ff.Simulation(scene) as sim:
    sim.step(0.01)
    state, peaks = sim.save(), []
    for voltage in (0.0, 0.5):
        sim.restore(state)
        for leg in range(1, 5):
            sim.set_signal(f"voltage_{leg}", voltage)
        peaks.append(np.abs(sim.sample(0.06, 5e-4, ["cabin.az"])["cabin.az"]).max())
    print("peaks:", [f"{peak:.1f} m/s2" for peak in peaks])
assert peaks[0] != peaks[1]
