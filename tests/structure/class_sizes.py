#!/usr/bin/env python3
"""class_sizes.py [--list N]: no class and no function outgrows what a reader can keep in mind. Counts member functions and data members of every class in
the headers of coupler, liggghts_fix and mbd_solver. --list N: the N largest ones, and the N longest functions of the sources."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
MOST_FUNCTIONS = 30  # declared in the class; constructors, operators and overloads count, "= default" and "= delete" do not
MOST_MEMBERS = 20    # of a class; a struct is data and may have more
MOST_LINES = 110     # of a function


def without_comments_and_texts(text):
    """Of the same length in lines: what a comment, literal or line of the preprocessor says is no code."""
    keep_lines = lambda match: "\n" * match[0].count("\n") or " "
    text = re.sub(r'R"(\w*)\(.*?\)\1"', keep_lines, text, flags=re.S)
    text = re.sub(r"//[^\n]*|/\*.*?\*/", keep_lines, text, flags=re.S)
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", keep_lines, text, flags=re.M)
    return re.sub(r""""(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])'""", "0", text)


def end_of_block(text, start):
    """Behind the brace that closes the one at start."""
    depth = 0
    for i in range(start, len(text)):
        depth += (text[i] == "{") - (text[i] == "}")
        if depth == 0:
            return i + 1
    return len(text)


CLASS = re.compile(r"\b(class|struct)\s+(?:alignas\([^)]*\)\s*)?(\w+)(?:\s+final)?\s*(?::(?!:)[^;{()]*(?:\([^)]*\)[^;{]*)?)?\{")


def statements(body):
    """Declarations at the level of a class: bodies of functions and initializers in braces are left out."""
    out, start, i = [], 0, 0
    while i < len(body):
        if body[i] == "{":
            end = end_of_block(body, i)
            head = body[start:i]
            rest = body[end:].lstrip()
            body = body[:i] + "\0" + body[end:]
            # A function ends with its body; an initializer, and the list of initializers of a constructor, do not.
            if "(" in head and not rest.startswith((";", ",", "{")) and not re.search(r"=\s*$", head):
                out.append(head + "\0")
                start = i + 1
        elif body[i] == ";":
            out.append(body[start:i])
            start = i + 1
        i += 1
    return out


def without_templates(text):
    """std::function<bool(double)> has no parentheses of a function."""
    before = None
    text = re.sub(r"operator\s*(<<|>>|<=|>=|<|>|\(\))", "operator_", text)
    while before != text:
        before = text
        text = re.sub(r"<[^<>;{}]*>", "", text)
    return text


def classes_of(text, outer=""):
    """(kind, name, functions, members) of each class in a text without comments."""
    at = 0
    while match := CLASS.search(text, at):
        if re.search(r"\benum\s*$", text[:match.start()]):
            at = match.end()
            continue
        open_brace = match.end() - 1
        end = end_of_block(text, open_brace)
        body = text[open_brace + 1:end - 1]
        name = outer + match[2]
        yield from classes_of(body, name + "::")
        # Nested types are counted for themselves; an object that is declared together with its type is a member.
        while nested := re.search(r"\b(class|struct|union|enum(?:\s+class)?)\b[^;{()]*\{", body):
            body = body[:nested.start()] + "nested" + body[end_of_block(body, nested.end() - 1):]
        functions = members = 0
        for one in statements(re.sub(r"\b(public|private|protected)\s*:", "", body)):
            one = without_templates(re.sub(r"\[\[[^\]]*\]\]|\balignas\([^)]*\)", "", one)).strip()
            if not one or re.match(r"(using|typedef|friend|template\s*friend|static_assert|nested$|enum|class\s+\w+$|struct\s+\w+$)", one):
                continue
            declared = one.split("=")[0]
            if "(" in declared:
                functions += not re.search(r"=\s*(default|delete)\s*$", one)
            elif not re.match(r"(template\s*)?(inline\s+)?(static\s+)?constexpr\b|static\b", one):
                members += 1 + re.sub(r"\([^()]*\)", "", one).count(",")
        yield match[1], name, functions, members
        at = end


def functions_of(text):
    """(name, lines) of the definitions at the level of a namespace."""
    for match in re.finditer(r"^(?![ \t}#])[^\n;{}]*?([\w:~]+)\([^;{}]*?\)[^;{}()]*(?::[^;]*?)?\{\n", text, re.M):
        open_brace = match.end() - 2
        yield match[1], text.count("\n", open_brace, end_of_block(text, open_brace)) + 1


def sources(suffix):
    for top in ("coupler", "liggghts_fix", "mbd_solver"):
        for path in sorted((root / top).rglob("*" + suffix)):
            if not {"dist", "node_modules"} & set(path.parts):
                yield str(path.relative_to(root)), without_comments_and_texts(path.read_text())


def main():
    found = [(file, *one) for file, text in sources(".h") for one in classes_of(text)]
    if "--list" in sys.argv:
        most = int(sys.argv[sys.argv.index("--list") + 1])
        for title, key in (("functions", 3), ("members", 4)):
            for file, kind, name, functions, members in sorted(found, key=lambda one: -one[key])[:most]:
                print(f"{title}: {file}: {kind} {name}: {functions} functions, {members} members")
        longest = [(lines, file, name) for file, text in sources(".cpp") for name, lines in functions_of(text)]
        for lines, file, name in sorted(longest, reverse=True)[:most]:
            print(f"longest: {file}: {name}: {lines} lines")
        return 0
    failed = len(found) < 400
    if failed:
        print(f"found only {len(found)} classes, expected at least 400: this check is blind")
    for file, kind, name, functions, members in found:
        if functions <= MOST_FUNCTIONS and (members <= MOST_MEMBERS or kind == "struct"):
            continue
        failed = True
        print(f"{file}: {name}: {functions} functions and {members} members, expected at most {MOST_FUNCTIONS} and {MOST_MEMBERS}: "
              "give a part that has an invariant of its own a class of its own")
    for file, text in sources(".cpp"):
        for name, lines in functions_of(text):
            if lines <= MOST_LINES:
                continue
            failed = True
            print(f"{file}: {name}: {lines} lines, expected at most {MOST_LINES}: give its steps functions of their own")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
