#!/usr/bin/env python3
"""mutate.py FOOTFALL_IMPORT SECONDS [SEED] FILE...: imports damaged copies of robots. Each ends with exit code 0 and a scene, or with 2, a
message with a code, and nothing written; never with a crash or a hang. Prints the damaged file that does not."""
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time

program, seconds = sys.argv[1], float(sys.argv[2])
rest = sys.argv[3:]
seed = int(rest.pop(0)) if rest and rest[0].isdigit() else 1
files = rest
dice = random.Random(seed)
WORDS = ["nan", "1e400", "-1", "0", "1e-320", "", "world", "a" * 5000, "0 0", "1 2 3 4 5 6 7 8", "<", ">", "&amp;", "\x01", "\xff", "${x}", "true", "-inf", "package://x/y.stl"]


def damaged(text):
    for _ in range(dice.choice([1, 1, 1, 2, 5])):
        kind = dice.randrange(8)
        at = dice.randrange(max(1, len(text)))
        lines = text.split("\n")
        k = dice.randrange(len(lines))
        if kind == 0:
            text = text[:at] + chr(dice.randrange(256)) + text[at + 1:]
        elif kind == 1:
            text = text[:at]
        elif kind == 2:
            text = "\n".join(lines[:k] + lines[k + 1:])
        elif kind == 3:
            text = "\n".join(lines[:k] + [lines[dice.randrange(len(lines))]] + lines[k:])
        elif kind == 4:
            text = text[:at] + text[at + dice.randrange(60):]
        elif kind == 5:  # the value of an attribute or element
            open_ = text.find(dice.choice(['"', ">"]), at)
            close = text.find(dice.choice(['"', "<"]), open_ + 1)
            if 0 <= open_ < close:
                text = text[:open_ + 1] + dice.choice(WORDS) + text[close:]
        elif kind == 6:
            i, j = sorted((dice.randrange(len(lines)), dice.randrange(len(lines))))
            lines[i], lines[j] = lines[j], lines[i]
            text = "\n".join(lines)
        else:
            number = text.find(" ", at)
            text = text[:number] + " " + dice.choice(WORDS) + text[number:]
    return text


end, count, codes, failed = time.time() + seconds, 0, {0: 0, 2: 0}, 0
folder = tempfile.mkdtemp()
while time.time() < end:
    source = dice.choice(files)
    with open(source, encoding="latin-1") as stream:
        text = damaged(stream.read())
    name = os.path.join(folder, "robot" + os.path.splitext(source)[1])
    with open(name, "w", encoding="latin-1") as stream:
        stream.write(text)
    out = os.path.join(folder, "out")
    try:
        run = subprocess.run([program, "import", name, "--out", out, "--quiet"] + dice.choice([[], ["--hold"], ["--ground", "grains"], ["--merge-fixed", "--fix-base"]]),
                             capture_output=True, timeout=60)
        code, message = run.returncode, run.stderr.decode("latin-1")
    except subprocess.TimeoutExpired:
        code, message = "hang", ""
    count += 1
    good = (code == 0 and os.path.exists(out + "/scene.toml")) or (code == 2 and not os.path.exists(out) and " [E" in message)
    codes[code] = codes.get(code, 0) + 1
    if not good:
        failed += 1
        keep = f"/tmp/mutated_{seed}_{count}{os.path.splitext(source)[1]}"
        shutil.copy(name, keep)
        print(f"{keep}: exit code {code}: {message[-300:]}", flush=True)
    shutil.rmtree(out, ignore_errors=True)
shutil.rmtree(folder)
print(f"{count} damaged files: exit codes {codes}, {failed} failed")
sys.exit(failed > 0)
