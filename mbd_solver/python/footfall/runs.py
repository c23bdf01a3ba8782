"""Runs, folders of results and sweeps, by the programs of footfall."""

import base64
import functools
import html
import importlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import webbrowser
from collections.abc import Mapping

import numpy

from . import _core
from .errors import Finding, InputError, made, names_of, number_of, path_of, refuse, whole_of, write_text
from .scene import as_scene

_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


@functools.lru_cache(maxsize=None)
def program():
    """The program `footfall`: of the variable FOOTFALL_PROGRAM, of the build or installation of this module, in PATH, or the script of
    the checkout, which builds it. Raises InputError."""
    here = pathlib.Path(__file__).resolve().parent
    named = os.environ.get("FOOTFALL_PROGRAM")
    candidates = [named] if named else []
    candidates += [here.parents[i] / "bin/footfall" for i in range(min(5, len(here.parents)))]
    candidates += [shutil.which("footfall")] + [folder / "footfall" for folder in here.parents]
    for candidate in candidates:
        if candidate and os.path.isfile(candidate) and os.access(candidate, os.X_OK):
            return os.fspath(candidate)
    raise InputError("the program footfall is neither in the folder of this module nor in PATH; install it, or name it in FOOTFALL_PROGRAM")


def error_of(code, said):
    """The exception of a program that ended with this exit code after saying this."""
    lines = [re.sub(r"^(footfall|mbd_solver|liggghts_mbd): ", "", line) for line in said.splitlines()]
    lines = [line for line in lines if re.search(r" \[E\d{4} [a-z0-9-]+\]$", line)]
    findings = [("error", *_core.report(line)[1:]) for line in dict.fromkeys(lines)]
    kind = {2: "InputError", 1: "NumericalError", 3: "PartnerError"}.get(code, "PartnerError")
    message = "\n".join(f[-1] for f in findings) or said.strip()[-2000:] or f"the program ended with exit code {code}"
    return made(kind, message, findings)


def new_folder(out, scene):
    """A folder of results: `out`, or the first free one of runs/NAME, runs/NAME-2 ..."""
    if out is not None:
        return path_of("out", out, "a folder")
    path = pathlib.Path(scene.file or "scene")
    name = path.resolve().name if path.is_dir() else path.parent.resolve().name if path.name == "scene.toml" else path.stem
    number = 1
    while os.path.exists(folder := os.path.join("runs", name if number == 1 else f"{name}-{number}")):
        number += 1
    return folder


def command_of(scene, out, ranks=None, until=None, quiet=False, force=False, trust_script=False, options=()):
    """The words of `footfall run`."""
    words = [program(), "run", scene._as_file(out), "--out", out]
    for setting in scene.settings:
        words += ["--set", setting]
    words += ["--ranks", str(ranks)] if ranks is not None else []
    words += ["--until", repr(float(until))] if until is not None else []
    words += ["--quiet"] if quiet else []
    words += ["--force"] if force else []
    words += ["--trust-script"] if trust_script else []
    return words + list(options)


class _Bar:
    """Progress from the lines of a run: a line in a terminal, a bar in a notebook; a function is called with the share [0 ... 1]."""

    def __init__(self, progress):
        self.call = progress if callable(progress) else None
        self.shows = bool(progress) and self.call is None
        self.widget = None
        if self.shows and "ipykernel" in sys.modules:
            from IPython.display import ProgressBar
            self.widget = ProgressBar(100)
            self.widget.display()

    def see(self, line):
        found = re.search(r" of \S+(?: s)? \((\d+(?:\.\d+)?) %\)", line)  # other lines have shares of other things
        share = float(found.group(1)) / 100 if found else None
        found = re.search(r" \((\d+) of (\d+)\)$", line)  # of a sweep
        share = int(found.group(1)) / int(found.group(2)) if found else share
        if self.call and share is not None:
            self.call(share)
        elif self.widget is not None and share is not None:
            self.widget.progress = int(100 * share)
        elif self.shows and self.widget is None:
            print(line, file=sys.stderr)


def _execute(words, progress=None):
    """Runs a program; its lines go to the progress. Ctrl-C ends it in order. Returns (exit code, all it said)."""
    bar, said = _Bar(progress), []
    environment = dict(os.environ, **(_ROOT if os.geteuid() == 0 else {}))
    with subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                          env=environment) as process:
        try:
            for line in process.stdout:
                said.append(line)
                bar.see(line.rstrip("\n"))
        except BaseException:  # Ctrl-C, or a failure of the function that is told the progress
            process.terminate()
            process.wait()
            raise
        process.wait()
    return process.returncode, "".join(said)


def run(scene, ranks=None, out=None, progress=False, until=None, force=False, trust_script=False, options=()):
    """What `footfall run` does: the bed, both programs, summary and plots. Returns the Run.

    scene: a Scene, or what makes one; a scene without a file is written next to the folder `out`, as NAME.scene.toml. ranks: of LIGGGHTS.
    out: folder of results (default: a new one in runs). until: earlier end [s]. progress: True shows it, a function gets the share.
    force: into the folder of an earlier run. options: more words of the command line. Raises InputError, NumericalError, PartnerError;
    a run whose requirements are not met is returned (run.exit_code 4)."""
    scene = as_scene(scene)
    ranks = whole_of("ranks", ranks) if ranks is not None else None
    until = number_of("until", until, "a time above zero [s]", above=0.0) if until is not None else None
    options = names_of("options", options, 'a list of words such as ["--view"]')
    out = new_folder(out, scene)
    code, said = _execute(command_of(scene, out, ranks, until, not progress, force, trust_script, options), progress)
    if code in (1, 2, 3):
        raise error_of(code, said)
    return Run(out, code)


def load(folder):
    """The Run or Sweep whose results are in this folder, also of a run in progress."""
    folder = path_of("folder", folder, "the folder of a run or of a sweep")
    if os.path.exists(os.path.join(folder, "history.csv")):
        return Run(folder)
    if os.path.exists(os.path.join(folder, "runs.csv")):
        return Sweep(folder)
    refuse("InputError", "E0433", "no-such-file", f"{folder}: has neither history.csv nor runs.csv, expected the folder of a run or of a sweep")


def _module(name):
    """A module that footfall uses when it is there."""
    try:
        return importlib.import_module(name)
    except ImportError:
        raise ImportError(f"{name} is not installed; install it (Debian: python3-{name}), or use the numpy arrays", name=name) from None


def _html_of(what, folder):
    """The name of a result and its pictures. Each picture is a document of its own, as their identifiers repeat."""
    files = sorted(pathlib.Path(folder).glob("plots/*.svg")) or sorted(pathlib.Path(folder).glob("*.svg"))
    pictures = [base64.b64encode(file.read_bytes()).decode() for file in files]
    return f"<p>{html.escape(repr(what))}</p>" + "".join(f'<img src="data:image/svg+xml;base64,{picture}">' for picture in pictures)


class _Summary(dict):
    """summary.json, its keys also by names of earlier versions."""

    def __init__(self, summary):
        super().__init__((_core.present_name(key), value) for key, value in summary.items())

    def __missing__(self, key):
        present = _core.present_name(key)
        if present == key:
            raise KeyError(key)
        return self[present]


class History(Mapping):
    """Columns of history.csv by name: read-only numpy arrays (rows), SI.

    The file is text: it is read once, when a column is first asked for, and kept; arrays share that memory, none is a copy."""

    def __init__(self, file):
        self.file = file
        self._read = None

    def _all(self):
        if self._read is None:
            self._read = _core.history(self.file)
        return self._read

    def __getitem__(self, name):
        columns, name = self._all()["columns"], _core.present_name(name)
        if name not in columns:
            raise KeyError(f"{name}; known: {', '.join(columns)}")
        return columns[name]

    def __iter__(self):
        return iter(self._all()["columns"])

    def __len__(self):
        return len(self._all()["columns"])

    @property
    def units(self):
        """{name: unit}."""
        return dict(zip(self._all()["columns"], self._all()["units"]))

    def to_pandas(self):
        """A pandas.DataFrame (a copy) with the time as index; attrs["units"] has the units."""
        columns = self._all()["columns"]
        pandas = _module("pandas")
        table = pandas.DataFrame({name: values for name, values in columns.items() if name != "time"},
                                 index=pandas.Index(columns["time"], name="time"))
        table.attrs["units"] = self.units
        return table

    def to_xarray(self):
        """An xarray.Dataset over time, units as attributes."""
        xarray = _module("xarray")
        columns, units = self._all()["columns"], self.units
        data = {name: ("time", values, {"units": units[name]}) for name, values in columns.items() if name != "time"}
        return xarray.Dataset(data, coords={"time": ("time", columns["time"], {"units": "s"})})


class Run:
    """A folder of results."""

    def __init__(self, folder, exit_code=None):
        self.folder = os.fspath(folder)
        self.exit_code = exit_code  # of the program; None of a folder that was loaded
        self.history = History(os.path.join(self.folder, "history.csv"))

    @functools.cached_property
    def summary(self):
        """summary.json (docs/reference/summary.md) as a dict."""
        path = os.path.join(self.folder, "summary.json")
        try:
            with open(path, encoding="utf-8") as file:
                return _Summary(json.load(file))
        except FileNotFoundError:
            refuse("InputError", "E0433", "no-such-file", f"{path}: there is none; the run has not ended")
        except ValueError as error:
            refuse("InputError", "E0684", "summary-damaged", f"{path}:{getattr(error, 'lineno', 1)}: is damaged; repeat the run")

    def __getitem__(self, column):
        return self.history[column]

    def view(self, show=True):
        """Writes view.html, which plays the run in 3D; show: in the browser. Returns its path."""
        code, said = _execute([program(), "view", self.folder])
        if code:
            raise error_of(code, said)
        path = os.path.abspath(os.path.join(self.folder, "view.html"))
        if show:
            webbrowser.open("file://" + path)
        return path

    def plot(self, *columns, file=None, options=()):
        """A picture of columns, as `footfall plot` draws it; without columns those that a run draws. Returns its path (.svg)."""
        columns, options = names_of("columns", columns), names_of("options", options)
        file = file or os.path.join(tempfile.mkdtemp(prefix="footfall-"), "plot.svg")
        code, said = _execute([program(), "plot", self.folder, *columns, "--out", os.fspath(file), *options])
        if code:
            raise error_of(code, said)
        return file

    def _repr_html_(self):
        return _html_of(self, self.folder)

    def __repr__(self):
        try:
            status = self.summary.get("status") if os.path.exists(os.path.join(self.folder, "summary.json")) else "under way"
        except InputError:
            status = "damaged"
        return f"Run({self.folder!r}, {status})"

    def to_pandas(self):
        """History.to_pandas()."""
        return self.history.to_pandas()

    def to_xarray(self):
        """History.to_xarray()."""
        return self.history.to_xarray()


class Sweep:
    """The folder of a sweep: its table of runs, and its runs."""

    def __init__(self, folder, exit_code=None):
        self.folder = os.fspath(folder)
        self.exit_code = exit_code  # 0: all checks of the file are met; None of a folder that was loaded

    @functools.cached_property
    def table(self):
        """runs.csv: {column: numpy array (runs)}, of numbers where all are numbers (empty: NaN), else of text."""
        import csv
        with open(os.path.join(self.folder, "runs.csv"), encoding="utf-8", newline="") as file:
            rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
        if not rows:
            refuse("InputError", "E0684", "summary-damaged", f"{os.path.join(self.folder, 'runs.csv')}:1: has no head; repeat the sweep")
        return {name: _column([row[i] if i < len(row) else "" for row in rows[1:]]) for i, name in enumerate(rows[0])}

    @property
    def runs(self):
        """{name: Run} of the folders that are kept."""
        found = {}
        for name in ("runs", "kept"):
            for history in sorted(pathlib.Path(self.folder, name).glob("*/history.csv")):
                found[history.parent.name] = Run(history.parent)
        return found

    def to_pandas(self):
        """The table as a pandas.DataFrame, one row per run."""
        return _module("pandas").DataFrame(self.table)

    def _repr_html_(self):
        return _html_of(self, self.folder)

    def __repr__(self):
        return f"Sweep({self.folder!r})"


def _column(texts):
    try:
        return numpy.array([float(text) if text else numpy.nan for text in texts])
    except ValueError:
        return numpy.array(texts)


def sweep(file, out=None, jobs=None, progress=False, options=()):
    """What `footfall sweep` does with this file, or with a dict of its keys (its scene: a path). Returns the Sweep. options: more words
    of the command line, such as "--short". Runs that are done already are kept, as from the command line."""
    out = path_of("out", out, "a folder") if out is not None else None
    options = names_of("options", options, 'a list of words such as ["--short"]')
    jobs = whole_of("jobs", jobs) if jobs is not None else None
    if isinstance(file, Mapping):
        from .scene import _text_of
        path = pathlib.Path((out or "sweep") + ".sweep.toml")
        write_text(path, _text_of(file))
        file = path
    file = path_of("file", file, "the file of a sweep, or a dict of its keys")
    out = out if out is not None else os.path.join("runs", "sweeps", pathlib.Path(file).stem)
    words = [program(), "sweep", file, "--out", out]
    words += ["--jobs", str(jobs)] if jobs is not None else []
    code, said = _execute(words + list(options), progress)
    if not os.path.exists(os.path.join(out, "runs.csv")):
        raise error_of(code or 1, said)
    return Sweep(out, code)


__all__ = ["Finding", "History", "Run", "Sweep", "load", "program", "run", "sweep"]
