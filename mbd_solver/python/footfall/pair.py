"""The coupled pair, led from Python: `footfall run` with a socket on which mbd_solver asks what to do (mbd_solver/session/leader.h)."""

import contextlib
import json
import os
import shutil
import socket
import subprocess
import tempfile
import threading

import numpy

from . import _core
from .errors import Finding, InputError, PartnerError, made
from .runs import command_of, error_of, new_folder

_LOOK = 0.2            # for a program that has ended [s]
_PATIENCE = 7 * 86400  # of LIGGGHTS while Python thinks, unless the scene gives coupling.timeout [s]


class Pair:
    """What simulation.Simulation calls, for a scene with grains."""

    def __init__(self, scene, ranks, out, trust_script=False):
        self.out = new_folder(out, scene)
        scene = scene.copy()
        if not any(setting.startswith("coupling.timeout=") for setting in scene.settings):
            scene.set("coupling.timeout", _PATIENCE)
        self._folder = tempfile.mkdtemp(prefix="footfall-")
        self._socket = self._process = self._log = None
        self._use = threading.Lock()  # of the conversation: nobody waits for it
        self._received = b""
        self.energy_balance = float("nan")
        try:
            path = os.path.join(self._folder, "lead")
            listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            listener.bind(path)
            listener.listen(1)
            listener.settimeout(_LOOK)
            self._log = open(os.path.join(self._folder, "log"), "w+b")
            self._process = subprocess.Popen(command_of(scene, self.out, ranks, quiet=True, trust_script=trust_script), stdin=subprocess.DEVNULL, stdout=self._log,
                                             stderr=self._log, env=dict(os.environ, FOOTFALL_LEADER=path), start_new_session=True)
            while self._socket is None:
                try:
                    self._socket = listener.accept()[0]
                except socket.timeout:
                    self._require_alive()
            listener.close()
            self._socket.settimeout(_LOOK)
            hello = json.loads(self._line())
            self.names, self.units, self.end_time = hello["columns"], hello["units"], hello["end_time"]
            self._signals = dict(hello["signals"])
            self._places = {name: i for i, name in enumerate(self.names)}
            self._read_row()
        except BaseException:
            self.close()
            raise

    # ---- the conversation ----

    def _said(self):
        if self._log.closed:
            return self._last_words
        with open(self._log.name, encoding="utf-8", errors="replace") as log:
            return log.read()

    def _require_alive(self):
        if self._process.poll() is not None:
            raise error_of(self._process.returncode, self._said())

    def _line(self):
        while b"\n" not in self._received:
            try:
                more = self._socket.recv(1 << 16)
            except socket.timeout:
                self._require_alive()
                continue
            except OSError:
                more = b""
            if not more:
                self._process.wait()
                raise error_of(self._process.returncode, self._said())
            self._received += more
        line, self._received = self._received.split(b"\n", 1)
        return line.decode()

    def _say(self, line):
        if self._socket is None:
            raise PartnerError("the simulation has been closed")
        try:
            self._socket.sendall(line.encode() + b"\n")
        except OSError:
            self._process.wait()
            raise error_of(self._process.returncode, self._said()) from None

    def _read_row(self):
        saved = None
        while True:
            line = self._line()
            if line.startswith("saved "):
                saved = line[6:]
            elif line.startswith("balance "):
                self.energy_balance = float(line.split()[1])
            elif line.startswith("row "):
                self.row = numpy.array(line.split()[1:], dtype=float)
                self.time = float(self.row[0])
                return saved

    @contextlib.contextmanager
    def _alone(self):
        if not self._use.acquire(blocking=False):
            raise _refused("E0729", "in-use", "the simulation is being stepped by another thread, or in a call that has not ended; "
                                              "wait for its end, or make a simulation for each thread")
        try:
            yield
        finally:
            self._use.release()

    # ---- as _core.Simulation ----

    @property
    def finished(self):
        return self.time >= self.end_time * (1 - 1e-12)

    def step(self, until):
        with self._alone():
            self._step(until)

    def _step(self, until):
        if self.finished:
            raise _refused("E0722", "cannot-go-on", "the end of the scene has been reached; set a later end_time")
        if not until >= self.time:
            raise _refused("E0721", "step-backwards", f"t = {self.time:g} s: the requested step to {until:g} s lies in the past, expected a later time")
        self._say(f"step {float(until)!r}")
        self._read_row()

    def sample(self, until, every, names):
        places = [self._place(name) for name in names]
        with self._alone():
            rows, begin, end = [self.row[places]], self.time, min(until, self.end_time)
            while self.time < end * (1 - 1e-12):
                self._step(min(begin + len(rows) * every, end))
                rows.append(self.row[places])
        return numpy.array(rows)

    def _place(self, name):
        if name not in self._places:
            raise _refused("E0681", "no-such-column", f'there is no column "{name}"; known: {", ".join(self.names)}')
        return self._places[name]

    def value(self, name):
        return float(self.row[self._place(name)])

    @property
    def signals(self):
        return list(self._signals)

    def signal(self, name):
        if name not in self._signals:
            raise _refused("E0723", "no-host-signal", f'there is no signal "{name}" of kind "host"; known: {", ".join(self._signals) or "none"}')
        return self._signals[name]

    def set_signal(self, name, value):
        self.signal(name)
        if not numpy.isfinite(value):
            raise _refused("E0724", "given-not-finite", f'signal "{name}" was set to {value}, expected a finite number')
        with self._alone():
            self._signals[name] = value
            self._say(f"set {name} {value!r}")

    def save(self):
        with self._alone():
            self._say("save")
            return self._read_row()

    def restore(self, state):
        raise InputError("a simulation with grains cannot go back; resume its folder: footfall run --resume " + str(state))

    def _no_state(self):
        raise InputError("the state of a mechanism on grains stays in its own process; read columns instead")

    q = v = z = property(_no_state)

    def _summary(self):
        path = os.path.join(self.out, "summary.json")
        if not os.path.exists(path):
            raise InputError("the summary of a run with grains is written at its end; close() the simulation first")
        with open(path, encoding="utf-8") as file:
            return json.load(file)

    @property
    def warnings(self):
        return [line.split("warning: ", 1)[1] for line in self._said().splitlines() if "warning: " in line]

    @property
    def notes(self):
        return [line.split("note: ", 1)[1] for line in self._said().splitlines() if "note: " in line]

    def summary(self):
        return json.dumps(self._summary())

    def close(self):
        """Ends the run in order: with a checkpoint, unless it is done."""
        if self._process is not None and self._process.poll() is None:
            if self._socket is not None:
                try:
                    self._socket.sendall(b"end\n")
                except OSError:
                    pass
            else:
                self._process.terminate()
            try:
                self._process.wait(30)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        if self._socket is not None:
            self._socket.close()
            self._socket = None
        if self._log is not None and not self._log.closed:
            self._last_words = self._said()
            self._log.close()
        shutil.rmtree(self._folder, ignore_errors=True)

    def __del__(self):
        self.close()


def _refused(code, name, text):
    return made("InputError", f"{text} [{code} {name}]", [Finding("error", code, name, "", 0, "", text, f"{text} [{code} {name}]")])


__all__ = ["Pair", "_core"]
