#!/usr/bin/env python3
"""sources.py: rules of the sources that no compiler checks. Each function below is one rule."""
import os
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
TOPS = ("coupler", "liggghts_fix", "mbd_solver")
MOST_LINES = 900          # of a .cpp
MOST_FILES = 40           # of a folder
SPECIMENS = "tests/unit/dynamics/random_model.h"
HTML_PAGES = ("mbd_solver/app/report.cpp", "mbd_solver/app/view_page.cpp")
GNUPLOT = r"set terminal|set output|with lines"  # in sources that write its scripts
# What hands a text to a shell: the replacement that refuses it to scripts.
SHELL_FILES = ("liggghts_fix/replaced/popen.cpp",)
# Where programs and copies of a process begin.
CHILD_PROCESS = "mbd_solver/base/child_process.cpp"
# Who reads files and lines by itself, and why.
OWN_READERS = {
    "mbd_solver/base/text_reader.h": "the reader",
    "coupler/base/files.cpp": "whole files",
    "mbd_solver/app/live/history_tail.cpp": "the end of a file that grows",
    "mbd_solver/base/child_watch.cpp": "/proc",
    "mbd_solver/base/lock.cpp": "/proc, and a number in the lock file",
    "mbd_solver/campaign/calibrate/evaluations.cpp": "lines of a text in memory, the last of which may be incomplete",
}
LIBRARIES = ("coupler", "mbd_solver/base", "mbd_solver/model", "mbd_solver/fe", "mbd_solver/dynamics", "mbd_solver/integrator", "mbd_solver/scene",
             "mbd_solver/assemble", "mbd_solver/coupling", "mbd_solver/session")
SWEEP_SCRIPTS = "mbd_solver/studies"
failed = False


def complain(text):
    global failed
    failed = True
    print(text)


def found(rule, what, least):
    if len(what) < least:
        complain(f"{rule}: found only {len(what)}, expected at least {least}: this check is blind")


sources = {}
for top in TOPS:
    for folder, inside, files in os.walk(root / top):
        inside[:] = [name for name in inside if name not in ("dist", "node_modules")]
        for name in files:
            path = pathlib.Path(folder) / name
            if path.suffix in (".cpp", ".h"):
                sources[str(path.relative_to(root))] = path.read_text()
found("sources", sources, 300)


def sizes():
    """A class lives in one .cpp; a folder can be overlooked and says what it is."""
    folders = {}
    for file, text in sources.items():
        folders.setdefault(file.rpartition("/")[0], []).append(file)
        if file.endswith(".cpp") and text.count("\n") > MOST_LINES:
            complain(f"{file}: {text.count(chr(10))} lines, expected at most {MOST_LINES}")
    for folder, files in sorted(folders.items()):
        if len(files) > MOST_FILES:
            complain(f"{folder}: {len(files)} sources, expected at most {MOST_FILES}")
        if not (root / folder / "README.md").exists():
            complain(f"{folder}: README.md is missing")


def opening_comments():
    """A .cpp opens with what it does."""
    for file, text in sources.items():
        if file.endswith(".cpp") and not text.startswith("//"):
            complain(f"{file}: does not open with a comment")


def one_class_of_a_name():
    """Two classes of one name in one namespace make programs that link both call a function of the wrong one; no linker tells."""
    places = {}
    for file, text in sources.items():
        space, hidden = "", False  # the namespace, and whether the lines are in one without a name
        for line in text.split("\n"):
            if opened := re.match(r"namespace(?: ([\w:]+))? \{", line):
                space, hidden = opened[1] or space, hidden or not opened[1]
            hidden = hidden and line != "}  // namespace"
            if (one := re.match(r"(?:template <[^>]*> )?(?:class|struct|enum class) (\w+)(?: final)?(?: : [^{;]*)? \{", line)) and not hidden:
                places.setdefault(f"{space}::{one[1]}", set()).add(file)
    found("classes", places, 500)
    for name, files in sorted(places.items()):
        if len(files) > 1:
            complain(f"{name} is defined in {', '.join(sorted(files))}: expected one class of a name")


def keys_are_read():
    """A key that is read does something: every member that a description of keys fills is read elsewhere, by more than a check. Members are
    known by their names alone, so a function that shares its name with another member is not reported."""
    described = [f for f in sources if re.search(r"/(scene_fields|sweep_file|calibration)\.cpp$", f)]
    found("descriptions of keys", described, 3)
    filled = {}
    for file in described:
        for line in sources[file].split("\n"):
            if "one.key" not in line:  # the loop of a list of keys
                for member in re.findall(r"[ (&{][a-z_]+(?:\.[A-Za-z_0-9]+)*\.([A-Za-z_0-9]+) *[,)}]", line):
                    filled.setdefault(member, file)
    found("members that keys fill", filled, 250)
    read = set()
    for file, text in sources.items():
        if file.startswith("mbd_solver/") and not re.search(r"/(scene_fields|check_[a-z]+|scene_check)\.cpp$", file):
            read.update(re.findall(r"(?:\.|->)([A-Za-z_0-9]+)", re.sub(r"//.*", "", text)))
    for member in sorted(filled.keys() - read):
        complain(f"{filled[member]}: {member}: a key fills it and nothing reads it")


def force_elements_have_specimens():
    """Forces of every element are held against derivatives and energies by a specimen between flexible bodies."""
    text = (root / SPECIMENS).read_text()
    whole = lambda name: re.search(rf"^inline [^\n]*\b{name}\(.*?^}}", text, re.M | re.S)
    all_forces = whole("all_forces")
    if not all_forces or "make_unique" not in all_forces[0]:
        return complain(f"{SPECIMENS}: all_forces was not found")
    makers = re.findall(r"^inline std::unique_ptr<\w+> ([a-z_]+)", text, re.M)
    elements = {}
    for file, source in sources.items():
        for name in re.findall(r"class (\w+)(?: final)? : public (?:Force|Contact)Element", source):
            elements[name] = file
    del elements["ContactElement"]  # the interface of four others
    found("force elements", elements, 10)
    for name, file in elements.items():
        if name == "TurnCounter" and "add_gear(" in text:
            continue  # part of a gear
        made_by = [name] + [m for m in makers if whole(m) and f"make_unique<{name}>" in whole(m)[0]]
        if not re.search(rf"\b({'|'.join(made_by)})\b", all_forces[0]):
            complain(f"{file}: {name} has no specimen in all_forces of {SPECIMENS}")


def elements_have_types():
    """A force element has the type of its handle (mbd_solver/model/model.h): an index is never cast to a type."""
    texts = {str(path.relative_to(root)): path.read_text() for path in (root / "tests").rglob("*.cpp")}
    texts.update(sources)
    handles = 0
    for file, text in texts.items():
        for cast in re.finditer(r"static_cast<(?:const )?\w+ ?[&*]>\((?:[^;()\n]|\(\))*\bforce\(", text):
            if file == "mbd_solver/model/model.h":
                handles += 1
            else:
                complain(f"{file}:{text.count(chr(10), 0, cast.start()) + 1}: {cast[0]}: casts a force element; keep the handle of add_force()")
    found("casts of handles", range(handles), 1)


def quoting():
    """Text goes into gnuplot scripts, shell lines and HTML by the functions of quote.h alone, and nothing is handed to a shell."""
    scripts = [f for f, text in sources.items() if re.search(GNUPLOT, text) and f.endswith(".cpp")]
    found("sources that write gnuplot scripts", scripts, 4)
    for file, text in sources.items():
        for number, line in enumerate(text.split("\n"), 1):
            where = f"{file}:{number}: {line.strip()}"
            # No literal of a gnuplot line ends within a quote that a value would go on.
            if file in scripts and re.search(r"""(^|[^\\])(\\"|')" *(<<|\+) *[A-Za-z(]""", line) and re.search(r"\b(set|plot|title|using|lines|load)\b", line):
                complain(f"{where}: a value in quotes; use gnuplot_text")
            if re.search(r'"[^"]*<(p|td|th|h[12]|pre|a|img|table|div|script)[ >]', line) and file not in HTML_PAGES:
                complain(f"{where}: writes HTML; report.h does that")
            if file in HTML_PAGES and re.search(r"(\+|=) *(text|heading|label|line|words|title_?|caption|note|folder)\b", line) and not re.search(
                    r"html_text|for \(|std::string (text|words) =|\bpage[.(]|HtmlPage page|= line\.|script", line):
                complain(f"{where}: a page holds text that is not escaped")
            if re.search(r"\b(popen|system|execl|execlp)\(", line) and not re.match(r" *//", line) and not re.search(
                    r"System\(|FuzzySystem", line) and file not in SHELL_FILES:
                complain(f"{where}: hands something to a shell")
            if file.startswith(SWEEP_SCRIPTS) and re.search(r"SBATCH.*<< *(a\.|fs::|out|path)", line):
                complain(f"{where}: a name in sweep.sbatch without shell_word")


def one_child_process():
    """Programs and copies of a process are started in one place, which asks for their rights."""
    starts = r"(?<![\w.>])(v?fork|posix_spawnp?|exec(v|l)\w*|popen)\("
    if not re.search(starts, sources[CHILD_PROCESS]):
        complain(f"{CHILD_PROCESS}: starts nothing: this check is blind")
    for file, text in sources.items():
        for number, line in enumerate(text.split("\n"), 1):
            if re.search(starts, line.split("//")[0].replace("::", "")) and file != CHILD_PROCESS and file not in SHELL_FILES:
                complain(f"{file}:{number}: {line.strip()}: starts a process; base/child_process.h does that")


def model_is_constant():
    """Several evaluations share a model: no part of it changes while it is evaluated (ElementScratch), and it reads no file and starts no
    process: files are read before (scene, assemble), and what remains in a file comes as a function."""
    constant = {f: text for f, text in sources.items() if f.startswith(("mbd_solver/model/", "mbd_solver/dynamics/"))}
    found("sources of the model", constant, 80)
    outside = (r"#include <(fstream|cstdio|fcntl\.h|unistd\.h|sys/[a-z]+\.h|spawn\.h)>"
               r'|#include "[a-z_/]+/(text_reader|csv|number_file|input_file|files|run_directory|child_process|child_watch|helper_process)\.h"')
    for file, text in constant.items():
        for number, line in enumerate(text.split("\n"), 1):
            if re.match(r"\s*(mutable|(static )?thread_local)\b", line) or ("const_cast" in line and "/model/" in file):
                complain(f"{file}:{number}: {line.strip()}: the model is constant; expected scratch of the evaluation (ElementScratch)")
            if re.match(outside, line):
                complain(f"{file}:{number}: {line.strip()}: the model reads no file and starts no process")


def one_text_reader():
    """Files of text are read in one place, which knows limits, ends of lines and the place of a fault; a text in memory is split."""
    reads = r"std::getline\(|std::ifstream\b"
    for file in OWN_READERS:
        if not re.search(reads, sources.get(file, "")):
            complain(f"{file}: reads nothing by itself: leave it out of OWN_READERS")
    for file, text in sources.items():
        if not file.startswith(("coupler/", "mbd_solver/")) or file in OWN_READERS:
            continue
        for number, line in enumerate(text.split("\n"), 1):
            if re.search(reads, line.split("//")[0]):
                complain(f"{file}:{number}: {line.strip()}: reads a file or lines; TextReader (base/text_reader.h), read_whole_file or split does that")


def locales():
    """Numbers are read and written alike in every locale of the program that uses a library: by coupler/base/number.h and text.h."""
    for file, text in sources.items():
        for number, line in enumerate(text.split("\n"), 1):
            code = line.split("//")[0]
            if re.search(r"\b(strtod|strtof|stod|stof|atof)\(", code) and file != "coupler/base/number.cpp":
                complain(f"{file}:{number}: {line.strip()}: reads a number as the locale says; use read_number")
            if re.search(r"\bsetlocale\(|locale::global\(", code):
                complain(f"{file}:{number}: {line.strip()}: changes the locale of the whole program")
            if re.search(r"to_string\((time|\w*(time|mass|length|thickness|depth)_?|[\w.]+\.time)\)", code):
                complain(f"{file}:{number}: {line.strip()}: writes a number as the locale says; use plain_text or number_text")
        if (text.count("std::ostringstream ") and file.startswith(LIBRARIES) and re.search(r"precision\(|<< t\b", text) and
                "imbue(std::locale::classic())" not in text):
            complain(f"{file}: a stream of numbers without std::locale::classic()")


def named_files():
    """A file that a source or a test names exists."""
    named = 0
    for top in TOPS + ("tests",):
        for path in (root / top).rglob("*"):
            if path.suffix in (".cpp", ".h", ".sh", ".mjs") and "node_modules" not in path.parts:
                for name in re.findall(rf"\b(?:{'|'.join(TOPS)}|tests)/[a-z_/]+\.(?:h|cpp|sh|py|js)\b", path.read_text()):
                    named += 1
                    if not (root / name).exists():
                        complain(f"{path.relative_to(root)} names {name}, which does not exist")
    found("files that sources name", range(named), 1000)


def readmes():
    """A README of a folder begins with its heading, is not indented as code, and names files, folders and functions that exist: `link` (a stem or an
    identifier), link.cpp, or `../link/dem_link` (a path from the folder)."""
    stems, words, names = set(), set(), 0
    for path in (path for top in TOPS + ("tests", "inputs", "examples") for path in (root / top).rglob("*") if "node_modules" not in path.parts):
        stems.update((path.stem, path.name))
        if path.suffix in (".cpp", ".h", ".py", ".txt", ".sh"):
            words.update(re.findall(r"\w+", path.read_text(errors="ignore")))
    for page in (page for top in TOPS for page in (root / top).rglob("README.md") if "node_modules" not in page.parts):
        text = page.read_text()
        prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
        if not re.match(r"# \w", text) or re.search(r"^ {4}", prose, re.M):
            complain(f"{page.relative_to(root)}: expected a first line \"# NAME\" and no indented lines; write it as Markdown")
        for name in re.findall(r"`([a-z]\w*)`|(?<![*\w])(\w+\.(?:h|cpp|py|mjs))\b", text):
            names += 1
            if (name[0] or name[1]) not in (stems | words if name[0] else stems):
                complain(f"{page.relative_to(root)} names {name[0] or name[1]}, which does not exist")
        for name in re.findall(r"`(\.\./[\w./]+)`", text):
            names += 1
            path = page.parent / name
            if not path.exists() and not any(path.parent.glob(path.name + ".*")):
                complain(f"{page.relative_to(root)} names {name}, which does not exist")
    found("names in READMEs", range(names), 200)


def packages():
    """The page on installation names every package of packaging/parts."""
    rows = [line.split("|") for line in (root / "packaging/parts").read_text().splitlines() if not line.startswith("#")]
    wanted = {package.rstrip("?") for row in rows if row[0].strip() not in ("test_all", "test_nightly") for package in row[3].split()}
    found("packages of packaging/parts", wanted, 30)
    words = re.findall(r"[a-z0-9.+-]+", (root / "docs/how-to/install.md").read_text())
    for package in sorted(wanted - set(words)):
        complain(f"docs/how-to/install.md: does not name {package}")


def tests_leave_nothing():
    """Tests write into folders of tests/support, which go away with their owner; no log of LIGGGHTS is left in the tree."""
    tests = [path for path in (root / "tests").rglob("*") if path.suffix in (".cpp", ".h") and path.parent.name != "support"]
    found("sources of tests", tests, 150)
    for path in tests:
        for number, line in enumerate(path.read_text().split("\n"), 1):
            if re.search(r"\b(temp_directory_path|TempDir|mkdtemp|mkstemp|tmpnam|tempnam)\(", line):
                complain(f"{path.relative_to(root)}:{number}: {line.strip()}: a file that a failing test leaves; use tests/support/temporary_folder.h")
    for top in (*TOPS, "tests", "inputs", "examples", "docs", "."):
        for path in (root / top).glob("log.liggghts" if top == "." else "**/log.liggghts"):
            complain(f"{path.relative_to(root)}: left by a run; run programs in a folder of tests/support")


for rule in (sizes, opening_comments, one_class_of_a_name, keys_are_read, force_elements_have_specimens, elements_have_types, quoting, one_child_process, model_is_constant, one_text_reader, locales, named_files, readmes, packages, tests_leave_nothing):
    rule()
sys.exit(failed)
