"""Commands of a page, run while the page is read, one after the other in a folder of its own.

    .. run::              lines of shell; a command that fails ends the build of the site
       :lines: 12         show that many lines of what was printed (default 20; 0: none)
       :from: VERDICT     show from the first line that begins so

    :printed:`0.661`      a number in the text that one of the page's commands must have printed
"""
import os
import pathlib
import shutil
import subprocess

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.errors import SphinxError
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective, SphinxRole

log = logging.getLogger(__name__)
printed = {}  # page -> all that its commands printed


def folder_of(config, page):
    return pathlib.Path(config.rebound_scratch, page.replace("/", "-"))


def start_page(app, page, _source):
    printed[page] = ""
    shutil.rmtree(folder_of(app.config, page), ignore_errors=True)


class Run(SphinxDirective):
    has_content = True
    option_spec = {"lines": directives.nonnegative_int, "from": directives.unchanged}

    def run(self):
        folder = folder_of(self.config, self.env.docname)
        folder.mkdir(parents=True, exist_ok=True)
        path = os.pathsep.join([str(pathlib.Path(self.config.rebound_program).parent), os.environ["PATH"]])
        run = subprocess.run(["bash", "-euc", "\n".join(self.content)], cwd=folder, text=True,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             env={**os.environ, "PATH": path, "LC_ALL": "C.UTF-8"}, timeout=300)
        if run.returncode != 0:
            raise SphinxError(f"{self.env.docname}: ended with {run.returncode}: "
                              + "\n".join(self.content) + "\n" + run.stdout)
        printed[self.env.docname] += run.stdout
        commands = "\n".join(self.content)
        result = [nodes.literal_block(commands, commands, language="sh", classes=["commands"])]
        shown = self.shown(run.stdout)
        if shown:
            result.append(nodes.literal_block(shown, shown, language="none", classes=["output"]))
        return result

    def shown(self, text):
        lines = text.rstrip().splitlines()
        if "from" in self.options:
            while lines and not lines[0].startswith(self.options["from"]):
                lines.pop(0)
            if not lines:
                raise SphinxError(f"{self.env.docname}: nothing printed begins with {self.options['from']}")
        count = self.options.get("lines", 20)
        return "\n".join(lines[:count] + (["…"] if 0 < count < len(lines) else []))


class Printed(SphinxRole):
    def run(self):
        if self.text not in printed[self.env.docname]:
            log.warning("no command of this page has printed %r", self.text, location=self.get_location())
        return [nodes.strong(self.text, self.text, classes=["printed"])], []


def setup(app):
    app.add_config_value("rebound_program", "", "env")
    app.add_config_value("rebound_scratch", "", "env")
    app.connect("source-read", start_page)
    app.add_directive("run", Run)
    app.add_role("printed", Printed())
    return {}
