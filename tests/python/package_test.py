"""Scenes, findings, simulations in this process, and runs by the programs."""
import ast
import base64
import functools
import hashlib
import inspect
import os
import re
import signal
import subprocess
import sys
import threading
import unittest
import zipfile

from support import PUSHED, ROOT, ff, folder, numpy

TEXT = """end_time = 0.2
[[bodies]]
name = "bob"
mass = 2.0
inertia = [0.1, 0.1, 0.2]
position = [1, 0, 0]
[[joints]]
name = "hinge"
kind = "revolute"
bodies = ["ground", "bob"]
axis = "y"
point = [0, 0, 0]
"""


class Package(unittest.TestCase):
    def test_tells_its_version(self):
        self.assertRegex(ff.__version__, r"^[0-9]+\.[0-9]+\.[0-9]+$")
        self.assertIn("__version__", ff.__all__)


class Scenes(unittest.TestCase):
    def test_are_files_texts_and_dicts(self):
        file = os.path.join(folder(), "scene.toml")
        with open(file, "w") as out:
            out.write(TEXT)
        as_dict = {
            "end_time": 0.2,
            "bodies": [{"name": "bob", "mass": 2, "inertia": [0.1, 0.1, 0.2], "position": numpy.array([1, 0, 0])}],
            "joints": [{"name": "hinge", "kind": "revolute", "bodies": ("ground", "bob"), "axis": "y", "point": [0, 0, 0]}],
        }
        values = [ff.Scene(source).values for source in (file, os.path.dirname(file), TEXT, as_dict)]
        for other in values[1:]:
            self.assertEqual(other, values[0])

    def test_settings_replace_each_other_and_are_checked(self):
        scene = ff.Scene(TEXT).set("bodies.bob.mass", 3.0).set("solver.integrator", "ida").set("bodies.bob.mass", numpy.float64(4.0))
        self.assertEqual(scene.bodies["bob"].mass, 4.0)
        self.assertEqual(scene.get("solver.integrator"), "ida")
        self.assertIsInstance(scene.bodies.get("bob").position, numpy.ndarray)
        self.assertEqual(list(scene.joints), ["hinge"])
        with self.assertRaises(KeyError):
            scene.bodies["bop"]
        self.assertEqual(ff.Scene(scene).settings, scene.settings)

    def test_findings_are_objects(self):
        findings = ff.Scene(TEXT + "colour = 3\n[solver]\nrtoll = 1\n").check()
        self.assertEqual([(f.severity, f.code, f.line) for f in findings], [("error", "E0103", 13), ("error", "E0103", 15)])
        self.assertTrue(findings[1].advice and findings[1].key == "solver.rtoll")
        strange = ff.Scene(TEXT).set("gravity", [0, 0, -9810]).check()
        self.assertIn("W1155", [f.code for f in strange if f.severity == "warning"])
        self.assertEqual(ff.Scene(TEXT).check(), [])

    def test_errors_have_code_place_and_advice(self):
        with self.assertRaises(ff.InputError) as caught:
            ff.Simulation(ff.Scene(TEXT, settings={"bodies.bop.mass": 1}))
        self.assertEqual((caught.exception.line, caught.exception.key), (-1, "bodies.bop.mass"))
        self.assertTrue(caught.exception.code.startswith("E0") and caught.exception.advice)
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaises(ff.InputError):
            ff.Simulation("nowhere.toml")


class Simulations(unittest.TestCase):
    def test_give_the_digits_of_a_run(self):
        scene = ff.Scene(TEXT, settings={"output.interval": 0.01})
        run = ff.run(scene, out=os.path.join(folder(), "run"))
        with ff.Simulation(scene) as sim:
            for time in run.history["time"][1:]:
                sim.step(time)
                row = int(numpy.searchsorted(run.history["time"], sim.time - 1e-9))
                for name in ("bob.x", "bob.vz", "hinge.angle"):
                    written = run.history[name][row]  # with ten digits
                    self.assertAlmostEqual(sim[name], written, delta=6e-10 * abs(written) + 1e-15, msg=name)

    # x = F t^2 / 2 m: exact for constant forces.
    def test_signals_act_from_the_time_at_which_they_are_set(self):
        sim = ff.Simulation(PUSHED)
        sim.step(0.1)
        sim.set_signal("thrust", -2)
        sim.step(0.2)
        self.assertAlmostEqual(sim["b.vx"], 0.1, delta=1e-12)
        self.assertAlmostEqual(sim["b.x"], 0.01 + 0.02 - 0.005, delta=1e-12)
        self.assertEqual(sim.signals, {"thrust": -2.0})
        numpy.testing.assert_array_equal(sim[["b.x", "b.vx"]], [sim["b.x"], sim["b.vx"]])
        self.assertEqual(sim.columns["b.x"], sim["b.x"])
        self.assertEqual(sim.units["b.vx"], "m/s")
        self.assertEqual((sim.state.q.shape, sim.state.v.shape, sim.state.time), ((7,), (6,), 0.2))

    def test_positions_and_velocities_are_set(self):
        # A pendulum m = 2 kg, l = 1 m, I = 0.1 kg m2 is raised to 30 degrees above the horizontal, 0.2 mm off its hinge, and
        # passes the lowest place with w^2 = 2 m g l (1 + sin 30) / (m l^2 + I).
        sim = ff.Simulation(TEXT.replace("end_time = 0.2", "end_time = 1.5"))
        sim.step(0.05)
        up, q = numpy.pi / 6, numpy.zeros(7)
        q[:3] = 1.0002 * numpy.cos(up), 0, 1.0002 * numpy.sin(up)
        q[3:] = numpy.cos(up / 2), 0, -numpy.sin(up / 2), 0
        sim.set_state(q, numpy.zeros(6))
        numpy.testing.assert_allclose(sim[["bob.x", "bob.z"]], [numpy.cos(up), numpy.sin(up)], atol=1e-4)
        self.assertLess(abs(numpy.hypot(sim["bob.x"], sim["bob.z"]) - 1), 1e-9)
        rows = sim.sample(1.2, 0.0005, ["bob.z", "bob.vx"])
        fastest = 2 * 2 * 9.81 * (1 + numpy.sin(up)) / 2.1
        self.assertAlmostEqual(abs(rows["bob.vx"][rows["bob.z"].argmin()]), fastest**0.5, delta=1e-3)
        self.assertLess(sim.energy_balance, 1e-4)
        state = sim.state
        for given in ({"q": q[:6]}, {"v": [0, 0, 0, 0, 0, numpy.nan]}, {"q": numpy.zeros(7)}, {"v": "fast"}):
            with self.assertRaises(ff.InputError):
                sim.set_state(**given)
        numpy.testing.assert_array_equal(sim.state.q, state.q)

    def test_states_are_saved_and_restored_in_the_same_digits(self):
        sim, other = ff.Simulation(TEXT), ff.Simulation(TEXT)
        sim.step(0.05)
        state = sim.save()
        other.restore(state)
        for each in (sim, other):
            each.step(0.1)
        numpy.testing.assert_array_equal(sim.row, other.row)
        sim.restore(state)
        sim.step(0.1)
        numpy.testing.assert_array_equal(sim.row, other.row)
        with self.assertRaises(ff.InputError):
            ff.Simulation(PUSHED).restore(state)

    def test_rows_are_sampled_without_python_between(self):
        sim, slow = ff.Simulation(TEXT), ff.Simulation(TEXT)
        rows = sim.sample(0.05, 0.01, ["bob.z"])
        self.assertEqual(list(rows), ["time", "bob.z"])
        numpy.testing.assert_allclose(rows["time"], 0.01 * numpy.arange(6), atol=1e-15)
        for k in range(1, 6):
            slow.step(0.01 * k)
            self.assertEqual(slow["bob.z"], rows["bob.z"][k])

    def test_failures_leave_the_state_before_the_step(self):
        scene = dict(PUSHED, signals=PUSHED["signals"] + [{"name": "root", "kind": "expression", "input": "sqrt(0.3 - time)", "period_ms": 10}])
        sim = ff.Simulation(scene)
        sim.step(0.2)
        row, state = sim.row, sim.save()
        with self.assertRaises(ff.NumericalError) as caught:
            sim.step(0.4)
        self.assertIn("t = 0.3", str(caught.exception))
        numpy.testing.assert_array_equal(sim.row, row)
        sim.restore(state)
        sim.step(0.25)
        with self.assertRaises(ff.InputError):
            sim.step(float("nan"))
        with self.assertRaises(ff.InputError):
            sim.set_signal("thrust", float("inf"))

    def test_end_with_the_scene_and_summarize(self):
        with ff.Simulation(PUSHED, record=True) as sim:
            sim.step(10.0)
            self.assertTrue(sim.finished and sim.time == sim.end_time == 0.5)
            self.assertEqual(sim.summary()["status"], "done")
            with self.assertRaises(ff.InputError):
                sim.step(11.0)
        with self.assertRaises(ff.InputError):
            ff.Simulation(PUSHED).summary()

    # u = bias + kp e + ki I + kd (e_k - e_(k-1)) / T, as the sampled kind "pid" computes it.
    def test_a_pid_in_python_gives_the_digits_of_the_built_in(self):
        period, kp, ki, kd = 0.01, 30.0, 20.0, 4.0
        gains = {"name": "thrust", "kind": "pid", "input": "0.1 - b.x", "kp": kp, "ki": ki, "kd": kd, "period": period}
        built_in, led = ff.Simulation(dict(PUSHED, signals=[gains])), ff.Simulation(PUSHED)
        integral, before = 0.0, None
        for k in range(30):
            error = 0.1 - led["b.x"]
            rate = 0.0 if before is None else (1.0 / period) * (error - before)
            led.set_signal("thrust", kp * error + ki * integral + kd * rate)
            integral, before = integral + period * error, error
            led.step((k + 1) * period)
            built_in.step((k + 1) * period)
            self.assertEqual(led["b.x"], built_in["b.x"], k)
            self.assertEqual(led["signal.thrust"], led.signals["thrust"])

    def test_are_separate_in_processes_made_by_fork(self):
        sim = ff.Simulation(TEXT)
        sim.step(0.05)
        child = os.fork()
        if child == 0:
            sim.step(0.1)
            os._exit(0 if sim.time == 0.1 else 1)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)
        sim.step(0.06)
        self.assertAlmostEqual(sim.time, 0.06, delta=1e-12)

    def test_ctrl_c_ends_a_step(self):
        text = TEXT.replace("end_time = 0.2", "end_time = 1e3\noutput = { interval = 1e-3 }")
        script = f"import footfall as ff\nsim = ff.Simulation({text!r})\nprint('begun', flush=True)\nsim.step(1e3)\n"
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stdout.readline()
            process.send_signal(2)
            said = process.communicate(timeout=60)[1]
        self.assertIn(b"KeyboardInterrupt", said)

    def test_refuse_other_threads_while_they_are_stepped(self):
        sim = ff.Simulation(TEXT.replace("end_time = 0.2", "end_time = 1e3\noutput = { interval = 1e-3 }"))
        codes = []

        def refused(call):
            try:
                call()
            except ff.InputError as error:
                codes.append(error.code)

        def other():
            try:
                while not codes:  # until the main thread is within its step
                    refused(lambda: sim.time)
                for call in (lambda: sim.step(1e3), lambda: sim.row, lambda: sim["bob.z"], sim.save):
                    refused(call)
            finally:
                os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=other)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            sim.step(1e3)
            thread.join()
        thread.join()
        self.assertEqual(codes, ["E0729"] * 5)
        reached = sim.time
        sim.step(reached + 1.0)
        self.assertAlmostEqual(sim.time, reached + 1.0, delta=1e-9)


# What a newcomer does wrong: each one an exception with its code, at once, and nothing changes.
class Mistakes(unittest.TestCase):
    def refused(self, code, call, kind=None):
        with self.assertRaises(kind or ff.InputError) as caught:
            call()
        self.assertEqual(caught.exception.code, code, caught.exception)
        self.assertTrue(caught.exception.advice and code in str(caught.exception))

    def test_with_sources_and_settings(self):
        for source in (None, 3.5, [1, 2], b"end_time = 1"):
            self.refused("E0728", lambda: ff.Scene(source), ff.ArgumentError)
        self.refused("E0728", lambda: ff.Scene(TEXT, folder=3))
        self.refused("E0728", lambda: ff.Scene(TEXT, settings=["a=1"]))
        self.refused("E0728", lambda: ff.Scene(TEXT).set(3, 1))
        self.refused("E0728", lambda: ff.Scene(TEXT).get(5))
        self.refused("E0103", lambda: ff.Simulation(ff.Scene(TEXT).set("solver.rtool", 1)))
        for value in (None, {1, 2}, 1j, lambda: 1):
            with self.assertRaises(TypeError):
                ff.Scene(TEXT).set("end_time", value)
        self.assertTrue(issubclass(ff.ArgumentError, (TypeError, ValueError)))

    def test_with_steps_samples_columns_and_signals(self):
        sim = ff.Simulation(PUSHED)
        sim.step(0.1)
        row = sim.row
        for until in ("0.1", None, numpy.array([0.1, 0.2]), True):
            self.refused("E0728", lambda: sim.step(until))
        for until in (0.05, float("nan"), float("inf")):
            self.refused("E0721", lambda: sim.step(until))
        for every in (0, -0.01, float("nan"), 1e-300, "fast"):
            self.refused("E0728", lambda: sim.sample(0.2, every))
        self.refused("E0721", lambda: sim.sample(0.05, 0.01))
        self.refused("E0728", lambda: sim.sample(float("nan"), 0.01))
        self.refused("E0728", lambda: sim.sample(0.2, 0.01, [1]))
        self.refused("E0681", lambda: sim.sample(0.2, 0.01, ["b.q"]))
        for name in (3, [1], None):
            self.refused("E0728", lambda: sim[name])
        self.refused("E0681", lambda: sim["b.q"])
        self.refused("E0723", lambda: sim.set_signal("trust", 1))
        self.refused("E0724", lambda: sim.set_signal("thrust", float("nan")))
        for value in ("full", None, numpy.array([1.0, 2.0])):
            self.refused("E0728", lambda: sim.set_signal("thrust", value))
        self.refused("E0728", lambda: sim.set_signal(1, 1))
        numpy.testing.assert_array_equal(sim.row, row)
        sim.step(0.2)

    def test_with_states_and_closed_simulations(self):
        sim = ff.Simulation(PUSHED)
        state = bytearray(sim.save())
        self.refused("E0728", lambda: sim.restore("state"))
        self.refused("E0726", lambda: sim.restore(b"state"))
        state[-40:] = b"\xff" * 40  # no UTF-8 either
        self.refused("E0402", lambda: sim.restore(bytes(state)))
        self.refused("E0728", lambda: sim.scene.set("bodies.b.mass", 5.0))  # would change nothing
        self.assertEqual(sim.scene.copy().set("bodies.b.mass", 5.0).bodies["b"].mass, 5.0)
        self.refused("E0728", lambda: ff.Simulation(PUSHED, ranks=2))
        sim.close()
        for call in (lambda: sim.step(0.3), sim.save, lambda: sim.set_signal("thrust", 1)):
            self.refused("E0722", call)

    def test_with_runs_and_folders(self):
        place = folder()
        scene = ff.Scene(TEXT, folder=place)
        for ranks in ("two", 0, 1.5):
            self.refused("E0728", lambda: ff.run(scene, ranks=ranks, out=os.path.join(place, "run")))
        for until in ("soon", -1, float("nan")):
            self.refused("E0728", lambda: ff.run(scene, until=until, out=os.path.join(place, "run")))
        self.refused("E0728", lambda: ff.run(scene, out=5))
        self.refused("E0500", lambda: ff.run(scene, out=os.path.join(place, "run"), options=["--fast"]))
        self.refused("E0401", lambda: ff.run(ff.Scene(TEXT, folder=os.path.join(place, "gone")), out="run"), ff.FileError)
        self.refused("E0433", lambda: ff.load(os.path.join(place, "none")))
        self.refused("E0728", lambda: ff.load(None))
        self.refused("E0728", lambda: ff.sweep(3))
        self.refused("E0728", lambda: ff.sweep({"scene": "x"}, out=place, jobs="many"))
        for name, content in (("history.csv", ""), ("summary.json", '{"status":'), ("runs.csv", "")):
            with open(os.path.join(place, name), "w") as out:
                out.write(content)
        self.refused("E0680", lambda: ff.load(place).history["x"])
        self.refused("E0684", lambda: ff.load(place).summary)
        self.assertIn("damaged", repr(ff.load(place)))
        self.refused("E0684", lambda: ff.Sweep(place).table)
        self.assertEqual(os.path.exists(os.path.join(place, "run")), False)

    def test_with_progress_end_the_run(self):
        def fails(share):
            raise RuntimeError("of the progress")

        text = TEXT.replace("end_time = 0.2", "end_time = 1e3")
        with self.assertRaisesRegex(RuntimeError, "of the progress"):
            ff.run(ff.Scene(text, folder=folder()), out=os.path.join(folder(), "run"), progress=fails)


class Stub(unittest.TestCase):
    def test_names_what_the_package_has(self):
        tree = ast.parse((ROOT / "mbd_solver/python/footfall/__init__.pyi").read_text())
        named = [node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))]
        named += [node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)]
        self.assertEqual(sorted(named), sorted(ff.__all__))
        for node in tree.body:
            if not isinstance(node, ast.ClassDef) or issubclass(getattr(ff, node.name), Exception):
                continue
            has = getattr(ff, node.name)
            methods = {inner.name for inner in node.body if isinstance(inner, ast.FunctionDef)}
            self.assertEqual([m for m in methods if not hasattr(has, m)], [], node.name)
            public = {m for m in vars(has) if not m.startswith("_") and m not in getattr(has, "_fields", ())}
            self.assertEqual(public - methods, set(), node.name)
            for method in methods:
                self.assertTrue(method.startswith("__") or getattr(has, method).__doc__ or has is not ff.Simulation, f"{node.name}.{method}")


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shares = []
        cls.run_ = ff.run(ff.Scene(TEXT, folder=folder()), out=os.path.join(folder(), "run"), progress=cls.shares.append)

    def test_give_history_summary_and_pictures(self):
        run = self.run_
        self.assertEqual((run.exit_code, run.summary["status"]), (0, "done"))
        self.assertEqual(run.summary["max_sinkage_m"], run.summary["max_sinkage_m"])  # its former name
        self.assertEqual((self.shares, self.shares[-1]), (sorted(self.shares), 1.0), "shares of the run alone")
        column = run.history["bob.x"]
        self.assertIs(column, run["bob.x"], "a column is one array")
        self.assertFalse(column.flags.writeable or column.flags.owndata)
        self.assertEqual(run.history.units["bob.x"], "m")
        self.assertEqual(len(column), len(run.history["time"]))
        self.assertTrue(os.path.getsize(run.plot("bob.x")) > 1000)
        self.assertTrue(os.path.exists(run.view(show=False)))
        self.assertIn("Run(", run._repr_html_())
        self.assertIn('<img src="data:image/svg+xml;base64,', run._repr_html_(), "each picture has identifiers of its own")
        with self.assertRaises(KeyError):
            run.history["bob.q"]

    def test_are_loaded_from_their_folders(self):
        again = ff.load(self.run_.folder)
        numpy.testing.assert_array_equal(again["bob.z"], self.run_["bob.z"])
        with self.assertRaises(ff.InputError):
            ff.load(folder())

    def test_become_tables_where_these_are_installed(self):
        for module, convert in (("pandas", self.run_.to_pandas), ("xarray", self.run_.to_xarray)):
            try:
                __import__(module)
            except ImportError:
                continue
            table = convert()
            numpy.testing.assert_array_equal(numpy.asarray(table["bob.x"]), self.run_["bob.x"])
            numpy.testing.assert_array_equal(numpy.asarray(table["bob.x"].index if module == "pandas" else table.time), self.run_["time"])
            self.assertEqual((table.attrs["units"]["bob.x"] if module == "pandas" else table["bob.x"].attrs["units"]), "m")

    def test_refusals_of_the_programs_are_exceptions(self):
        with self.assertRaises(ff.InputError) as caught:
            ff.run(ff.Scene(TEXT + "colour = 3\n", folder=folder()), out=os.path.join(folder(), "run"))
        self.assertEqual((caught.exception.code, caught.exception.line), ("E0103", 13))

    def test_sweeps_use_the_engine_of_the_command_line(self):
        place = folder()
        with open(os.path.join(place, "scene.toml"), "w") as out:
            out.write(TEXT)
        file = os.path.join(place, "masses.toml")
        with open(file, "w") as out:
            out.write('scene = "scene.toml"\nparameters = [{ name = "mass", settings = ["bodies.bob.mass={value}"], values = [1.0, 2.0] }]\n'
                      'figures = [{ name = "descent", key = "max_descent_m" }]\n')
        shares = []
        sweep = ff.sweep(file, out=os.path.join(place, "out"), jobs=1, progress=shares.append)
        self.assertEqual(sweep.exit_code, 0)
        # Both masses fall alike: the hinge is at rest, and inertia is small against m r2 = 2 and 1 kg m2.
        self.assertEqual(len(sweep.table["descent"]), 2)
        self.assertEqual(len(sweep.runs), 2)
        self.assertIn("Sweep(", sweep._repr_html_())
        self.assertEqual(shares, [0.5, 1.0])
        self.assertEqual(type(ff.load(sweep.folder)), ff.Sweep)


class Stubs(unittest.TestCase):
    def test_name_what_the_module_has_with_its_parameters(self):
        with open(os.path.splitext(ff.__file__)[0] + ".pyi", encoding="utf-8") as file:
            stub = ast.parse(file.read())

        def check(owner, name, node):
            found = inspect.getattr_static(owner, name)
            if isinstance(found, (property, functools.cached_property)):
                self.assertEqual([ast.unparse(d) for d in node.decorator_list], ["property"], name)
                return
            names = [a.arg for a in [*node.args.args, node.args.vararg, *node.args.kwonlyargs, node.args.kwarg] if a]
            self.assertEqual(names, [p for p in inspect.signature(found).parameters], f"{owner.__name__}.{name}")

        public = set()
        for node in stub.body:
            if isinstance(node, ast.FunctionDef):
                public.add(node.name)
                check(ff, node.name, node)
            elif isinstance(node, ast.ClassDef):
                public.add(node.name)
                owner = getattr(ff, node.name)
                told = {each.name: each for each in node.body if isinstance(each, ast.FunctionDef)}
                for name, each in told.items():
                    if not name.startswith("__"):
                        check(owner, name, each)
                own = {name for name, value in vars(owner).items()
                       if not name.startswith("_") and (inspect.isfunction(value) or isinstance(value, (property, functools.cached_property)))}
                self.assertEqual(own - set(told), set(), f"{node.name}: the stub does not name these")
        self.assertEqual({name for name in ff.__all__ if name not in public and callable(getattr(ff, name))}, set())


class Wheel(unittest.TestCase):
    def test_holds_what_it_loads_with_true_digests(self):
        made = folder()
        package = os.path.dirname(ff.__file__)
        subprocess.run([sys.executable, ROOT / "packaging/python/make_wheel.py", package, "1.2.3", made], check=True, capture_output=True)
        [name] = os.listdir(made)
        self.assertTrue(re.fullmatch(r"footfall-1\.2\.3-cp3\d+-cp3\d+-manylinux_2_\d+_\w+\.whl", name), name)
        place = os.path.join(made, "unpacked")
        with zipfile.ZipFile(os.path.join(made, name)) as wheel:
            wheel.extractall(place)
            rows = [row.split(",") for row in wheel.read("footfall-1.2.3.dist-info/RECORD").decode().splitlines()]
            self.assertEqual({row[0] for row in rows}, set(wheel.namelist()))
            for file, digest, size in rows[:-1]:
                content = wheel.read(file)
                found = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                self.assertEqual((digest, size), ("sha256=" + found, str(len(content))), file)
        # Its module takes its libraries from the wheel; the system's libraries have the same names.
        said = subprocess.run([sys.executable, "-c", "import footfall; print(footfall.__file__); print(open('/proc/self/maps').read())"], check=True,
                              capture_output=True, text=True, env=dict(os.environ, PYTHONPATH=place)).stdout
        self.assertTrue(said.startswith(place), said[:200])
        for library in ("sundials_ida", "klu", "fcl", "tomlplusplus"):
            self.assertRegex(said, place + r"/footfall\.libs/lib" + library)


if __name__ == "__main__":
    unittest.main()
