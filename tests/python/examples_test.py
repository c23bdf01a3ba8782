"""The scripts of examples/python_landing, as their README starts them."""
import pathlib
import re
import subprocess
import sys
import unittest

from support import ROOT, ff, folder

PLACE = ROOT / "examples/python_landing"


def run(*words):
    return subprocess.run([sys.executable, *words], cwd=PLACE, capture_output=True, text=True)


class Examples(unittest.TestCase):
    def check(self, *words):
        done = run(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_land_in_eight_lines(self):
        out = pathlib.Path(folder()) / "run"
        self.assertIn("m/s2", self.check("land.py", str(out)))
        self.assertEqual(ff.load(out).summary["status"], "done")
        self.assertTrue((out / "landing.svg").stat().st_size > 1000)

    def test_go_cell_by_cell(self):
        self.assertIn("peaks:", self.check("notebook.py"))

    def test_search_for_a_soft_landing(self):
        before, after = map(float, re.search(r": ([0-9.]+) m/s2 without voltage, ([0-9.]+) m/s2", self.check("soft_landing.py", "3")).groups())
        self.assertLessEqual(after, before)

    def test_are_eight_lines(self):
        code = (PLACE / "land.py").read_text().split('"""', 2)[2]
        self.assertLessEqual(len([line for line in code.splitlines() if line.strip()]), 9)


if __name__ == "__main__":
    unittest.main()
