"""Pages that the program itself writes: commands, keys of its files, keys of what it prints.

Made before Sphinx looks for pages, in the folder `reference` beside the copied ones:
`--help` gives the commands and the keys of their files, `rebound schema` the rest.
"""
import json
import pathlib
import re
import subprocess

KEY = re.compile(r"^  (\S+)  \[(.*)\]$")
CASE = re.compile(r'^  with (".*"):$')
SECTION = re.compile(r"^(\[\[?[\w.]+\]\]?)  (.*)$")


def ask(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, check=True, text=True).stdout


def commands_of(program):
    """[(name, what it is for)], in the order of --help."""
    listed = ask(program, "--help").split("Subcommands:\n")[1].split("\n\n")[0]
    return [tuple(line.strip().split(maxsplit=1)) for line in listed.splitlines()]


def formats_of(program):
    """Formats of files: `schema` takes names of commands too, for what they print."""
    names = re.search(r"FORMAT TEXT:\{(.*?)\}", ask(program, "schema", "--help"))[1].split(",")
    return [name for name in names
            if subprocess.run([program, "schema", name], capture_output=True, check=False).returncode == 0]


def escaped(text):
    return re.sub(r"([\\`*|_])", r"\\\1", text)


def heading(text, mark):
    return f"{text}\n{mark * len(text)}\n\n"


def literal(text):
    return "::\n\n" + "".join(f"   {line}\n" if line else "\n" for line in text.splitlines()) + "\n"


def keys_page(lines):
    """Keys as --help lists them: tables of a file as sections, keys as definitions."""
    page, pending = [], False
    for line in lines:
        section, case, key = SECTION.match(line), CASE.match(line), KEY.match(line)
        if section:
            page.append("\n" + heading(section[1], "-") + escaped(section[2]) + "\n\n")
        elif case:
            page.append(f"\n.. rubric:: with {case[1]}\n\n")
        elif key:
            page.append(f"``{key[1]}`` — {escaped(key[2])}\n")
            pending = True
        elif pending and line.startswith("      "):
            page.append(f"   {escaped(line.strip())}\n\n")
            pending = False
        elif line.strip():
            page.append(escaped(line.strip()) + "\n\n")
    return "".join(page)


def command_page(name, purpose, help_text):
    """(page of the command, page of the keys of its file or None)."""
    usage = help_text.split("\nExit codes:")[0].rstrip()
    usage, *keys = re.split(r"^(?=Keys of )", usage, maxsplit=1, flags=re.M)
    page = (f".. _command-{name}:\n\n" + heading(f"rebound {name}", "=") + escaped(purpose[0].upper() + purpose[1:])
            + ".\n\n" + literal(usage.split("\n", 1)[1].strip()))
    page += f"What ``--json`` prints: :ref:`output-{name}`.\n\n"
    if not keys:
        return page, None
    page += f"Keys of its file: :ref:`file-{name}`.\n"
    return page, (f".. _file-{name}:\n\n" + heading(f"File of rebound {name}", "=")
                  + f"Of the command :ref:`command-{name}`. A quantity is text with its unit; behind each key stand "
                  "what is allowed, and its default.\n\n" + keys_page(keys[0].splitlines()))


def resolved(schema, root):
    while "$ref" in schema:
        keys = schema["$ref"].removeprefix("#/").split("/")
        schema = root
        for key in keys:
            schema = schema[key]
    return schema


def kind_of(schema):
    if "enum" in schema:
        return " | ".join("null" if value is None else str(value) for value in schema["enum"])
    if "const" in schema:
        return str(schema["const"])
    if "x-allowed" in schema:
        return schema["x-allowed"]
    kind = schema.get("type", "one of several" if "anyOf" in schema or "oneOf" in schema else "anything")
    words = " or ".join(kind) if isinstance(kind, list) else kind
    return f"{words} [{schema['x-unit']}]" if "x-unit" in schema else words


def schema_rows(schema, root, path="", depth=0):
    """Definitions of all keys below a schema, by their path; `[]` stands for each of a list."""
    schema = resolved(schema, root)
    for choice in schema.get("anyOf", []) + schema.get("oneOf", []):
        yield from schema_rows(choice, root, path, depth)
    if isinstance(schema.get("items"), dict):
        yield from schema_rows(schema["items"], root, path + "[]", depth)
    needed = schema.get("required", [])
    for name, value in schema.get("properties", {}).items():
        inner = resolved(value, root)
        place = f"{path}.{name}" if path else name
        words = "" if name in needed else "; not always there"
        sentence = value.get("description") or inner.get("description") or ""
        yield f"``{place}`` — {escaped(kind_of(inner))}{words}\n   {escaped(sentence) or '..'}\n\n"
        if depth < 6:
            yield from schema_rows(inner, root, place, depth + 1)


def schema_page(label, title, introduction, schema):
    rows = dict.fromkeys(schema_rows(schema, schema))
    return f".. _{label}:\n\n" + heading(title, "=") + introduction + "\n\n" + "".join(rows)


def contents(title, introduction, names):
    return heading(title, "=") + introduction + "\n\n.. toctree::\n   :maxdepth: 1\n\n" + \
        "".join(f"   {name}\n" for name in names)


def write(app):
    program, folder = app.config.rebound_program, pathlib.Path(app.srcdir, "reference")
    formats = formats_of(program)
    pages, files, outputs = {}, [], []
    commands = commands_of(program)
    for name, purpose in commands:
        pages[f"commands/{name}"], keys = command_page(name, purpose, ask(program, name, "--help"))
        if keys:
            pages[f"files/{name}"] = keys
            files.append(name)
        schema = json.loads(ask(program, "schema", name, "--output"))
        pages[f"output/{name}"] = schema_page(f"output-{name}", f"Output of rebound {name}", escaped(
            schema["description"]) + f"\n\nAs JSON schema: ``rebound schema {name} --output``.", schema)
        outputs.append(name)
    for name in sorted(set(formats) - set(files) - {"synthesis"}):
        schema = json.loads(ask(program, "schema", name))
        pages[f"files/{name}"] = schema_page(f"file-{name}", f"File {name}", escaped(schema["title"])
                                             + f".\n\nAs JSON schema: ``rebound schema {name}``.", schema)
        files.append(name)
    pages["commands/index"] = contents("Commands", "What ``--help`` says of each.", [n for n, _ in commands])
    pages["files/index"] = contents("Files", "Every key of every file that the program reads, from the tables it "
                                    "reads them with.", sorted(files))
    pages["output/index"] = contents("Output", "Every key that ``--json`` prints, from the schemas that the tests "
                                     "hold real output against.", outputs)
    for name, text in pages.items():
        file = folder / (name + ".rst")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def setup(app):
    app.connect("builder-inited", write)
    return {}
