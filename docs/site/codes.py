#!/usr/bin/env python3
"""Writes docs/reference/codes.txt, the list of all message codes with meaning and remedy, from the comments of every codes.h.

codes.py          writes the page
codes.py --check  exit 1 where the page differs, a number or a name occurs twice, or a code has no comment
"""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]
page = root / "docs/reference/codes.txt"
codes, faults = {}, []
for file in sorted(root.glob("*/codes.h")) + sorted(root.glob("*/*/codes.h")):
    comment = []
    pending = ""
    for line in file.read_text().splitlines():
        text = line.strip()
        if pending:
            text, pending = pending + " " + text, ""
        if text.startswith("//"):
            comment.append(text.lstrip("/ "))
            continue
        if "MessageCode" in text and ";" not in text:
            pending = text
            continue
        found = re.search(r'constexpr MessageCode (k\w+)\s*{"([EW]\d{4})",\s*"([a-z0-9-]+)"}', text)
        if found:
            constant, number, name = found.groups()
            meaning = " ".join(comment)
            if not meaning or meaning.startswith("----"):
                faults.append(f"{file.relative_to(root)}: {number} {name} has no comment: expected its meaning and what to do")
            for other in [code for code in codes if code[1:] == number[1:]]:
                faults.append(f"{file.relative_to(root)}: the digits of {number} stand twice: {codes[other][0]} and {name}")
            if name in [n for n, *_ in codes.values()]:
                faults.append(f"{file.relative_to(root)}: the name {name} occurs twice")
            codes[number] = (name, meaning, constant, file)
        comment = []
sources = ""
for top in ("coupler", "liggghts_fix", "mbd_solver"):
    for pattern in ("*.cpp", "*.h"):
        sources += "".join(file.read_text() for file in (root / top).rglob(pattern) if file.name != "codes.h")
scripts = "".join(file.read_text() for file in (root / "mbd_solver").rglob("*.py"))
used = set(re.findall(r"\bk[A-Z]\w*", sources))
for number, (name, _, constant, file) in codes.items():
    if constant not in used and f'"{number}"' not in scripts:
        faults.append(f"{file.relative_to(root)}: {number} {name} is used nowhere")
text = "Codes of all messages, with their meaning and what to do. Made by docs/site/codes.py from the comments of codes.h.\n\n"
text += "".join(f"{number} {name}: {meaning}\n" for number, (name, meaning, *_) in sorted(codes.items(), key=lambda c: (c[0][1:], c[0])))
if "--check" in sys.argv:
    if not page.exists() or page.read_text() != text:
        faults.append("docs/reference/codes.txt is not what the sources say: run docs/site/codes.py")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)
page.write_text(text)
print("\n".join(faults) if faults else f"{len(codes)} codes")
