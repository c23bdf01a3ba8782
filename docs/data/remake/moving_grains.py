"""The disturbed region under the pads, from the dumps of a run with output.vtk (Figure 10 of [Lin25]).

  python3 docs/data/remake/moving_grains.py DIR [STEP]     STEP: time step of the grains in s, default 1e-4

A line per dump: time [s]; grains that are 1 cm or more from where they started, and the radius [m] of a half sphere that holds a pad's share of them
(solid fraction 0.6, four pads); grains faster than 0.05 m/s, their mean speed and the 0.99 quantile of speed [m/s].
"""
import base64
import math
import pathlib
import struct
import sys
import xml.etree.ElementTree as xml
import zlib

MOVED, MOVING = 0.01, 0.05  # m, m/s
PADS, SOLID = 4, 0.6


def grains(path):
    """id -> (position [m], speed [m/s], radius [m]) of a .vtp of a run: an array is VTK's header of it and a block of zlib, both in base64."""
    found = {}
    for array in xml.parse(path).iter("DataArray"):
        numbers = zlib.decompress(base64.b64decode(array.text.strip()[24:]))
        kind = {"Int32": "i", "Float32": "f"}[array.get("type")]
        found[array.get("Name")] = struct.unpack(f"<{len(numbers) // 4}{kind}", numbers)
    three = lambda name, i: found[name][3 * i:3 * i + 3]
    return {k: (three("Points", i), math.hypot(*three("velocity", i)), found["radius"][i]) for i, k in enumerate(found["id"])}


def main(folder, step):
    start = None
    print("| time [s] | moved grains | radius [m] | moving grains | mean speed [m/s] | 0.99 quantile [m/s] |\n|---|---|---|---|---|---|")
    for path in sorted(folder.glob("grains_[0-9]*.vtp"), key=lambda p: int(p.stem.split("_")[1])):
        now = grains(path)
        start = start or now
        moved = [r for i, (x, _, r) in now.items() if i in start and math.dist(x, start[i][0]) > MOVED]
        radius = (2 * sum(r ** 3 for r in moved) / SOLID / PADS) ** (1 / 3)  # 2/3 pi R^3 solid pads = sum 4/3 pi r^3
        speeds = sorted(s for _, s, _ in now.values() if s > MOVING)
        mean, high = (sum(speeds) / len(speeds), speeds[int(0.99 * (len(speeds) - 1))]) if speeds else (0, 0)
        print(f"| {int(path.stem.split('_')[1]) * step:.3g} | {len(moved)} | {radius:.2f} | {len(speeds)} | {mean:.3f} | {high:.2f} |")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 1e-4)
