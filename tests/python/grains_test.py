"""The coupled pair, led from Python, on a small bed."""
import os
import pathlib
import signal
import subprocess
import threading
import unittest

from support import ROOT, ff, folder, numpy

SCENE = ROOT / "tests/app/plate"


def scene(**settings):
    made = ff.Scene(SCENE)
    made.set("signals", [{"name": "push", "kind": "host"}])
    made.set("forces", [{"name": "push", "body": list(made.bodies)[0], "direction": [0, 0, -1], "force": {"signal": "push"}}])
    for key, value in settings.items():
        made.set(key, value)
    return made


def program_below(ancestor, name):
    """The process of this name that `ancestor` has started, also through others."""
    parents, names = {}, {}
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            text = pathlib.Path("/proc", entry, "stat").read_text()
        except OSError:
            continue
        names[int(entry)] = text[text.index("(") + 1:text.rindex(")")]
        parents[int(entry)] = int(text[text.rindex(")") + 2:].split()[1])
    for process in [p for p in names if names[p] == name]:
        above = process
        while above in parents and above != ancestor:
            above = parents[above]
        if above == ancestor:
            return process
    raise LookupError(name)


class Pair(unittest.TestCase):
    def test_is_led_and_writes_the_folder_of_a_run(self):
        out = os.path.join(folder(), "led")
        with ff.Simulation(scene(end_time=0.01), ranks=1, out=out) as sim:
            self.assertEqual(sim.time, 0.0)
            body = list(sim.scene.bodies)[0]
            sim.step(0.004)
            self.assertGreaterEqual(sim.time, 0.004 - 1e-9)
            before = sim[body + ".az"]
            sim.set_signal("push", 50.0)
            sim.step(0.006)
            self.assertLess(sim[body + ".az"], before, "the push is downwards")
            self.assertEqual(sim["signal.push"], 50.0)
            with self.assertRaises(ff.InputError):
                sim.step(0.001)
            with self.assertRaises(ff.InputError):
                sim.set_signal("pull", 1.0)
            sim.step(1.0)
            self.assertTrue(sim.finished)
        run = ff.load(out)
        self.assertEqual(run.summary["status"], "done")
        self.assertEqual(run.history["time"][-1], sim.time)

    def test_leaves_an_interrupted_run_that_can_be_resumed(self):
        out = os.path.join(folder(), "led")
        on_bed = {"particles.script": "on_bed.in", "particles.bed.script": "bed.in"}
        with ff.Simulation(scene(end_time=0.01, **on_bed), ranks=1, out=out) as sim:
            sim.step(0.003)
            self.assertTrue(os.path.isdir(sim.save()))
            sim.step(0.005)
        self.assertEqual(ff.load(out).summary["status"], "interrupted")
        done = subprocess.run([ff.program(), "run", "--resume", out, "--quiet"], capture_output=True, text=True,
                              env=dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("W0667", done.stderr, "nobody leads a run that is resumed from the command line")

    def test_refuses_what_the_programs_refuse(self):
        with self.assertRaises(ff.InputError) as caught:
            ff.Simulation(scene(end_time=-1.0), ranks=1, out=os.path.join(folder(), "led"))
        self.assertTrue(caught.exception.code)

    def test_refuses_calls_of_other_threads_while_it_is_stepped(self):
        with ff.Simulation(scene(end_time=0.01), ranks=1, out=os.path.join(folder(), "led")) as sim:
            read, others = sim._core._read_row, []

            def other():
                for call in (lambda: sim.step(0.01), lambda: sim.set_signal("push", 1.0), sim.save):
                    with self.assertRaises(ff.InputError) as caught:
                        call()
                    others.append(caught.exception.code)

            def read_row():  # the main thread is within its step
                thread = threading.Thread(target=other)
                thread.start()
                thread.join()
                return read()

            sim._core._read_row = read_row
            sim.step(0.002)
            sim._core._read_row = read
            self.assertEqual(others, ["E0729"] * 3)
            sim.step(0.004)
            self.assertGreaterEqual(sim.time, 0.004 - 1e-9)

    def test_a_killed_program_is_an_error_and_no_hang(self):
        with ff.Simulation(scene(end_time=0.01), ranks=1, out=os.path.join(folder(), "led")) as sim:
            sim.step(0.002)
            os.kill(program_below(sim._core._process.pid, "liggghts_mbd"), signal.SIGKILL)
            with self.assertRaises(ff.Error):
                for k in range(100):
                    sim.step(sim.time + 1e-4)


if __name__ == "__main__":
    unittest.main()
