"""A scene that Python leads step by step: the mechanism in this process, or the coupled pair with its grains."""

import json
from typing import NamedTuple

import numpy

from . import _core
from .errors import names_of, number_of, refuse, whole_of, wrong_argument
from .scene import as_scene

_MOST_ROWS = 10**8  # of sample()


class State(NamedTuple):
    """What is integrated (theory 2.1)."""

    time: float       # [s]
    q: numpy.ndarray  # positions [m] and unit quaternions [-] of bodies, modal coordinates
    v: numpy.ndarray  # velocities [m/s], angular velocities [rad/s] in the body's frame, modal velocities
    z: numpy.ndarray  # inner states of struts, drives and continuous signals


def _vector_of(name, given):
    try:
        vector = numpy.asarray(given, dtype=float)
    except (TypeError, ValueError):
        vector = numpy.empty((0, 0))
    if vector.ndim != 1:
        wrong_argument(name, given, "one row of numbers, as state has it")
    return vector


class Simulation:
    """One scene, led step by step.

    scene: a Scene, or what makes one. record: keeps the peaks of all steps, which summary() needs; a step takes longer then.
    Without grains the mechanism is integrated in this process, in the digits of `footfall run` where steps end at its rows.
    trust_script: FMUs and Python files that the scene names may run.
    With grains the programs of `footfall run` are started on `ranks` ranks and write the folder `out` (default: a new one in runs);
    use `with`, which ends them. Objects share nothing; one of them serves one thread at a time,
    and refuses calls of others meanwhile (E0729).
    """

    def __init__(self, scene, ranks=None, out=None, record=False, trust_script=False):
        self.scene = scene = as_scene(scene).copy()
        scene._begun = True
        if ranks is not None:
            ranks = whole_of("ranks", ranks)
        if scene.has_grains:
            from .pair import Pair
            self._core = Pair(scene, ranks, out, trust_script)
        elif ranks is not None or out is not None:
            refuse("InputError", "E0728", "wrong-argument",
                   "ranks and out belong to scenes with grains; this one is integrated in this process and writes no files")
        else:
            self._core = _core.Simulation(scene._source, record, trust_script)
        self._names = self._core.names
        self._closed = False

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.close()

    def close(self):
        """Ends the simulation, with grains also the programs. Nothing but the columns can be read any more."""
        self._closed = True
        if hasattr(self._core, "close"):
            self._core.close()

    def _led(self):
        if self._closed:
            refuse("InputError", "E0722", "cannot-go-on", "the simulation has been closed; make a new one")
        return self._core

    # ---- time ----

    @property
    def time(self):
        """Present time [s]."""
        return self._core.time

    @property
    def end_time(self):
        """end_time of the scene [s]."""
        return self._core.end_time

    @property
    def finished(self):
        """Whether the end of the scene has been reached."""
        return self._core.finished

    def step(self, until):
        """Goes on to the time `until` [s], at most to the end of the scene. With grains to the end of the DEM step in which it lies.
        Raises NumericalError; columns and state are those before the step then, and only restore() lets the simulation go on."""
        self._led().step(number_of("until", until, "a time [s]"))

    def sample(self, until, every, columns=None):
        """Goes on to `until` [s] and reads columns now, then every `every` [s] and at `until`. columns: names, default all.
        Returns {name: numpy array (rows)}; a column "time" is always there."""
        names = names_of("columns", columns if columns is not None else self._names, "names of columns")
        until = number_of("until", until, "a time [s]", finite=True)
        every = number_of("every", every, "a time above zero [s]", above=0.0)
        if until < self.time:
            self._led().step(until)
        if (until - self.time) / every > _MOST_ROWS:
            wrong_argument("every", every, f"a time [s] that gives at most {_MOST_ROWS} rows")
        if "time" not in names:
            names.insert(0, "time")
        rows = self._led().sample(until, every, names)
        return {name: rows[:, i].copy() for i, name in enumerate(names)}

    # ---- what is measured ----

    @property
    def names(self):
        """Names of the columns of history.csv (docs/reference/history.md); the first is time."""
        return list(self._names)

    @property
    def units(self):
        """{name: unit} of the columns, SI; "-" of plain numbers."""
        return dict(zip(self._names, self._core.units))

    @property
    def row(self):
        """All columns now: a numpy array (columns) in the order of names."""
        return self._core.row

    @property
    def columns(self):
        """All columns now: {name: float}."""
        return dict(zip(self._names, self._core.row.tolist()))

    def __getitem__(self, name):
        """One column now: sim["cabin.az"] is a float, sim[["cabin.x", "cabin.z"]] a numpy array (2)."""
        if isinstance(name, str):
            return self._core.value(name)
        return numpy.array([self._core.value(each) for each in names_of("column", name, "the name of a column, or a list of names")])

    @property
    def state(self):
        """State of the mechanism now, as it is integrated."""
        return State(self._core.time, self._core.q, self._core.v, self._core.z)

    # ---- what is set ----

    @property
    def signals(self):
        """{name: last value} of the signals of kind "host"."""
        return {name: self._core.signal(name) for name in self._core.signals}

    def set_signal(self, name, value):
        """A signal of kind "host" has this value from now on, until it is set again."""
        if not isinstance(name, str):
            wrong_argument("name", name, "the name of a signal")
        self._led().set_signal(name, number_of(f'value of signal "{name}"', value))

    def set_state(self, q=None, v=None):
        """Other positions and velocities from now on, arrays as in `state`; None: as they are. Inner states stay. Quaternions are
        normalized, and joints are closed by the smallest change of both: read `state` for the result. The energy that this gives or
        takes is no error of energy_balance. Raises InputError for another size or numbers that are not finite, NumericalError if
        joints cannot be closed; nothing has changed then. Not with grains, which would be pushed."""
        if self.scene.has_grains:
            refuse("InputError", "E0728", "wrong-argument", "the state cannot be set in a scene with grains, which would be pushed; "
                   "give it as the start of a new simulation: initial.joints, initial.position, initial.velocity")
        core = self._led()
        core.place(*(now if given is None else _vector_of(name, given)
                     for name, given, now in (("q", q, core.q), ("v", v, core.v))))

    # ---- saved states ----

    def save(self):
        """The whole state, as bytes that restore() takes in any process with this version, scene and settings. The simulation goes
        on as one that restores it, in the same digits. With grains: writes a checkpoint at the end of the next window, and returns
        its folder."""
        return self._led().save()

    def restore(self, state):
        """Returns to a state of save(). Not with grains: resume the folder of results instead."""
        if not isinstance(state, bytes) and not self.scene.has_grains:
            wrong_argument("state", state, "bytes of save()")
        self._led().restore(state)

    # ---- how good it is ----

    @property
    def energy_balance(self):
        """Relative error of the energy balance so far [-]."""
        return self._core.energy_balance

    @property
    def warnings(self):
        """Warnings so far, each with its code."""
        return list(self._core.warnings)

    @property
    def notes(self):
        """What was adjusted at the start."""
        return list(self._core.notes)

    def summary(self):
        """What summary.json of a run would say now, as a dict; needs record=True."""
        return json.loads(self._core.summary())

    def __repr__(self):
        return f"Simulation({self.scene!r}, time={self._core.time:g})"
