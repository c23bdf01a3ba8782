"""What the tests of the package share. A test without numpy is skipped."""
import os
import pathlib
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("skipped: numpy is missing (python3-numpy)")
    sys.exit(77)

import footfall as ff

ROOT = pathlib.Path(os.environ["FOOTFALL_SOURCE_DIR"])

# A mass of 2 kg on which a host pushes.
PUSHED = {
    "end_time": 0.5,
    "bodies": [{"name": "b", "mass": 2.0, "position": [0, 0, 0], "inertia": numpy.array([0.1, 0.1, 0.1])}],
    "forces": [{"name": "push", "body": "b", "direction": "x", "force": {"signal": "thrust"}}],
    "signals": [{"name": "thrust", "kind": "host", "initial": 4.0}],
}


def folder():
    """A new one, gone with the process."""
    made = tempfile.TemporaryDirectory(prefix="footfall-python-")
    folder.kept.append(made)
    return made.name


folder.kept = []
__all__ = ["PUSHED", "ROOT", "ff", "folder", "numpy"]
