"""The process of a signal of kind "python".

It answers the questions of mbd_solver (mbd_solver/assemble/foreign_block.h): frames on standard input and output, 8 bytes of length and then a
letter with numbers or bytes. The first question is the task: FILE, FUNCTION, STATELESS (1: yes) and the number of inputs. It imports FILE; what that
prints goes to standard error.

FILE has FUNCTION(time, *inputs), which returns a number, and where it keeps anything between calls also
    begin()          the signal starts, or starts anew in a state of the scene
    save()           what restore() needs to continue: numbers, texts, lists and dicts
    restore(saved)   continues, in a new process
"""
import importlib.util
import json
import os
import struct
import sys
import traceback


def frames(stream):
    """The questions, until the input ends."""
    while len(length := stream.read(8)) == 8:
        yield stream.read(struct.unpack("=Q", length)[0])


def numbers(data):
    return struct.unpack(f"={len(data) // 8}d", data)


class Script:
    def __init__(self, file, function, stateless, inputs):
        sys.path.insert(0, os.path.dirname(os.path.abspath(file)))
        spec = importlib.util.spec_from_file_location("signal_script", file)
        self.module = importlib.util.module_from_spec(spec)
        sys.modules["signal_script"] = self.module
        spec.loader.exec_module(self.module)
        self.call = getattr(self.module, function, None)
        if not callable(self.call):
            known = [name for name, value in vars(self.module).items() if callable(value) and not name.startswith("_")]
            raise NameError(f'{file} has no function "{function}"; it has: {", ".join(known) or "none"}')
        self.stateless, self.inputs = stateless, inputs

    def answer(self, letter, data):
        if letter == b"I":
            getattr(self.module, "begin", lambda: None)()
            return b"V" + struct.pack("=d", 0.0)
        if letter == b"S":
            time, _, *inputs = numbers(data)
            return b"V" + struct.pack("=d", float(self.call(time, *inputs)))
        if letter == b"G":
            if hasattr(self.module, "save") and hasattr(self.module, "restore"):
                return b"B" + json.dumps(self.module.save()).encode()
            if self.stateless:
                return b"B"
            return b"Nthe file has no functions save() and restore(saved); add them, or stateless = true to the signal if it keeps nothing"
        if letter == b"R":
            saved = data[8 * (1 + self.inputs):]
            if saved:
                self.module.restore(json.loads(saved))
            return b"V" + struct.pack("=d", 0.0)
        raise ValueError(f"unknown question {letter!r}")


def main():
    questions, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    script = None
    for question in frames(questions):
        try:
            if question[:1] == b"T":
                file, function, stateless, inputs = os.fsdecode(question[1:]).split("\0")
                script = Script(file, function, stateless == "1", int(inputs))
                answer = b"V"
            else:
                answer = script.answer(question[:1], question[1:])
        except BaseException as error:  # SystemExit, too
            where = traceback.extract_tb(error.__traceback__)[-1]
            answer = f"E{type(error).__name__}: {error} ({where.filename}:{where.lineno})".encode()
        answers.write(struct.pack("=Q", len(answer)) + answer)
        answers.flush()


main()
