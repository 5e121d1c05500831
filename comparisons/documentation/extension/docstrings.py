"""Docstrings of the sources as documentation, and the tests that they name looked for.

    .. docstring:: lumped/laws/hunt_crossley.hpp HuntCrossley     without a name: the file's first
    .. every-law::         a section for each line of lumped/laws/laws.inc
    .. every-material::    a section for each line of fem/interface/elastic_models.inc
    .. every-effect::      a section for each card of comparisons/models/effects
"""
import functools
import json
import pathlib
import re
import subprocess
import sys

from docutils import nodes
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

FIELDS = ("Valid", "Limit", "Caution", "Error", "Errors", "Result", "Source")
log = logging.getLogger(__name__)


def docstring_of(text, name):
    """The lines of `///` above `struct name`, or the first of the file, without their mark."""
    what = rf"(?:template.*\n)?(?:struct|class) {name}\b" if name else ""
    found = re.search(rf"((?:^///.*\n)+){what}", text, re.M)
    if not found:
        raise ValueError(f"no docstring above {name or 'anything'}")
    return [line[3:].removeprefix(" ") for line in found[1].splitlines()]


def parts_of(lines):
    """[(kind, text)]: "text", "formula" (indented lines as they stand), or the name of a field."""
    parts = []
    for line in lines:
        field = re.match(rf"({'|'.join(FIELDS)}):\s*(.*)", line)
        if field:
            parts.append([field[1], field[2]])
        elif not line.strip():
            if parts and parts[-1][0] == "formula":
                parts[-1][1] += "\n"
            else:
                parts.append(["", ""])
        elif line.startswith("  "):
            if parts and parts[-1][0] in FIELDS:
                parts[-1][1] += " " + line.strip()
            elif parts and parts[-1][0] == "formula":
                parts[-1][1] += "\n" + line[2:]
            else:
                parts.append(["formula", line[2:]])
        elif parts and parts[-1][0] == "text":
            parts[-1][1] += " " + line
        else:
            parts.append(["text", line])
    return [(kind, text.strip("\n")) for kind, text in parts if text.strip()]


@functools.lru_cache(maxsize=None)
def text_of_tests(source):
    return "\n".join(file.read_text(encoding="utf-8")
                     for file in pathlib.Path(source, "tests").rglob("*.cpp"))


def missing_tests(text, source):
    """Of the tests that a docstring names ("-> test Suite.Case"), those that are nowhere."""
    missing = []
    for name in re.findall(r"-> tests? ((?:\w+\.)?\w+)", text):
        suite, _, case = name.rpartition(".")
        pattern = rf"\b{suite}\s*,\s*{case}\b" if suite else rf"\b{case}\b"
        if not re.search(pattern, text_of_tests(source)):
            missing.append(name)
    return missing


def rendered(parts):
    """Nodes of a docstring: paragraphs, formulas as they stand, and its fields as a list."""
    result, fields = [], nodes.field_list(classes=["docstring-fields"])
    for kind, text in parts:
        if kind == "text":
            result.append(nodes.paragraph(text, text))
        elif kind == "formula":
            result.append(nodes.literal_block(text, text, classes=["formula"], language="none"))
        else:
            fields += field(kind, text)
    return result + ([fields] if len(fields) else [])


def field(name, text):
    return nodes.field("", nodes.field_name(name, name),
                       nodes.field_body("", nodes.paragraph(text, text)))


def file_of(name):
    """HuntCrossley -> hunt_crossley."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()


class FromSources(SphinxDirective):
    """What all directives of this file share."""

    def docstring(self, path, name=None):
        file = pathlib.Path(self.config.rebound_source, path)
        self.env.note_dependency(str(file))
        lines = docstring_of(file.read_text(encoding="utf-8"), name)
        for test in missing_tests("\n".join(lines), self.config.rebound_source):
            log.warning("%s names the test %s, which is nowhere", path, test, location=self.get_location())
        where = nodes.paragraph("", "", nodes.literal(path, path), classes=["where"])
        return rendered(parts_of(lines)) + [where]

    def section(self, title, identifier, content):
        section = nodes.section(ids=[identifier], names=[nodes.fully_normalize_name(title)])
        section += nodes.title(title, title)
        section += content
        self.state.document.note_explicit_target(section, section)
        return section

    def names_in(self, list_file, macro):
        text = pathlib.Path(self.config.rebound_source, list_file).read_text(encoding="utf-8")
        return re.findall(rf"^{macro}\((.*)\)$", text, re.M)


class Docstring(FromSources):
    required_arguments = 1
    optional_arguments = 1

    def run(self):
        return self.docstring(*self.arguments)


class EveryLaw(FromSources):
    def run(self):
        sections = []
        for name in self.names_in("lumped/laws/laws.inc", "REBOUND_LAW"):
            title = file_of(name).replace("_", "-")
            sections.append(self.section(title, f"law-{title}",
                                         self.docstring(f"lumped/laws/{file_of(name)}.hpp", name)))
        return sections


class EveryMaterial(FromSources):
    def run(self):
        sections = []
        for line in self.names_in("fem/interface/elastic_models.inc", "REBOUND_ELASTIC_MODEL"):
            name, file, title = re.match(r'(\w+), (\w+), "([^"]+)"', line).groups()
            sections.append(self.section(title, f"material-{title}",
                                         self.docstring(f"fem/materials/{file}.hpp", name)))
        return sections


class EveryEffect(FromSources):
    """From the cards, as the Python module hands them out."""

    def run(self):
        folder = pathlib.Path(self.config.rebound_program).parent
        cards = json.loads(subprocess.run(
            [sys.executable, "-c", "import json, rebound_impact as r; print(json.dumps(r.effects()))"],
            env={"PYTHONPATH": str(folder)}, capture_output=True, check=True, text=True).stdout)
        families = dict.fromkeys(card["family"] for card in cards)
        return [self.section(family.capitalize(), f"effects-{family}",
                             [self.effect(card) for card in cards if card["family"] == family])
                for family in families]

    def effect(self, card):
        fields = nodes.field_list(classes=["docstring-fields"])
        unit = f" {card['unit']}" if card["unit"] else ""
        ends = [f"{words} {card[key]:g}{unit}" for words, key in (("from", "lowest"), ("to", "highest"))
                if card[key] is not None]
        null = "at infinity" if card["null"] is None else f"at {card['null']:g}{unit}"
        fields += field("Size s", f"{' '.join(ends) or 'any'}; no effect {null}")
        for parameter in card["parameters"]:
            fields += field("Parameter", f"{parameter['name']} [{parameter['unit'] or '1'}]: {parameter['sentence']}")
        fields += field("Acts on", ", ".join(card["acts_on"]) or "the measurement alone")
        for title, key in (("Shows in", "signature"), ("Test", "experiment"), ("Source", "source")):
            if card[key]:
                fields += field(title, card[key])
        return self.section(card["name"], f"effect-{card['name']}", [
            nodes.paragraph(card["sentence"], card["sentence"]),
            nodes.literal_block(card["equation"], card["equation"], classes=["formula"], language="none"),
            fields])


def setup(app):
    app.add_config_value("rebound_source", "", "env")
    app.add_directive("docstring", Docstring)
    app.add_directive("every-law", EveryLaw)
    app.add_directive("every-material", EveryMaterial)
    app.add_directive("every-effect", EveryEffect)
    return {}
