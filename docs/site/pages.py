"""Puts the site's pages together: README, docs and examples with links that hold there, and a reference of keys,
kinds and commands from what the program says of itself (`footfall schema`, `--help`).

    pages.py CHECKOUT FOOTFALL PAGES SITE
"""
import json
import os
import pathlib
import re
import subprocess
import sys

root, footfall, pages, site = (pathlib.Path(a) for a in sys.argv[1:])
docs = pages / "pages"


def moved_links(text, source):
    """Links of the page `source` of the checkout, as the site has them. What is not on the site becomes its path."""
    folder, here = source.parent, pathlib.Path(on_site(source)).parent

    def from_here(page):
        return os.path.relpath(page, here)

    def link(match):
        bang, words, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match.group(0)
        path, _, anchor = target.partition("#")
        file = (folder / path).resolve()
        page = on_site(file)
        if page is None:
            return words if bang else f"{words} (`{file.relative_to(root)}`)"
        return f"{bang}[{words}]({from_here(page)}{'#' + anchor if anchor else ''})"

    def image(match):
        page = on_site((folder / match.group(2)).resolve())
        return f'{match.group(1)}"{from_here(page)}"' if page else match.group(0)

    text = re.sub(r'(<img src=)"([^"]+)"', image, text)
    # A picture may stand in the words of a link.
    return re.sub(r"(!?)\[((?:[^\[\]]|!\[[^\]]*\]\([^)]*\))*)\]\(([^)\s]+)\)", link, text)


def on_site(file):
    """Where a file of the checkout is on the site, or None."""
    if file == root / "README.md":
        return "index.md"
    if (root / "docs") in file.parents and file.is_file() and file.suffix in (".md", ".png"):
        return str(file.relative_to(root / "docs"))
    if (root / "examples") in file.parents or file.parent == root / "examples":
        if file.is_dir() and (file / "README.md").is_file():
            return f"example_{file.name}.md"
        if file.name == "README.md":
            return f"example_{file.parent.name}.md"
        if file.suffix == ".png":
            return f"example_{file.parent.name}_{file.name}"
    return None


def copy_pages():
    for file in [root / "README.md", *(root / "docs").rglob("*.md"), *(root / "examples").glob("*/README.md")]:
        target = docs / on_site(file)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(moved_links(file.read_text(), file))
    for file in [*(root / "docs").rglob("*.png"), *(root / "examples").glob("*/*.png")]:
        target = docs / on_site(file)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(file.read_bytes())


def title_of(page):
    """A page's first heading, or its file's name."""
    found = re.search(r"(?m)^# (.+)$", (docs / page).read_text())
    return found.group(1) if found else page.removesuffix(".md").replace("_", " ")


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
    words = {"number": "number", "integer": "whole number", "boolean": "true or false", "string": "text",
             "object": "table"}
    word = words[s["type"]] if isinstance(s["type"], str) else " or ".join(words[t] for t in s["type"])
    bounds = [f"> {s['exclusiveMinimum']}"] if "exclusiveMinimum" in s else []
    bounds += [f">= {s['minimum']}"] if "minimum" in s else []
    bounds += [f"<= {s['maximum']}"] if "maximum" in s else []
    return f"{word} {', '.join(bounds)}".strip()


def tables(s, path, lines):
    """Rows of one table's keys, then its tables, each under a heading of its own."""
    while "anyOf" in s:
        s = next(way for way in s["anyOf"] if way.get("type") == "object")
    properties = {k: v for k, v in s["properties"].items() if k != "without"}
    rows, inner, units = [], [], {}
    for key, value in properties.items():
        if "x-unit-of" in value:
            units.setdefault(value["x-unit-of"], []).append(key[len(value["x-unit-of"]):])
    for key, value in properties.items():
        if "x-unit-of" in value:
            continue
        below = table_below(value)
        if below is not None:
            inner.append((below[0].format(key), below[1]))
        note = value.get("description", "")
        default = f"`{json.dumps(value['default'])}`" if "default" in value else ""
        suffix = " ".join(f"`{u}`" for u in units.get(key, []))
        rows.append(f"| `{key}` | {'see below' if below else kind_of(value)} | {note} | {default} | {suffix} |")
    if rows:
        lines += ["", "| key | value | unit, notes | default | other units |", "|---|---|---|---|---|", *rows]
    for name, schema in inner:
        full = f"{path}.{name}" if path else name
        lines += ["", f"## {full}"]
        tables(schema, full, lines)


def table_below(s):
    """("name" or "name[]" or "name.NAME", schema) of a key that holds tables."""
    for way in s.get("anyOf", [s]):
        if way.get("type") == "object" and "properties" in way and "maxProperties" not in way:
            return "{}", way
        if way.get("type") == "object" and isinstance(way.get("additionalProperties"), dict) \
                and "properties" in way["additionalProperties"]:
            return "{}.NAME", way["additionalProperties"]
        if way.get("type") == "array" and "properties" in way.get("items", {}):
            return "{}[]", way["items"]
    return None


def reference_scene(section):
    """What the reference scene says under [section...] or [[section...]], with its comments."""
    text = (root / "inputs/reference/scene.toml").read_text()
    blocks = re.split(r"(?m)^(?=\[)", text)
    return "".join(b for b in blocks if re.match(rf"\[\[?{section}[.\]]", b)).strip()


def reference():
    """One page per section of a scene; one for the commands' options. Returns their entries in the navigation."""
    schema = json.loads(subprocess.run([footfall, "schema"], check=True, capture_output=True, text=True).stdout)
    (docs / "keys").mkdir()
    entries, top = [], ["# Keys at the top of a scene"]
    plain = {"properties": {}}
    for key, value in schema["properties"].items():
        below = table_below(value)
        if below is None:
            plain["properties"][key] = value
            continue
        lines = [f"# {below[0].format(key)}", "",
                 "Made from what the reader of scenes knows; the [scene page](../scene.md) tells what the keys mean."]
        tables(below[1], key, lines)
        if example := reference_scene(key):
            lines += ["", "## In the reference scene", "", "```toml", example, "```"]
        (docs / "keys" / f"{key}.md").write_text("\n".join(lines) + "\n")
        entries.append(f"      - {key}: keys/{key}.md")
    tables(plain, "", top)
    (docs / "keys" / "scene.md").write_text("\n".join(top) + "\n")
    entries.insert(0, "      - the scene itself: keys/scene.md")
    return entries


# Families of kinds: the table of docs/scene.md that tells what they are, where their entries stand in a scene, and
# the key that names the kind.
kFamilies = [("Joints", "joints", "type", "theory.md#21-joints"), ("Laws of a strut", "struts", None, "theory.md#3-struts"),
             ("Springs", "springs", "kind", "theory.md#35-springs-between-two-markers"),
             ("Forces", "forces", "frame", "theory.md#36-forces-over-time-and-what-acts-on-a-joints-coordinate"),
             ("Drives", "drives", "kind", "theory.md#37-drives"), ("Controllers", "controllers", "kind", "theory.md#4-controllers"),
             ("Signals", "signals", "kind", "theory.md#41-signals")]


def kinds_told(heading):
    """What the first table below the heading of docs/scene.md tells of (its second head), and {kind: what it is}."""
    text = (root / "docs/scene.md").read_text().split(f"\n## {heading}", 1)[1].split("\n## ", 1)[0]
    table = re.search(r"(?m)^(\| `.*\n)+", text).group(0)
    head = re.findall(r"(?m)^\| [a-z]+ \| (.*?) \|$", text[:text.index(table)])[-1]
    return head, {kind: what for kind, what in re.findall(r"(?m)^\| `([^`]+)` \| (.*?) \|$", table)}


def entry_in_reference(section, key, kind):
    """The first entry [[section]] of the reference scene that is of this kind, or of a law the part [section.kind]."""
    text = (root / "inputs/reference/scene.toml").read_text()
    if key is None:
        found = re.search(rf"(?ms)^\[{section}\.{kind}\].*?(?=^\[|^# ---|\Z)", text)
        return found.group(0).strip() if found else ""
    for block in re.split(rf"(?m)^(?=\[\[{section}\]\])", text)[1:]:
        block = re.split(rf"(?m)^(?:# ---|\[\[(?!{section}[.\]])|\[(?!\[|{section}\.))", block)[0]
        if re.search(rf'(?m)^{key} = "{kind}"', block):
            return block.strip()
    return ""


def rows_of(properties, names, required):
    one, rows = {"properties": {k: v for k, v in properties.items() if k in names or v.get("x-unit-of") in names}}, []
    tables(one, "", rows)
    return [re.sub(r"^(\| `([^`]+)`)", lambda m: m.group(1) + (" (must be given)" if m.group(2) in required else ""), row)
            for row in rows]


def kinds():
    """One page for every kind of joint, law, spring, force, drive, controller and signal. Returns the navigation."""
    schema = json.loads(subprocess.run([footfall, "schema"], check=True, capture_output=True, text=True).stdout)
    (docs / "kinds").mkdir()
    entries = []
    for heading, section, key, theory in kFamilies:
        entries.append(f"      - {heading}:")
        place = schema["properties"][section]
        properties = (place.get("items") or place["additionalProperties"])["properties"]
        of_kinds = schema.get("x-kinds", {}).get(section, {})
        owned = {k for uses in of_kinds.values() for use in uses.values() for k in use}
        head, told = kinds_told(heading)
        for kind, what in told.items():
            lines = [f"# {kind}", "", f"One of the kinds of `[[{section}]]`" + (f", `{key} = \"{kind}\"`." if key else f": its section `{kind}`."),
                     "", f"{head[0].upper() + head[1:]}: {what}", "", f"[All kinds](../scene.md#{slug(heading_of(heading))}), [theory](../{theory}), [all keys](../keys/{section}.md).", ""]
            if key is None:
                lines += ["## Keys"]
                tables(table_below(properties[kind])[1], f"{section}.{kind}", lines)
            else:
                uses = of_kinds.get(kind, {"required": [], "optional": []})
                own = {*uses["required"], *uses["optional"]}
                if own:
                    lines += ["## Keys of this kind", *rows_of(properties, own, uses["required"])]
                common = {k for k, v in properties.items() if k not in owned and k != "without" and "x-unit-of" not in v}
                lines += ["", "## Keys of every kind", *rows_of(properties, common, [])]
            if example := entry_in_reference(section, key, kind):
                lines += ["", "## In the reference scene", "", "```toml", example, "```"]
            name = f"{section}_{kind}.md"
            (docs / "kinds" / name).write_text("\n".join(lines) + "\n")
            entries.append(f"          - {kind}: kinds/{name}")
    return entries


def heading_of(begins):
    """The whole heading of docs/scene.md that begins so."""
    return re.search(rf"(?m)^## ({re.escape(begins)}.*)$", (root / "docs/scene.md").read_text()).group(1)


def slug(heading):
    """The anchor of a heading, as MkDocs makes it."""
    text = re.sub(r"[^\w\s-]", "", heading).strip().lower()
    return re.sub(r"[-\s]+", "-", text)


def commands():
    """One page for every command: what docs/commands.md says of it, and its --help. Returns the navigation."""
    (docs / "options").mkdir()
    told = dict(re.findall(r"(?m)^\| `footfall ([a-z]+)[^|]*` \| (.*?) \|$", (root / "docs/commands.md").read_text()))
    help_text = subprocess.run([footfall, "--help"], check=True, capture_output=True, text=True).stdout
    entries = []
    for name in re.findall(r"(?m)^  ([a-z]+)\s", help_text.split("Subcommands:")[1]):
        options = subprocess.run([footfall, name, "--help"], check=True, capture_output=True, text=True).stdout
        what = re.sub(r"\]\((?![a-z]+:)", "](../", told.get(name, ""))
        text = [f"# footfall {name}", "", what, "", "```text", options.replace(str(root), "CHECKOUT").strip(), "```", "",
                "[Folders, signals, exit codes](../commands.md)"]
        (docs / "options" / f"{name}.md").write_text("\n".join(text) + "\n")
        entries.append(f"          - {name}: options/{name}.md")
    return entries


def api():
    """The page that leads to what doxygen has made beside the site, or says how to make it."""
    text = ["# C++ API", ""]
    if (pages / "cpp/index.html").is_file():
        text += ['<a href="../cpp/index.html">Classes, functions and files of <code>coupler/</code> and <code>mbd_solver/</code></a>, from their comments.']
    else:
        text += ["Doxygen was not there when this site was made. Install Debian's package `doxygen` and make the site again: this page then leads to the",
                 "classes, functions and files of `coupler/` and `mbd_solver/`."]
    (docs / "api.md").write_text("\n".join(text) + "\n")


def experiments():
    """The keys of the files of sweep and accuracy."""
    schema = json.loads(subprocess.run([footfall, "schema", "--experiments"], check=True, capture_output=True, text=True).stdout)
    lines = ["# Files of sweep and accuracy", "", "Made from what the reader of experiments knows. What the keys mean stands in the source, at the end of this page.", ""]
    tables(schema, "", lines)
    header = (root / "mbd_solver/cli/experiments/experiment.h").read_text()
    words = re.findall(r"(?m)^//(.*)$", header[:header.index("#include")])
    lines += ["", "## What the keys mean", "", "```text", *(w.removeprefix(" ") for w in words), "```"]
    (docs / "keys" / "experiments.md").write_text("\n".join(lines) + "\n")


docs.mkdir()
copy_pages()
config = (root / "docs/site/mkdocs.yml").read_text()
named = set(re.findall(r": ([a-z_]+\.md)", config)) | {"api.md"}
examples = sorted(p.name for p in docs.glob("example_*.md"))
others = sorted(p.name for p in docs.glob("*.md") if p.name not in named and p.name not in examples)
lists = {
    "SECTIONS": ["    " + entry for entry in reference()],
    "KINDS": kinds(),
    "COMMANDS": commands(),
    "EXAMPLES": [f"      - {title_of(e)}: {e}" for e in examples],
}
api()
experiments()
for word, entries in lists.items():
    config = config.replace(f" {word}\n", "\n" + "\n".join(entries) + "\n")
if others:  # a page that nobody has put into the order yet
    config += "  - More:\n" + "".join(f"      - {title_of(o)}: {o}\n" for o in others)
config = config.replace("PAGES", str(docs)).replace("SITE", str(site.resolve()))
(pages / "mkdocs.yml").write_text(config)
