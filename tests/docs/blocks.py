#!/usr/bin/env python3
"""Runs every command block of a page, shortened, as a reader would run it from the checkout.

    blocks.py FOOTFALL OUT PAGE [--only-lint]

FOOTFALL is the built program, PAGE a path in the checkout. OUT becomes a folder that looks like a checkout. A command block begins with ```sh. Comments before a
block control the test and are invisible on the page:

    <!-- short: OPTIONS -->   options appended to `run` (default: --until 0.02, or less) and to `calibrate`
    <!-- exit: CODE -->       exit code of the last command of the block (default: 0)
    <!-- file: NAME -->       the block is the text of this file, which is written before the next commands
    <!-- append: NAME -->     the block is appended to this file
    <!-- edit: NAME | from WORDS -->  the block replaces the file from the first line that begins with WORDS to its end; `above WORDS`: it is inserted above that line
    <!-- shorten: NAME | REGEX | TEXT -->  a replacement in a file of the page, for the test only; may stand anywhere
    <!-- says -->             each line of the block is in the output of the last commands; ... matches any text
    <!-- needs: WORDS -->     the block, without sh, is not run: not every machine has what it needs
    <!-- pair: NAME -->       at the end of a row of a table, behind `LINE`: this line is in the output for the case NAME of tests/app/bad_input
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys

kRoot = pathlib.Path(__file__).resolve().parents[2]
kOthers = {"mpirun", "python3", "mkdir", "cp", "cat", "ls", "sed", "diff"}  # and programs of the checkout, by their path
kSeconds = 280   # time limit of one command [s]
kUntil = "0.02"  # of a scene [s]
kWatched = 10    # of a command that follows a run [s]


class Block:
    def __init__(self, line, language, marks, lines):
        self.line, self.language, self.marks, self.lines = line, language, marks, lines


def blocks_of(text):
    """The fenced blocks of a page with the comments that stand right before them."""
    found, marks, lines = [], {}, text.split("\n")
    i = 0
    while i < len(lines):
        fence = re.match(r"^(\s*)```(\w*)\s*$", lines[i])
        mark = re.match(r"^\s*<!-- (short|exit|file|append|edit|shorten|says|needs)(?:: (.*?))? -->\s*$", lines[i])
        row = re.match(r"^\|.* `([^`]+)` <!-- pair: (\S+) --> \|$", lines[i])
        if row:
            found.append(Block(i + 1, "", {"pair": row.group(2)}, [row.group(1)]))
        elif mark and mark.group(1) == "shorten":
            found.append(Block(i + 1, "", {"shorten": mark.group(2)}, []))
        elif mark:
            marks[mark.group(1)] = mark.group(2) or ""
        elif fence:
            end = next(k for k in range(i + 1, len(lines)) if lines[k].strip() == "```")
            found.append(Block(i + 1, fence.group(2), marks, lines[i + 1:end]))
            i, marks = end, {}
        elif lines[i].strip():
            marks = {}
        i += 1
    return found


def commands_of(block):
    """The lines of a command block; a \\ at the end of a line continues it in the next."""
    text = "\n".join(block.lines).replace("\\\n", " ")
    return [line for line in (re.sub(r"(^|\s)#.*$", "", one).strip() for one in text.split("\n")) if line]


def lint(page, text):
    """Every command that a reader would copy is in a block that is run."""
    wrong = []
    for block in blocks_of(text):
        for line in block.lines:
            if block.language != "sh" and "says" not in block.marks and "needs" not in block.marks \
                    and re.match(r"\s*(\./footfall|\(cd \S+ && \.\./footfall|footfall (run|check|view|plot|sweep|rig) |mpirun|build/bin/)", line) \
                    and " ... " not in line:
                wrong.append(f"{page}:{block.line}: \"{line.strip()}\" is in a block that no test runs; begin the block with ```sh")
    plain = re.sub(r"(?ms)^```.*?^```$", "", text)
    for line in re.findall(r"(?m)^(?:    |\t)\s*(?:\./)?footfall .*$", plain):
        wrong.append(f"{page}: \"{line.strip()}\" is indented; put it into a block that begins with ```sh")
    return wrong


def shortened(words, block):
    command = words[1]
    if command == "run" and "--resume" not in words:
        if "short" in block.marks:
            return words + shlex.split(block.marks["short"])
        if "--until" not in words:
            return words + ["--until", kUntil]
        at = words.index("--until") + 1
        return words[:at] + [min(words[at], kUntil, key=float)] + words[at + 1:]
    if command in ("sweep", "accuracy", "rig", "ground"):
        return words + ["--short"]
    if command == "calibrate" and "short" in block.marks:
        return words + shlex.split(block.marks["short"])
    return ["./footfall", "test", "--help"] if command == "test" else words


class Page:
    def __init__(self, footfall, out, page):
        self.footfall, self.folder, self.page = footfall, out, page
        listed = subprocess.run([footfall, "--help"], capture_output=True, text=True, check=True).stdout
        self.known = set(re.findall(r"(?m)^  ([a-z]+)\s", listed.split("Subcommands:")[1]))
        self.output, self.failed, self.ran = "", [], 0

    def prepare(self):
        subprocess.run(["rm", "-rf", str(self.folder)], check=True)
        self.folder.mkdir(parents=True)
        for name in ("inputs", "examples", "docs"):  # copies: what a block writes into them stays here
            subprocess.run(["cp", "-r", str(kRoot / name), str(self.folder)], check=True)
        (self.folder / "build").symlink_to(self.footfall.parent.parent)
        door = self.folder / "footfall"
        door.write_text(f"#!/bin/sh\nexec {shlex.quote(str(self.footfall))} \"$@\"\n")
        door.chmod(0o755)

    def complain(self, block, what):
        self.failed.append(f"{self.page}:{block.line}: {what}")

    def run(self, block):
        lines = commands_of(block)
        subcommands = re.findall(r"(?m)^(?:\(cd \S+ && \.)?\./footfall (\S+)", "\n".join(lines))
        for missing in [s for s in subcommands if s not in self.known and not s.startswith("-")]:
            self.complain(block, f"footfall {missing}: there is no such command")
            return
        self.output = ""
        for k, line in enumerate(lines):
            watched, folder = False, self.folder
            if line.startswith("cp -r /usr/share/doc/liggghts/") and not pathlib.Path(shlex.split(line)[2]).exists():
                print("the package liggghts-doc is missing: page left out")
                sys.exit(0)
            if inside := re.match(r"\(cd (\S+) && (.*)\)$", line):  # (cd FOLDER && ../footfall ...)
                folder, line = folder / inside.group(1), inside.group(2).replace("../footfall ", "./footfall ", 1)
            words = shlex.split(line)
            if words[0] == "./footfall":
                watched = "--follow" in words and "--once" not in words
                line = " ".join(shlex.quote(w) for w in [str(self.folder / "footfall"), *shortened(words, block)[1:]])
            elif words[0] not in kOthers and not ("/" in words[0] and (self.folder / words[0]).is_file()):
                self.complain(block, f"{words[0]}: this test does not know the command")
                return
            wanted = int(block.marks.get("exit", 0)) if k + 1 == len(lines) else 0
            print(f"+ {line}", flush=True)
            done = subprocess.run(["timeout", "-k", "5", str(kWatched if watched else kSeconds), "bash", "-c", line],
                                  cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True)
            self.output += done.stdout + done.stderr
            self.ran += 1
            if done.returncode != wanted and not (watched and done.returncode == 124):
                print(done.stdout[-3000:] + done.stderr[-3000:])
                self.complain(block, f"`{line}` ended with {done.returncode}, expected {wanted}")
                return

    def run_pair_of(self, name):
        """A case of tests/app/bad_input, run by its own test; the page calls its files scene.toml and in.script."""
        tables = [table.stem for table in (kRoot / "tests/app/bad_input").glob("*.txt")]
        cases = ":".join(f"*.IsFoundAndNamed/{table}_{name}" for table in tables)
        done = subprocess.run([str(self.footfall.parent / "app_check"), f"--gtest_filter={cases}"],
                              capture_output=True, text=True, env={**os.environ, "FOOTFALL_SHOW": "1"})
        self.output = re.sub(r"\bcase\.toml\b", "scene.toml", done.stdout).replace("case.in:", "in.script:")
        return done.returncode == 0 and "[       OK ]" in done.stdout

    def check_output(self, block):
        said = self.output.replace(str(self.folder) + "/", "")
        self.ran += 1
        for line in block.lines:
            pattern = ".*".join(re.escape(part) for part in line.strip().split("..."))
            if not re.search(pattern, said):
                self.complain(block, f"missing in the output: {line.strip()}\nThe output:\n{said[-3000:]}")

    def edit(self, block):
        """Puts a block into a file where a reader would put it by hand, or replaces what the test has no time for."""
        mark = "edit" if "edit" in block.marks else "shorten"
        name, *how = (part.strip() for part in block.marks[mark].split(" | "))
        file = self.folder / name
        lines = file.read_text().split("\n")
        if mark == "shorten":
            text, count = re.subn(how[0], how[1], "\n".join(lines))
            file.write_text(text)
        else:
            where, words = how[0].split(" ", 1)
            at = [k for k, line in enumerate(lines) if line.startswith(words)]
            count = len(at)
            if at:
                lines[at[0]:] = block.lines + ([""] if where == "from" else lines[at[0]:])
                file.write_text("\n".join(lines))
        if count == 0:
            self.complain(block, f"{name}: nothing there is {how[0]}")

    def go(self, text):
        self.prepare()
        for block in blocks_of(text):
            if "file" in block.marks:
                file = self.folder / block.marks["file"]
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text("\n".join(block.lines) + "\n")
            elif "append" in block.marks:
                with (self.folder / block.marks["append"]).open("a") as file:
                    file.write("\n" + "\n".join(block.lines) + "\n")
            elif "edit" in block.marks or "shorten" in block.marks:
                self.edit(block)
            elif "pair" in block.marks:
                if not self.run_pair_of(block.marks["pair"]):
                    self.complain(block, f"the pair {block.marks['pair']} fails: {self.output}")
                self.check_output(block)
            elif "says" in block.marks:
                self.check_output(block)
            elif block.language == "sh":
                self.run(block)
            if self.failed:
                break  # later blocks stand on this one
        if self.ran == 0:
            self.failed.append(f"{self.page}: no block was run")


def main():
    words = [w for w in sys.argv[1:] if not w.startswith("--")]
    if "--only-lint" in sys.argv:
        pages = [kRoot / "README.md", *sorted((kRoot / "docs").rglob("*.md")), *sorted((kRoot / "examples").rglob("*.md"))]
        failed = [w for p in pages for w in lint(p.relative_to(kRoot), p.read_text())]
        # A reader follows several pages in one checkout: a second run into a folder of results is refused.
        users = {}
        for page in pages:
            for folder in set(re.findall(r"\brun .*--out (\S+)", "\n".join(line for b in blocks_of(page.read_text()) if b.language == "sh" for line in b.lines))):
                users.setdefault(folder, []).append(str(page.relative_to(kRoot)))
        failed += [f"{' and '.join(names)}: write to {folder}" for folder, names in users.items() if len(names) > 1]
    else:
        page = Page(pathlib.Path(words[0]).resolve(), pathlib.Path(words[1]).resolve(), words[2])
        page.go((kRoot / words[2]).read_text())
        failed = page.failed
        print(f"{page.ran} commands and messages")
    for one in failed:
        print("FAILED:", one)
    return 1 if failed else 0


sys.exit(main())
