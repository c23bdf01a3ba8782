#!/usr/bin/env python3
"""Keys of scenes come from the reader: `footfall schema` prints them with unit, range and default. From it this script writes

    docs/reference/keys.md          all of it: every key of every section
    docs/reference/scene.md         the columns `keys` and `default` of tables below a comment <!-- keys: SECTION -->
    docs/reference/sweep_files.md   the same, by `footfall schema --experiments`
    inputs/reference/scene.toml     [unit] and "Default VALUE" in the comment of a key that has a line of its own

keys.py FOOTFALL          writes them
keys.py FOOTFALL --check  exit 1, with a line per difference, where one of them is not what the reader says, or the reference scene
                          or a table lacks or invents a key
"""
import difflib
import json
import pathlib
import re
import subprocess
import sys
import tomllib

root = pathlib.Path(__file__).resolve().parents[2]
page_of_keys = root / "docs/reference/keys.md"
page_of_scenes = root / "docs/reference/scene.md"
page_of_sweeps = root / "docs/reference/sweep_files.md"
reference = root / "inputs/reference/scene.toml"


def kind_of(s):
    """A schema's type in words."""
    if "anyOf" in s:
        return " or ".join(kind_of(way) for way in s["anyOf"])
    if "const" in s:
        return f'`"{s["const"]}"`'
    if "enum" in s:
        return ", ".join(f'`"{word}"`' for word in s["enum"])
    if not s:
        return "see what it means"
    if s["type"] == "array":
        same = "minItems" in s and s.get("maxItems") == s["minItems"]
        return f"{s['minItems']} × {kind_of(s['items'])}" if same else f"list of {kind_of(s['items'])}"
    if s["type"] == "object" and "maxProperties" in s:
        joint = " and " if s.get("minProperties", 1) > 1 else " or "
        return "{ " + joint.join(f"`{name}`" for name in s["properties"] if not name.endswith("_deg")) + " }"
    words = {"number": "number", "integer": "whole number", "boolean": "true or false", "string": "text",
             "object": "table"}
    word = words[s["type"]] if isinstance(s["type"], str) else " or ".join(words[t] for t in s["type"])
    bounds = [f"> {s['exclusiveMinimum']}"] if "exclusiveMinimum" in s else []
    bounds += [f">= {s['minimum']}"] if "minimum" in s else []
    bounds += [f"<= {s['maximum']}"] if "maximum" in s else []
    return f"{word} {', '.join(bounds)}".strip()


def table_below(s):
    """("name" or "name[]" or "name.NAME", schema) of a key that holds tables."""
    for way in s.get("anyOf", [s]):
        if way.get("type") == "object" and "properties" in way and "maxProperties" not in way:
            return "{}", way
        if way.get("type") == "object" and isinstance(way.get("additionalProperties"), dict):
            named = way["additionalProperties"]
            for one in named.get("anyOf", [named]):
                if "properties" in one:
                    return "{}.NAME", one
        if way.get("type") == "array" and "properties" in way.get("items", {}):
            return "{}[]", way["items"]
    return None


class Key:
    """One key: its path ("bodies[].shape.radius"), and what the reader says of it."""

    def __init__(self, path, schema, suffixes):
        self.path, self.suffixes = path, suffixes
        self.values = kind_of(schema)
        described = schema.get("description", "")
        unit = re.match(r"\[([^\]]*)\]", described)
        self.unit = unit.group(1) if unit else ""
        self.required = "Required." in described
        self.default = schema.get("default")
        self.is_table = table_below(schema) is not None

    def default_text(self):
        """The default as a scene states it; empty: none, or zeros, which mostly stand for "not given"."""
        value = self.default
        if isinstance(value, bool):
            return "true" if value else "false"
        if isinstance(value, str):
            return value
        if isinstance(value, (int, float)):
            return short(value) if value else ""
        if isinstance(value, list) and value in kAxes:
            return "xyz"[kAxes.index(value)]
        return json.dumps(value) if isinstance(value, list) and any(value) else ""


kAxes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
# Other names of a unit in comments.
kAlso = {"Pa": ["J/m3"]}


def short(number):
    return f"{number:.10g}".replace("e-0", "e-").replace("e+0", "e")


def keys_of(schema, path=""):
    """{path: Key} of a table and all tables below it, in the order of the reader."""
    while "anyOf" in schema:
        schema = next(way for way in schema["anyOf"] if way.get("type") == "object" and "properties" in way)
    found, suffixes = {}, {}
    for name, value in schema["properties"].items():
        if "x-unit-of" in value:
            suffixes.setdefault(value["x-unit-of"], []).append(name[len(value["x-unit-of"]):])
    for name, value in schema["properties"].items():
        if "x-unit-of" in value or name == "without":
            continue
        full = f"{path}.{name}" if path else name
        below = table_below(value)
        if below:
            if "anyOf" in value and any(way.get("type") == "boolean" for way in value["anyOf"]):
                found[full] = Key(full, value, [])
            found.update(keys_of(below[1], full + ("" if below[0] == "{}" else "[]")))
        else:
            found[full] = Key(full, value, suffixes.get(name, []))
    return found


# ---- the reference scene

class Line:
    """A line of a scene: what is before the comment, the comment (without #), and the keys on it by path with their spelling."""

    def __init__(self, code, comment, keys, alone):
        self.code, self.comment, self.keys, self.alone = code, comment, keys, alone


def split_comment(line):
    quoted = False
    for at, letter in enumerate(line):
        quoted ^= letter == '"'
        if letter == "#" and not quoted:
            return line[:at], line[at:]
    return line, ""


class Reference:
    def __init__(self, text, schema, known):
        self.schema, self.known, self.unknown = schema, known, []
        self.lines, table, waiting, prefix = [], "", "", ""
        for line in text.split("\n"):
            code, comment = split_comment(line)
            header = re.match(r"\s*\[\[?([\w.{}]+)\]?\]\s*$", code)
            given = re.match(r"\s*(\w+)\s*=\s*(.*)$", code)
            keys, alone = [], False
            if waiting:  # in the midst of a value of several lines
                keys = [(f"{prefix}[].{key}", key) for key in re.findall(r"(\w+)\s*=", code)]
                waiting += code + "\n"
                if self.whole(waiting):
                    waiting = ""
            elif header:
                table = self.path_of(header.group(1).split("."))
            elif given:
                path, written = self.known_as(table, given.group(1))
                value = self.whole("x = " + given.group(2))
                if value is None:
                    waiting, prefix = f"x = {given.group(2)}\n", path
                    keys = [(path, written)]
                else:
                    keys = [(path, written), *self.keys_below(path, value["x"])]
                    alone = len(keys) == 1
            self.lines.append(Line(code, comment, [k for k in keys if self.is_known(k)], alone))

    @staticmethod
    def whole(text):
        try:
            return tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            return None

    def path_of(self, parts):
        """The path of a header: named tables and lists become []."""
        path, node = "", self.schema
        parts = list(parts)
        while parts:
            name = parts.pop(0)
            node = next(way for way in node.get("anyOf", [node]) if "properties" in way)["properties"].get(name, {})
            path = f"{path}.{name}" if path else name
            below = table_below(node)
            if below is None:
                return path
            node = below[1]
            if below[0] != "{}":
                path += "[]"
            if below[0] == "{}.NAME" and parts:
                parts.pop(0)
        return path

    def known_as(self, table, written):
        """(path, spelling) of a key, which may end with a unit."""
        path = f"{table}.{written}" if table else written
        if path in self.known:
            return path, written
        for key in self.known.values():
            for suffix in key.suffixes:
                if key.path + suffix == path:
                    return key.path, written
        return path, written

    def keys_below(self, path, value):
        found = []
        for item in value if isinstance(value, list) else [value]:
            if isinstance(item, dict):
                inner = path + ("[]" if isinstance(value, list) else "")
                for key, below in item.items():
                    full, written = self.known_as(inner, key)
                    found += [(full, written), *self.keys_below(full, below)]
        return found

    def is_known(self, key):
        path = key[0]
        # Tables, orientations (rpy, quaternion, axis and angle), lists of variables and texts by name hold names of their own.
        return path in self.known

    def text(self):
        return "\n".join((line.code + line.comment).rstrip() for line in self.lines)


kDefault = re.compile(r"\b([Dd])efault (\"?[-\w.+]+\"?)( mm| ms| Pa)?")
kFactors = {" mm": 1e-3, " ms": 1e-3, " Pa": 1.0, None: 1.0}


def number_in(word):
    try:
        return float(word)
    except ValueError:
        return None


def stated_defaults(comment):
    """What "Default VALUE" in a comment says: [(match, value as number or word)]."""
    found = []
    for match in kDefault.finditer(comment):
        word = match.group(2).strip('"').rstrip(".")
        number = number_in(word)
        found.append((match, word if number is None else number * kFactors[match.group(3)]))
    return found


def agrees(value, key):
    default = key.default
    if isinstance(value, float):
        if isinstance(default, list):
            return all(value == one for one in default)
        return isinstance(default, (int, float)) and not isinstance(default, bool) and \
            abs(value - default) <= 1e-9 * max(abs(default), 1e-300)
    return value == key.default_text() or (isinstance(default, str) and value == default)


def corrected(line, key, units):
    """The comment of a line of one key, with the unit and the default of the reader."""
    comment = line.comment
    written_in_unit = line.keys[0][1] != key.path.rsplit(".", 1)[-1]
    given = re.findall(r"\[([^\[\]]+)\]", comment)
    others = [unit for unit in given if unit in units]
    if key.unit and not written_in_unit and not any(unit in given for unit in [key.unit, *kAlso.get(key.unit, [])]):
        before_default = re.search(r"\.? *\b[Dd]efault", comment[2:])
        if others:
            comment = comment.replace(f"[{others[0]}]", f"[{key.unit}]")
        elif before_default and before_default.start() > 0:
            at = 2 + before_default.start()
            comment = comment[:at] + f" [{key.unit}]" + comment[at:]
        else:
            comment = f"# [{key.unit}]{comment[1:]}" if before_default or not comment else f"{comment} [{key.unit}]"
    stated = stated_defaults(comment)
    for match, value in reversed(stated):
        is_value = isinstance(value, float) or value in ("true", "false") or f'"{value}"' in key.values
        if is_value and key.default is not None and not agrees(value, key):
            text = key.default_text() or "0"
            comment = comment[:match.start(2)] + text + comment[match.end():]
    if key.default_text() and not isinstance(key.default, list) and not re.search(r"[Dd]efault", comment):
        comment = (comment.rstrip(". ") + "." if comment else "#") + f" Default {key.default_text()}"
    return comment


def tail(path):
    return ".".join(path.split(".")[-2:])


def corrected_reference(text, schema, known):
    """The reference scene with the units and defaults of the reader, and what only its writer can mend."""
    scene, faults = Reference(text, schema, known), []
    units = {key.unit for key in known.values() if key.unit}
    stated = {}
    for line in scene.lines:
        for path, _ in line.keys:
            stated.setdefault(path, []).append(line)
    for line in scene.lines:
        if not (line.alone and line.keys):
            continue
        path = line.keys[0][0]
        key = known[path]
        elsewhere = any(re.search(r"[Dd]efault", other.comment) for other in stated[path] if other is not line)
        unit_elsewhere = any(f"[{key.unit}]" in other.comment for other in stated[path] if other is not line)
        fixed = corrected(line, key, units)
        added_only = fixed != line.comment and (elsewhere or unit_elsewhere) and not re.search(r"[Dd]efault|\[", line.comment)
        if not added_only and fixed != line.comment:
            if not line.comment:
                line.code = line.code.rstrip().ljust(36) + " "
            line.comment = fixed
    # Of tables in one line it suffices that a key of the same name and table states the same default.
    by_tail = {}
    for path, lines in stated.items():
        by_tail.setdefault(tail(path), []).extend(lines)
    for path, lines in stated.items():
        key = known[path]
        alike = by_tail[tail(path)]
        if key.default_text() and not isinstance(key.default, list) and not any(line.alone for line in lines) and \
                not any(agrees(value, key) for line in alike for _, value in stated_defaults(line.comment)):
            faults.append(f"{reference.relative_to(root)}: no comment next to {path} says \"Default {key.default_text()}\"")
    return scene, scene.text(), faults


# ---- the pages

kDefaultWords = re.compile(r"\(?\b[Dd]efault:? (.*?)\)?(?:\.(?=\s)|\.?$)")


def meanings(scene):
    """{path: (words, default in words)} of the comments of keys that have a line of their own, without units."""
    found = {}
    for line in scene.lines:
        if not (line.alone and line.keys and line.comment):
            continue
        path = line.keys[0][0]
        if path in found or re.search(r"\.(name|kind)$", path):  # these comments are about the entry
            continue
        words = re.sub(r" *\[[^\[\],.]*\]", "", line.comment[1:])
        default = kDefaultWords.search(words)
        words = re.sub(r"\brequired\b:?", "", kDefaultWords.sub("", words))
        words = re.sub(r"\s+", " ", words).strip(" .,;:")
        if re.match(r'or "[^"]*"(,? or "[^"]*")*(, or)?$', words):  # the other values, which are in a column of their own
            words = ""
        found[path] = (words.replace("|", "\\|"), default.group(1).strip() if default else "")
    return found


def row(cells):
    return "|" + "".join(f" {cell} |" if cell else " |" for cell in cells)


def page(known, said, kinds):
    lines = ["# Keys of a scene", "Every key of a scene with its values, unit and default, as the reader has them; "
             "[Scenes](scene.md) explains kinds and sections.",
             "Made by `docs/site/keys.py` from `footfall schema`; the meanings are comments of "
             "[inputs/reference/scene.toml](../../inputs/reference/scene.toml).",
             "`[]`: an entry of a list, or a named table. Another unit is a suffix of the key, as in `length_mm`."]
    sections = {}
    for path, key in known.items():
        sections.setdefault(re.split(r"[.\[]", path)[0] if re.search(r"[.\[]", path) else "", []).append(key)
    for section, keys in sections.items():
        lines += ["", f"## `{section}`" if section else "## Top of the file", "| key | values | unit | default | meaning |",
                  "|---|---|---|---|---|"]
        of_kinds = kinds.get(section, {})
        for key in keys:
            name = re.sub(rf"^{section}(\[\])?\.", "", key.path) if section else key.path
            users = [kind for kind, uses in of_kinds.items() if name.split(".")[0] in uses["required"] + uses["optional"]]
            words, default_words = said.get(key.path, ("", ""))
            if users and len(users) < len(of_kinds):
                words = "of " + ", ".join(f"`{kind}`" for kind in users) + ("; " + words if words else "")
            unit = " ".join([key.unit, *(f"`{s}`" for s in key.suffixes)])
            default = "required" if key.required else f"`{key.default_text()}`" if key.default_text() else default_words
            lines.append(row([f"`{name}`", key.values, unit, default, words]))
    return "\n".join(lines) + "\n"


def corrected_tables(file, known, kinds):
    """The page with the columns of the reader, and the keys and kinds that it lacks or invents."""
    lines, faults, i, here = file.read_text().split("\n"), [], 0, file.relative_to(root)
    while i < len(lines):
        mark = re.match(r"<!-- keys: ([\w\[\].]+|top) -->$", lines[i])
        i += 1
        if not mark:
            continue
        while not lines[i].strip():
            i += 1
        section, head = mark.group(1), [cell.strip() for cell in lines[i].strip("| ").split("|")]
        names, inside = set(), "" if section == "top" else f"{section}."
        of_keys = head[0].endswith("key")
        for k in range(i + 2, len(lines)):
            if not lines[k].startswith("|"):
                break
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", lines[k].strip()[1:-1])]
            for name in re.findall(r"`([\w.\[\]]+)`", cells[0]):
                names.add(name)
                if head[0] == "kind" and name in kinds.get(section, {}) and any(title.startswith("keys") for title in head):
                    uses = kinds[section][name]
                    cells[next(k for k, title in enumerate(head) if title.startswith("keys"))] = ", ".join([*uses["required"], *(f"[{key}]" for key in uses["optional"])])
                elif of_keys and inside + name in known:
                    key = known[inside + name]
                    value = "required" if key.required else key.default_text()
                    if "default" in head and value and "," not in cells[0]:
                        stated = cells[head.index("default")]
                        value += f" {key.unit}" if key.unit else ""
                        if stated.strip("`") != value:
                            cells[head.index("default")] = value
                elif not of_keys or not any(path.startswith(f"{inside}{name}[") for path in known):
                    faults.append(f"{here}:{k + 1}: {section} has no {head[0]} `{name}`")
            lines[k] = row(cells)
        if head[0] == "kind":
            for kind in kinds.get(section, {}):
                if kind not in names:
                    faults.append(f"{here}:{i + 1}: the table lacks the kind `{kind}` of {section}")
    return "\n".join(lines), faults


def main():
    def printed(*option):
        return json.loads(subprocess.run([sys.argv[1], "schema", *option], check=True, capture_output=True, text=True).stdout)

    schema = printed()
    known, kinds = keys_of(schema), schema.get("x-kinds", {})
    scene, scene_text, faults = corrected_reference(reference.read_text(), schema, known)
    tables, more = corrected_tables(page_of_scenes, known, kinds)
    sweeps, others = corrected_tables(page_of_sweeps, keys_of(printed("--experiments")), {})
    faults += more + others
    texts = {reference: scene_text, page_of_scenes: tables, page_of_sweeps: sweeps, page_of_keys: page(known, meanings(scene), kinds)}
    for file, text in texts.items():
        now = file.read_text() if file.exists() else ""
        if now == text:
            continue
        if "--check" not in sys.argv:
            file.write_text(text)
            continue
        for change in list(difflib.unified_diff(now.split("\n"), text.split("\n"), lineterm="", n=0))[2:12]:
            faults.append(f"{file.relative_to(root)}: {change}")
        faults.append(f"{file.relative_to(root)} is not what the reader says: run docs/site/keys.py FOOTFALL")
    print("\n".join(faults) if faults else f"{len(known)} keys")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
