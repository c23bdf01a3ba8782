#!/usr/bin/env python3
"""Keys come from their reader: `footfall schema` prints them with unit, range and default.
From that this script writes

    docs/reference/keys.md          every key of a scene
    docs/reference/scene.md         the columns `keys` and `default` of each table below a comment
                                    <!-- keys: SECTION -->
    docs/reference/sweep_files.md   the same, from `footfall schema --experiments`
    inputs/reference/scene.toml     [unit] and "Default VALUE" in the comment of a key that has a
                                    line of its own

keys.py FOOTFALL          writes them
keys.py FOOTFALL --check  exit 1 and the differences where one of them is not what the reader says,
                          or where a table names an unknown key or lacks a kind
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

kWords = {"number": "number", "integer": "whole number", "boolean": "true or false",
          "string": "text", "object": "table"}
kBounds = {"exclusiveMinimum": ">", "minimum": ">=", "maximum": "<="}
kAxes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
kAlso = {"Pa": ["J/m3"]}  # other names of a unit in comments
kBracket = re.compile(r"\[([^\[\]]+)\]")
kStated = re.compile(r"\b[Dd]efault (\"?[-\w.+]+\"?)( mm| ms| Pa)?")
kFactors = {" mm": 1e-3, " ms": 1e-3, " Pa": 1.0, None: 1.0}
kDefaultWords = re.compile(r"\(?\b[Dd]efault:? (.*?)\)?(?:\.(?=\s)|\.?$)")


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
        return (f"{s['minItems']} × " if same else "list of ") + kind_of(s["items"])
    if s["type"] == "object" and "maxProperties" in s:
        joint = " and " if s.get("minProperties", 1) > 1 else " or "
        names = [f"`{name}`" for name in s["properties"] if not name.endswith("_deg")]
        return "{ " + joint.join(names) + " }"
    types = [s["type"]] if isinstance(s["type"], str) else s["type"]
    bounds = ", ".join(f"{sign} {s[word]}" for word, sign in kBounds.items() if word in s)
    return f"{' or '.join(kWords[t] for t in types)} {bounds}".strip()


def table_below(s):
    """("name" or "name[]" or "name.NAME", schema) of a key that holds tables."""
    for way in s.get("anyOf", [s]):
        is_table = way.get("type") == "object"
        if is_table and "properties" in way and "maxProperties" not in way:
            return "{}", way
        if is_table and isinstance(way.get("additionalProperties"), dict):
            named = way["additionalProperties"]
            for one in named.get("anyOf", [named]):
                if "properties" in one:
                    return "{}.NAME", one
        if way.get("type") == "array" and "properties" in way.get("items", {}):
            return "{}[]", way["items"]
    return None


def table_of(schema):
    """The schema itself, or the one of its ways that is a table."""
    return next(way for way in schema.get("anyOf", [schema]) if "properties" in way)


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

    def default_text(self):
        """As a scene states it; empty: none, or zeros, which mostly stand for "not given"."""
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

    def must_be_stated(self):
        return bool(self.default_text()) and not isinstance(self.default, list)

    def agrees(self, value):
        """With the default that a comment states."""
        if not isinstance(value, float):
            return value == self.default_text()
        if isinstance(self.default, list):
            return all(value == one for one in self.default)
        if isinstance(self.default, bool) or not isinstance(self.default, (int, float)):
            return False
        return abs(value - self.default) <= 1e-9 * max(abs(self.default), 1e-300)


def short(number):
    return f"{number:.10g}".replace("e-0", "e-").replace("e+0", "e")


def keys_of(schema, path=""):
    """{path: Key} of a table and all tables below it, in the order of the reader."""
    found, suffixes, properties = {}, {}, table_of(schema)["properties"]
    for name, value in properties.items():
        if "x-unit-of" in value:
            suffix = name[len(value["x-unit-of"]):]
            suffixes.setdefault(value["x-unit-of"], []).append(suffix)
    for name, value in properties.items():
        if "x-unit-of" in value or name == "without":
            continue
        full = f"{path}.{name}" if path else name
        below = table_below(value)
        is_switch = any(way.get("type") == "boolean" for way in value.get("anyOf", []))
        if not below or is_switch:
            found[full] = Key(full, value, suffixes.get(name, []))
        if below:
            found.update(keys_of(below[1], full + ("" if below[0] == "{}" else "[]")))
    return found


# ---- the reference scene

class Line:
    """A line of a scene: what is before the comment; the comment with its #; (path, spelling) of
    the keys on it. alone: a single key with a plain value."""

    def __init__(self, code, comment, keys, alone):
        self.code, self.comment, self.keys, self.alone = code, comment, keys, alone


def split_comment(line):
    quoted = False
    for at, letter in enumerate(line):
        quoted ^= letter == '"'
        if letter == "#" and not quoted:
            return line[:at], line[at:]
    return line, ""


def parsed(text):
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return None


class Reference:
    """The lines of a scene with their keys."""

    def __init__(self, text, schema, known):
        self.schema, self.known = schema, known
        self.lines, self.table, self.waiting, self.prefix = [], "", "", ""
        for line in text.split("\n"):
            code, comment = split_comment(line)
            keys = self.keys_on(code)
            known_keys = [key for key in keys if key[0] in known]
            alone = len(keys) == 1 and not self.waiting and "=" in code
            self.lines.append(Line(code, comment, known_keys, alone))

    def keys_on(self, code):
        header = re.match(r"\s*\[\[?([\w.{}]+)\]?\]\s*$", code)
        given = re.match(r"\s*(\w+)\s*=\s*(.*)$", code)
        if self.waiting:  # within a value of several lines
            self.waiting += code + "\n"
            if parsed(self.waiting):
                self.waiting = ""
            inner = re.findall(r"(\w+)\s*=", code)
            return [(f"{self.prefix}[].{key}", key) for key in inner] + [("", "")]
        if header:
            self.table = self.path_of(header.group(1).split("."))
        if header or not given:
            return []
        path, written = self.known_as(self.table, given.group(1))
        value = parsed("x = " + given.group(2))
        if value is None:
            self.waiting, self.prefix = f"x = {given.group(2)}\n", path
            return [(path, written)]
        return [(path, written), *self.keys_below(path, value["x"])]

    def path_of(self, parts):
        """The path of a header: named tables and lists become []."""
        path, node, parts = "", self.schema, list(parts)
        while parts:
            name = parts.pop(0)
            path = f"{path}.{name}" if path else name
            below = table_below(table_of(node)["properties"].get(name, {}))
            if below is None:
                return path
            node = below[1]
            path += "" if below[0] == "{}" else "[]"
            if below[0] == "{}.NAME" and parts:
                parts.pop(0)
        return path

    def known_as(self, table, written):
        """(path, spelling) of a key, which may end with a unit."""
        path = f"{table}.{written}" if table else written
        for key in self.known.values():
            if any(key.path + suffix == path for suffix in key.suffixes):
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

    def comments_on(self, path, but=None):
        return [line.comment for line in self.lines
                if line is not but and any(key == path for key, _ in line.keys)]

    def text(self):
        return "\n".join((line.code + line.comment).rstrip() for line in self.lines)


def stated_defaults(comment):
    """[(match, value)] of "Default VALUE" in a comment: a number in SI units, or a word."""
    found = []
    for match in kStated.finditer(comment):
        word = match.group(1).strip('"').rstrip(".")
        try:
            found.append((match, float(word) * kFactors[match.group(2)]))
        except ValueError:
            found.append((match, word))
    return found


def with_unit(comment, key, units):
    """The comment with the unit of the key; in the place of another one, or before the default."""
    given = kBracket.findall(comment)
    if any(unit in given for unit in [key.unit, *kAlso.get(key.unit, [])]):
        return comment
    for other in given:
        if other in units:
            return comment.replace(f"[{other}]", f"[{key.unit}]")
    default = re.search(r"\.? *\b[Dd]efault", comment[2:])
    if default and default.start() > 0:
        at = 2 + default.start()
        return f"{comment[:at]} [{key.unit}]{comment[at:]}"
    return f"# [{key.unit}]{comment[1:]}" if default or not comment else f"{comment} [{key.unit}]"


def with_default(comment, key):
    for match, value in reversed(stated_defaults(comment)):
        is_value = isinstance(value, float) or value in ("true", "false") or \
            f'"{value}"' in key.values
        if is_value and key.default is not None and not key.agrees(value):
            comment = comment[:match.start(1)] + (key.default_text() or "0") + comment[match.end():]
    if key.must_be_stated() and not re.search(r"[Dd]efault", comment):
        comment = (comment.rstrip(". ") + "." if comment else "#")
        comment += f" Default {key.default_text()}"
    return comment


def correct(line, scene, units):
    """Unit and default of the reader in the comment of a line with one key. What is missing is
    added once, at the first of the lines that have the key."""
    path, written = line.keys[0]
    key, others = scene.known[path], scene.comments_on(path, but=line)
    comment = line.comment
    in_si = written == path.rsplit(".", 1)[-1]
    unit_elsewhere = any(f"[{key.unit}]" in other for other in others)
    if key.unit and in_si and (kBracket.search(comment) or not unit_elsewhere):
        comment = with_unit(comment, key, units)
    if re.search(r"[Dd]efault", comment) or not any(re.search("[Dd]efault", o) for o in others):
        comment = with_default(comment, key)
    if comment and not line.comment:
        line.code = line.code.rstrip().ljust(36) + " "
    line.comment = comment


def tail(path):
    return ".".join(path.split(".")[-2:])


def missing_defaults(scene):
    """Of keys that are only in tables of one line: it suffices that a key of the same name and
    table states the same default."""
    lines_of, faults = {}, []
    for line in scene.lines:
        for path, _ in line.keys:
            lines_of.setdefault(path, []).append(line)
    for path, lines in lines_of.items():
        key = scene.known[path]
        alike = [lines_of[other] for other in lines_of if tail(other) == tail(path)]
        stated = [value for line in sum(alike, []) for _, value in stated_defaults(line.comment)]
        if key.must_be_stated() and not any(line.alone for line in lines) and \
                not any(key.agrees(value) for value in stated):
            faults.append(f'{reference.relative_to(root)}: no comment next to {path} says '
                          f'"Default {key.default_text()}"')
    return faults


def corrected_reference(schema, known):
    """The reference scene with units and defaults of the reader, and what only people can mend."""
    scene = Reference(reference.read_text(), schema, known)
    units = {key.unit for key in known.values() if key.unit}
    for line in scene.lines:
        if line.alone and line.keys:
            correct(line, scene, units)
    return scene, missing_defaults(scene)


# ---- the pages

def meanings(scene):
    """{path: (words, default in words)} of the comments of keys with a line of their own."""
    found = {}
    for line in scene.lines:
        if not (line.alone and line.keys and line.comment):
            continue
        path = line.keys[0][0]
        if path in found or re.search(r"\.(name|kind)$", path):  # comments about the entry
            continue
        words = re.sub(r" *\[[^\[\],.]*\]", "", line.comment[1:])  # units
        default = kDefaultWords.search(words)
        words = re.sub(r"\brequired\b:?", "", kDefaultWords.sub("", words))
        words = re.sub(r"\s+", " ", words).strip(" .,;:")
        if re.match(r'or "[^"]*"(,? or "[^"]*")*(, or)?$', words):  # values have their own column
            words = ""
        found[path] = words.replace("|", "\\|"), default.group(1).strip() if default else ""
    return found


def row(cells):
    return "|" + "".join(f" {cell} |" if cell else " |" for cell in cells)


def row_of(key, name, of_kinds, said):
    words, default_words = said.get(key.path, ("", ""))
    own = name.split(".")[0]
    users = [kind for kind, uses in of_kinds.items() if own in uses["required"] + uses["optional"]]
    if users and len(users) < len(of_kinds):
        words = "of " + ", ".join(f"`{kind}`" for kind in users) + ("; " + words if words else "")
    unit = " ".join([key.unit, *(f"`{suffix}`" for suffix in key.suffixes)])
    default = f"`{key.default_text()}`" if key.default_text() else default_words
    return row([f"`{name}`", key.values, unit, "required" if key.required else default, words])


def page(known, said, kinds):
    lines = [
        "# Keys of a scene",
        "Every key of a scene with its values, unit and default, as the reader has them; "
        "[Scenes](scene.md) explains kinds and sections.",
        "Made by `docs/site/keys.py` from `footfall schema`; the meanings are comments of "
        "[inputs/reference/scene.toml](../../inputs/reference/scene.toml).",
        "`[]`: an entry of a list, or a named table. "
        "Another unit is a suffix of the key, as in `length_mm`."]
    sections = {}
    for path, key in known.items():
        section = re.match(r"\w+(?=[.\[])", path)
        sections.setdefault(section.group(0) if section else "", []).append(key)
    for section, keys in sections.items():
        lines += ["", f"## `{section}`" if section else "## Top of the file",
                  "| key | values | unit | default | meaning |", "|---|---|---|---|---|"]
        for key in keys:
            name = re.sub(rf"^{section}(\[\])?\.", "", key.path) if section else key.path
            lines.append(row_of(key, name, kinds.get(section, {}), said))
    return "\n".join(lines) + "\n"


class Table:
    """A table of a page below <!-- keys: SECTION -->, whose rows are kinds or keys of SECTION."""

    def __init__(self, section, head, known, kinds):
        self.head, self.known = head, known
        self.section, self.inside = section, "" if section == "top" else f"{section}."
        self.kinds = kinds.get(section, {}) if head[0] == "kind" else {}
        self.names = set()

    def column(self, begins):
        return next((k for k, title in enumerate(self.head) if title.startswith(begins)), None)

    def correct(self, cells):
        """Fills the reader's columns; returns the names that the reader does not have."""
        names = re.findall(r"`([\w.\[\]]+)`", cells[0])
        self.names.update(names)
        if self.head[0] == "kind":
            for name in names:
                if name in self.kinds and self.column("keys") is not None:
                    uses = self.kinds[name]
                    optional = [f"[{key}]" for key in uses["optional"]]
                    cells[self.column("keys")] = ", ".join([*uses["required"], *optional])
            return [name for name in names if name not in self.kinds]
        if len(names) == 1 and self.column("default") is not None:
            self.correct_default(self.known.get(self.inside + names[0]), cells)
        return [name for name in names if not self.has(self.inside + name)]

    def correct_default(self, key, cells):
        value = "" if key is None else "required" if key.required else key.default_text()
        if not value:
            return  # words of the page
        if key.unit and not key.required:
            value += f" {key.unit}"
        if cells[self.column("default")].strip("`") != value:
            cells[self.column("default")] = value

    def has(self, path):
        return path in self.known or any(key.startswith(f"{path}[") for key in self.known)


def cells_of(line):
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip()[1:-1])]


def corrected_tables(file, known, kinds):
    """The page with the columns of the reader, and the names that its tables lack or invent."""
    lines, faults, here = file.read_text().split("\n"), [], file.relative_to(root)
    for i, line in enumerate(lines):
        mark = re.match(r"<!-- keys: ([\w\[\].]+) -->$", line)
        if not mark:
            continue
        at = next(k for k in range(i + 1, len(lines)) if lines[k].strip())
        table = Table(mark.group(1), cells_of(lines[at]), known, kinds)
        for k in range(at + 2, len(lines)):
            if not lines[k].startswith("|"):
                break
            cells = cells_of(lines[k])
            for name in table.correct(cells):
                faults.append(f"{here}:{k + 1}: the reader has no `{name}` in {table.section}")
            lines[k] = row(cells)
        for kind in set(table.kinds) - table.names:
            faults.append(f"{here}:{at + 1}: the table lacks the kind `{kind}` of {table.section}")
    return "\n".join(lines), faults


def schema_of(*option):
    words = [sys.argv[1], "schema", *option]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def main():
    schema = schema_of()
    known, kinds = keys_of(schema), schema["x-kinds"]
    scene, faults = corrected_reference(schema, known)
    scenes, of_scenes = corrected_tables(page_of_scenes, known, kinds)
    sweeps, of_sweeps = corrected_tables(page_of_sweeps, keys_of(schema_of("--experiments")), {})
    faults += of_scenes + of_sweeps
    texts = {reference: scene.text(), page_of_scenes: scenes, page_of_sweeps: sweeps,
             page_of_keys: page(known, meanings(scene), kinds)}
    for file, text in texts.items():
        now = file.read_text() if file.exists() else ""
        if now == text:
            continue
        if "--check" not in sys.argv:
            file.write_text(text)
            continue
        name = file.relative_to(root)
        changes = difflib.unified_diff(now.split("\n"), text.split("\n"), lineterm="", n=0)
        faults += [f"{name}: {change}" for change in list(changes)[2:12]]
        faults.append(f"{name} is not what the reader says: run docs/site/keys.py FOOTFALL")
    print("\n".join(faults) if faults else f"{len(known)} keys")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
