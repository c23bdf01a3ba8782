"""Errors and findings: each has its code, place and advice, as docs/reference/messages.md describes messages."""

import functools
import math
import operator
import os
import pathlib
from typing import NamedTuple


@functools.lru_cache(maxsize=None)
def _advice():
    """From code to its meaning and remedy, of docs/reference/codes.txt."""
    page = pathlib.Path(__file__).with_name("codes.txt")
    lines = page.read_text(encoding="utf-8").splitlines() if page.exists() else []
    return {line[:5]: line.split(": ", 1)[1] for line in lines if line[:1] in "EW" and ": " in line}


class Finding(NamedTuple):
    """One thing that is wrong with an input, or strange."""

    severity: str  # "error" or "warning"
    code: str      # "E0123"; empty without one
    name: str      # "unknown-body"
    file: str      # empty where none is named
    line: int      # 0 where none is named; -1: of a setting
    key: str       # of the scene: "joints.axle.bodies"
    text: str      # what is wrong, what was expected, what to do
    message: str   # all of it in one line

    @property
    def advice(self):
        """Meaning and remedy of the code."""
        return _advice().get(self.code, "")

    def __str__(self):
        return self.message


class Error(Exception):
    """What footfall refuses or fails at. `findings` has all of it; the attributes below belong to the first finding."""

    def __init__(self, message, findings=()):
        super().__init__(message)
        self.findings = list(findings)

    def __getattr__(self, name):
        if name in ("code", "name", "file", "line", "key", "text", "advice"):
            findings = self.__dict__.get("findings")
            return getattr(findings[0], name) if findings else (0 if name == "line" else "")
        raise AttributeError(name)


class InputError(Error, ValueError):
    """The user can correct it (exit code 2 of the command line)."""


class ArgumentError(InputError, TypeError):
    """An argument of a call is of another type than expected, or outside of its range."""


class NumericalError(Error, ArithmeticError):
    """A solver failed; the message has time and body or joint (exit code 1)."""


class PartnerError(Error, RuntimeError):
    """Another program of the run ended, failed or was interrupted."""


class FileError(Error, OSError):
    """A file of a run cannot be written."""


class InternalError(Error, RuntimeError):
    """A fault of footfall."""


def made(kind, message, findings):
    """The exception of this kind; findings: tuples in the order of Finding."""
    return globals()[kind](message, [Finding(*finding) for finding in findings])


def refuse(kind, code, name, text):
    """Raises the exception of this kind with one finding."""
    message = f"{text} [{code} {name}]"
    raise made(kind, message, [("error", code, name, "", 0, "", text, message)])


def wrong_argument(name, value, expected):
    """Raises ArgumentError."""
    shown = repr(value)
    shown = shown if len(shown) <= 60 else shown[:57] + "..."
    refuse("ArgumentError", "E0728", "wrong-argument", f"{name} is {shown} ({type(value).__name__}), expected {expected}")


def number_of(name, value, expected="a number", above=-math.inf, finite=False):
    """The value as a float; `above`: it must be larger."""
    try:
        number = float(value) if not isinstance(value, (str, bytes, bool)) else None
    except (TypeError, ValueError, OverflowError):
        number = None
    if number is None or (above > -math.inf and not number > above) or (finite and not math.isfinite(number)):
        wrong_argument(name, value, expected)
    return number


def whole_of(name, value, least=1):
    """The value as an int."""
    try:
        whole = operator.index(value) if not isinstance(value, bool) else None
    except TypeError:
        whole = None
    if whole is None or whole < least:
        wrong_argument(name, value, f"a whole number from {least} on")
    return whole


def write_text(path, text):
    """The file with this text."""
    try:
        pathlib.Path(path).write_text(text, encoding="utf-8")
    except OSError as error:
        refuse("FileError", "E0401", "file-not-written", f"{path}: cannot be written: {error.strerror}; choose another folder")


def path_of(name, value, expected="a path"):
    """The value as the text of a path."""
    if not isinstance(value, (str, os.PathLike)) or not os.fspath(value):
        wrong_argument(name, value, expected)
    return os.fspath(value)


def names_of(name, value, expected="a list of names"):
    """A list of texts; one text is a list of one."""
    names = [value] if isinstance(value, str) else None
    if names is None:
        try:
            names = list(value)
        except TypeError:
            wrong_argument(name, value, expected)
    for each in names:
        if not isinstance(each, str):
            wrong_argument(name, value, expected)
    return [str(each) for each in names]
