"""Which share of the grains of runs is at rest, from their dumps: what a program that left resting grains out could save at most.

  python3 docs/data/remake/resting_grains.py DIR...     folders of runs with output.vtk

A line per run: grains; means over the second half of the dumps of the shares slower than 0.1, 1 and 10 mm/s.
"""
import pathlib
import sys

from moving_grains import grains

LIMITS = 1e-4, 1e-3, 1e-2  # m/s

print("| run | grains | slower than 0.1 mm/s | 1 mm/s | 10 mm/s |\n|---|---|---|---|---|")
for folder in map(pathlib.Path, sys.argv[1:]):
    files = sorted(folder.glob("grains_[0-9]*.vtp"), key=lambda p: int(p.stem.split("_")[1]))
    shares, count = [], 0
    for path in files[len(files) // 2:]:
        speeds = [speed for _, speed, _ in grains(path).values()]
        count = len(speeds)
        shares.append([sum(s < limit for s in speeds) / count for limit in LIMITS])
    print(f"| {folder.name} | {count} | " + " | ".join(f"{100 * sum(row) / len(row):.0f} %" for row in zip(*shares)) + " |")
