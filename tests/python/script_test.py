"""Signals of kind "python": digits, states, failures, trust. The package is not needed, the programs are."""
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["FOOTFALL_PROGRAM"]
ROOT = pathlib.Path(os.environ["FOOTFALL_SOURCE_DIR"])
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

SCENE = """end_time = 0.3
bodies = [{ name = "b", mass = 2.0, inertia = [0.1, 0.1, 0.1], position = [0, 0, 0] }]
forces = [{ name = "push", body = "b", direction = "x", force = { signal = "thrust" } }]
output = { plots = false }
[[signals]]
name = "thrust"
period_ms = 10
"""
BUILT_IN = SCENE + 'kind = "pid"\ninput = "0.1 - b.x"\nkp = 30\nki = 20\nkd = 4\n'
SCRIPT = SCENE + 'kind = "python"\nfile = "pid.py"\nfunction = "thrust"\ninputs = ["0.1 - b.x"]\n'
PID = """
integral, before = 0.0, None

def begin():
    global integral, before
    integral, before = 0.0, None

def thrust(time, error):
    global integral, before
    rate = 0.0 if before is None else 100.0 * (error - before)
    value = 30.0 * error + 20.0 * integral + 4.0 * rate
    integral, before = integral + 0.01 * error, error
    return value

def save():
    return [integral, before]

def restore(saved):
    global integral, before
    integral, before = saved
"""


class Scripts(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory(prefix="footfall-script-")
        self.addCleanup(self.place.cleanup)

    def run_(self, scene, script, *words, out="run", trust=True):
        place = pathlib.Path(self.place.name)
        (place / "scene.toml").write_text(scene)
        (place / "pid.py").write_text(script)
        words = ["run", "scene.toml", "--out", out, "--quiet", *(["--trust-script"] if trust else []), *words]
        return subprocess.run([PROGRAM, *words], cwd=place, capture_output=True, text=True, timeout=120, env=ENVIRONMENT)

    def history(self, out="run"):
        return (pathlib.Path(self.place.name) / out / "history.csv").read_bytes()

    def check(self, done, code=0):
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def test_a_pid_gives_the_digits_of_the_built_in(self):
        self.check(self.run_(BUILT_IN, "", out="built_in"))
        self.check(self.run_(SCRIPT, PID))
        self.assertEqual(self.history(), self.history("built_in"))

    def test_only_trusted_scripts_run(self):
        self.assertIn("E0279", self.check(self.run_(SCRIPT, "open('ran', 'w')\n" + PID, trust=False), 2))
        self.assertFalse(os.path.exists(os.path.join(self.place.name, "ran")))
        self.assertFalse(os.path.exists(os.path.join(self.place.name, "run")))

    def test_failures_end_the_run_with_a_message(self):
        for what, script, says in (("exception", "def thrust(t, e):\n    if t > 0.1: raise ValueError('too late')\n    return 1.0\n", "too late"),
                                   ("nan", "def thrust(t, e):\n    return float('nan') if t > 0.1 else 1.0\n", "nan"),
                                   ("crash", "import os\ndef thrust(t, e):\n    if t > 0.1: os.abort()\n    return 1.0\n", "signal 6"),
                                   ("exit", "import sys\ndef thrust(t, e):\n    if t > 0.1: sys.exit(3)\n    return 1.0\n", "SystemExit"),
                                   ("text", "def thrust(t, e):\n    return 'much'\n", "much"),
                                   ("no function", "def push(t, e):\n    return 1.0\n", "push"),
                                   ("hang", "import time\ndef thrust(t, e):\n    if t > 0.1: time.sleep(60)\n    return 1.0\n", "limit")):
            with self.subTest(what):
                limit = "time_limit = 2\n" if what == "hang" else ""  # the others must not meet it on a busy machine
                done = self.run_(SCRIPT + limit + "stateless = true\n", script, "--force")
                said = self.check(done, 1)
                self.assertIn(says, said)
                self.assertIn('signal "thrust"', said)
                self.assertIn("E0350", said)
                self.assertNotIn(b"nan", self.history() if what not in ("text", "no function") else b"")

    def test_a_resumed_run_has_the_same_bytes(self):
        every = SCRIPT.replace("plots = false", "plots = false, checkpoint_interval = 0.1")
        self.check(self.run_(every, PID, out="whole"))
        self.check(self.run_(every, PID, "--until", "0.2"))
        done = subprocess.run([PROGRAM, "run", "--resume", "run", "--until", "0.3", "--quiet", "--trust-script"], cwd=self.place.name,
                              capture_output=True, text=True, timeout=120, env=ENVIRONMENT)
        self.check(done)
        self.assertEqual(self.history(), self.history("whole"))

    def test_a_script_that_cannot_save_is_told_or_refused(self):
        stateful = PID.replace("def save", "def keep")
        self.assertIn("no checkpoints", self.check(self.run_(SCRIPT, stateful)))
        every = SCRIPT.replace("plots = false", "plots = false, checkpoint_interval = 0.1")
        self.assertIn("E0727", self.check(self.run_(every, stateful, "--force"), 2))

    # On grains, interrupted and resumed: the state of the function is in the checkpoint of both programs.
    def test_on_grains_a_resumed_run_has_the_same_bytes(self):
        plate = ROOT / "tests/app/plate"
        scene = f'''base = "{plate}/scene.toml"
end_time = 0.02
[particles]
script = "{plate}/on_bed.in"
bed = {{ script = "{plate}/bed.in" }}
[output]
plots = false
checkpoint_interval = 0.01
[[forces]]
name = "push"
body = "plate"
direction = [0, 0, 1]
force = {{ signal = "thrust" }}
[[signals]]
name = "thrust"
kind = "python"
file = "pid.py"
function = "thrust"
inputs = ["0.1 * plate.vz"]
period_ms = 1
'''
        self.check(self.run_(scene, PID, "--ranks", "1", out="whole"))
        self.check(self.run_(scene, PID, "--ranks", "1", "--until", "0.015"))
        done = subprocess.run([PROGRAM, "run", "--resume", "run", "--until", "0.02", "--quiet", "--trust-script"], cwd=self.place.name,
                              capture_output=True, text=True, timeout=120, env=ENVIRONMENT)
        self.check(done)
        self.assertEqual(self.history(), self.history("whole"))


if __name__ == "__main__":
    unittest.main()
