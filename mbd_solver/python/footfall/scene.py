"""Scenes: files, texts and dicts, with settings."""

import json
import math
import os
import pathlib
from collections.abc import Mapping

import numpy

from . import _core
from .errors import Finding, InputError, path_of, refuse, write_text, wrong_argument


def _toml(value, where):
    """A value as TOML writes it."""
    if isinstance(value, (bool, numpy.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, numpy.integer)):
        return str(int(value))
    if isinstance(value, (float, numpy.floating)):
        value = float(value)
        return repr(value) if math.isfinite(value) else {True: "nan"}.get(math.isnan(value), "inf" if value > 0 else "-inf")
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, os.PathLike):
        return _toml(os.fspath(value), where)
    if isinstance(value, numpy.ndarray):
        return _toml(value.tolist(), where)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_toml(str(k), where)} = {_toml(v, where + '.' + str(k))}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(item, where) for item in value) + "]"
    raise TypeError(f"{where}: {type(value).__name__} has no form in a scene; expected a number, text, list, dict or numpy array")


def _text_of(scene):
    """A dict as the text of a scene, one line per key, so that messages name lines."""
    return "".join(f"{_toml(str(key), '')} = {_toml(value, str(key))}\n" for key, value in scene.items())


class Entry(Mapping):
    """One body, joint, strut ... with all defaults: `entry["mass"]` or `entry.mass`. Lists of numbers are numpy arrays, SI."""

    def __init__(self, values):
        self._values = values

    def __getitem__(self, key):
        value = self._values[key]
        if isinstance(value, list) and value and all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in value):
            return numpy.array(value, dtype=float)
        return Entry(value) if isinstance(value, dict) else value

    def __getattr__(self, key):
        if key.startswith("_") or key not in self._values:
            raise AttributeError(f"there is no key {key!r} here; known: {', '.join(self._values)}")
        return self[key]

    def __iter__(self):
        return iter(self._values)

    def __len__(self):
        return len(self._values)

    def __dir__(self):
        return list(super().__dir__()) + list(self._values)

    def __repr__(self):
        return f"Entry({self._values!r})"


class Entries(Mapping):
    """The bodies, joints, struts ... of a scene by name, in its order."""

    def __init__(self, entries):
        self._entries = {entry.get("name") or entry.get("body") or str(i): Entry(entry) for i, entry in enumerate(entries)}

    def __getitem__(self, name):
        if name not in self._entries:
            raise KeyError(f"{name}; known: {', '.join(self._entries)}")
        return self._entries[name]

    def __iter__(self):
        return iter(self._entries)

    def __len__(self):
        return len(self._entries)

    def __repr__(self):
        return f"Entries({', '.join(self._entries)})"


class Scene:
    """A mechanism, its ground and its start.

    source: a file (.toml) or a folder with scene.toml; or the text of one; or a dict of the same keys, in which numpy arrays are
    lists. folder: to which paths in a text or dict are relative. settings: {"solver.rtol": 1e-7, "bodies.cabin.mass": 400}, as
    set() gives them. Nothing is read before it is needed.
    """

    def __init__(self, source, folder=None, settings=None):
        self.file, self.text = "", ""
        if isinstance(source, Scene):
            self.file, self.text, folder = source.file, source.text, folder or source.folder
        elif isinstance(source, Mapping):
            self.text = _text_of(source)
        elif not isinstance(source, (str, os.PathLike)):
            wrong_argument("source", source, "a scene file or folder, the text of a scene, or a dict of its keys")
        elif isinstance(source, os.PathLike) or ("\n" not in source and "=" not in source) or os.path.exists(source):
            self.file = os.fspath(source)
        else:
            self.text = source
        self.folder = path_of("folder", folder) if folder is not None else os.getcwd()
        if settings is not None and not isinstance(settings, Mapping):
            wrong_argument("settings", settings, 'a dict such as {"solver.rtol": 1e-7}')
        self._begun = False
        self._settings = dict(source._settings) if isinstance(source, Scene) else {}
        self._json = None
        for key, value in (settings or {}).items():
            self.set(key, value)

    def set(self, key, value):
        """Changes one value, as --set does: scene.set("initial.velocity", [0, 0, -5]). Entries of lists are addressed by their
        names: "bodies.cabin.mass". A later value replaces an earlier one of the same key. Returns the scene."""
        if not isinstance(key, str):
            wrong_argument("key", key, 'a text such as "solver.rtol"')
        if self._begun:
            refuse("InputError", "E0728", "wrong-argument", f"{key} cannot change in a simulation that has begun: set it in a copy, "
                   "sim.scene.copy(), for a simulation of its own; what changes within a run is a signal")
        self._settings.pop(key, None)
        self._settings[key] = _toml(value, key)
        self._json = None
        return self

    def copy(self):
        """Another scene of the same source and settings."""
        return Scene(self)

    @property
    def settings(self):
        """As --set takes them: a list of "key=value"."""
        return [f"{key}={value}" for key, value in self._settings.items()]

    @property
    def _source(self):
        return _core.Source(self.file, self.text, self.folder, self.settings)

    def check(self):
        """All errors of the scene, or all warnings of a scene without errors: a list of Finding."""
        return [Finding(*finding) for finding in self._source.check()]

    @property
    def values(self):
        """The whole scene with all defaults, as `footfall` reads it: dicts, lists, numbers. Raises InputError."""
        if self._json is None:
            self._json = json.loads(self._source.json())
        return self._json

    def get(self, key):
        """The value of a key such as "solver.rtol" or "bodies.cabin.mass", with its default if it is not given."""
        if not isinstance(key, str):
            wrong_argument("key", key, 'a text such as "solver.rtol"')
        value = self.values
        for part in key.split("."):
            if isinstance(value, list):
                value = Entries(value)
            if not isinstance(value, Mapping) or part not in value:
                raise KeyError(f"{key}: there is no {part!r}; known: {', '.join(value) if isinstance(value, Mapping) else 'nothing'}")
            value = value[part]
        return value

    def _entries(self, key):
        return Entries(self.values.get(key) or [])

    @property
    def bodies(self):
        """By name; keys as in a scene: mass [kg], position [m] (3), inertia [kg m2] (3 or 3 x 3) ..."""
        return self._entries("bodies")

    @property
    def joints(self):
        """By name."""
        return self._entries("joints")

    @property
    def struts(self):
        """By name."""
        return self._entries("struts")

    @property
    def springs(self):
        """By name."""
        return self._entries("springs")

    @property
    def forces(self):
        """By name."""
        return self._entries("forces")

    @property
    def signals(self):
        """By name."""
        return self._entries("signals")

    @property
    def has_grains(self):
        """Whether LIGGGHTS moves grains in it."""
        return self.values.get("ground", {}).get("kind") == "particles"

    def _as_file(self, out):
        """A file of this scene, for programs: its own, or a copy next to the folder of results."""
        if self.file:
            return self.file
        path = pathlib.Path(self.folder) / (pathlib.Path(out).name + ".scene.toml")
        write_text(path, self.text)
        return os.fspath(path)

    def __repr__(self):
        return f"Scene({self.file or 'text'!r}{''.join(', ' + s for s in self.settings)})"


def as_scene(scene):
    """A scene of what Scene() takes."""
    return scene if isinstance(scene, Scene) else Scene(scene)


__all__ = ["Entries", "Entry", "InputError", "Scene", "as_scene"]
