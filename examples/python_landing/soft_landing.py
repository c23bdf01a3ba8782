"""A soft landing by choosing voltages, with the interface of Gymnasium (which is not needed): reset() and step(action).

python3 soft_landing.py [EPISODES] searches for the best of constant and of linear policies.
"""
import sys

import numpy as np

import footfall as ff


class SoftLanding:
    """Observation (4): height [m], velocity [m/s], acceleration of the cabin [m/s2], longest stroke of a leg [m].
    Action: voltage of all dampers, [0 ... 1]. Reward: - (largest acceleration so far rises by) [m/s2]."""

    period = 2e-3  # of a decision [s]
    legs = [f"leg_{i}_primary.stroke" for i in range(1, 5)]

    def __init__(self, scene="lander.toml", end=0.08):
        self.end = end
        self.sim = ff.Simulation(scene)
        self.start = self.sim.save()  # a new episode costs no new mechanism

    def _observe(self):
        return np.append(self.sim[["cabin.z", "cabin.vz", "cabin.az"]], self.sim[self.legs].max())

    def reset(self, seed=None):
        self.sim.restore(self.start)
        self.peak = 0.0
        return self._observe(), {}

    def step(self, action):
        for leg in range(1, 5):
            self.sim.set_signal(f"voltage_{leg}", float(np.clip(action, 0.0, 1.0)))
        self.sim.step(self.sim.time + self.period)
        seen, before = self._observe(), self.peak
        self.peak = max(self.peak, abs(seen[2]))
        ends = self.sim.time > self.end - 1e-9
        return seen, before - self.peak, ends, False, {}


def episode(env, policy):
    """The return of one landing: minus its largest acceleration [m/s2]."""
    seen, _ = env.reset()
    total, ends = 0.0, False
    while not ends:
        seen, reward, ends, _, _ = env.step(policy @ np.append(1.0, seen))
        total += reward
    return total


if __name__ == "__main__":
    episodes = int(sys.argv[1]) if len(sys.argv) > 1 else 12
    env, chance = SoftLanding(), np.random.default_rng(1)
    best = np.zeros(5)  # voltage = best . (1, z, vz, az, stroke)
    first = score = episode(env, best)
    for _ in range(episodes):
        trial = best + chance.normal(size=5) * [0.3, 0.0, 0.1, 0.01, 1.0]
        if (found := episode(env, trial)) > score:
            best, score = trial, found
    print(f"largest acceleration: {-first:.1f} m/s2 without voltage, {-score:.1f} m/s2 with the best of {episodes} policies")
    assert score >= first
