"""Pictures of the reports that a page's commands wrote, taken by a browser while the page is read.

    .. picture:: fem/report.html
       :titled: Force over      what to show: the first figure whose heading begins so
       :alt: what is to be seen
       :width: 760              of the window in which the report is opened

       Caption, one sentence.

    .. gallery::                all pictures of the site, each with its page

Each is taken light and dark; the whole report goes with the site and is linked.
"""
import json
import pathlib
import re
import shutil

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.errors import SphinxError
from sphinx.util.docutils import SphinxDirective
from sphinx.util.osutil import relative_uri

from browser import Browser
from tutorials import folder_of


# A picture cannot be pressed.
BUTTONS = ".modebar-container, button.copy { display: none }"


def figure_titled(title):
    """JavaScript that finds it, with its legend where it has one to itself."""
    return f"""(() => {{
      const figure = [...document.querySelectorAll("figure")].find((one) =>
        one.querySelector("h3")?.textContent.startsWith({json.dumps(title)}));
      const group = figure?.closest(".figures");
      return group?.querySelectorAll("figure").length === 1 ? group : figure;
    }})()"""


class picture(nodes.General, nodes.Element):
    """Attributes: name (file without ending), report, alt, caption, page."""


class gallery(nodes.General, nodes.Element):
    pass


class Picture(SphinxDirective):
    has_content = True
    required_arguments = 1
    option_spec = {"titled": directives.unchanged_required, "alt": directives.unchanged_required,
                   "width": directives.positive_int}

    def run(self):
        app, page = self.env.app, self.env.docname
        report = folder_of(self.config, page) / self.arguments[0]
        if not report.is_file():
            raise SphinxError(f"{page}: no command has written {self.arguments[0]}")
        place = f"{page}-{self.arguments[0]}".replace("/", "-").removesuffix(".html")
        copy = pathlib.Path(app.outdir, "_reports", place + ".html")
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(report, copy)
        name = re.sub(r"\W+", "-", f"{place}-{self.options['titled']}")
        for dark in (False, True):
            self.take(report, dark,
                      pathlib.Path(app.outdir, "_pictures", f"{name}-{'dark' if dark else 'light'}.png"))
        node = picture(name=name, report=place + ".html", alt=self.options["alt"],
                       caption=" ".join(self.content), page=page)
        pictures_of(self.env).setdefault(page, []).append(node)
        return [node]

    def take(self, report, dark, file):
        app = self.env.app
        if not hasattr(app, "rebound_browser"):
            app.rebound_browser = Browser(self.config.rebound_chromium)
        app.rebound_browser.open(report, self.options.get("width", 760), dark)
        if app.rebound_browser.complaints:
            raise SphinxError(f"{report}: {app.rebound_browser.complaints}")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(app.rebound_browser.picture(figure_titled(self.options["titled"]), without=BUTTONS))


class Gallery(SphinxDirective):
    def run(self):
        return [gallery()]


def pictures_of(env):
    if not hasattr(env, "rebound_pictures"):
        env.rebound_pictures = {}
    return env.rebound_pictures


def html_of(translator, node, link, words):
    """One figure; its picture follows the reader's screen."""
    builder = translator.builder
    here = builder.get_target_uri(builder.current_docname)

    def to(target):
        return relative_uri(here, target)

    escape = translator.attval
    return (f'<figure class="picture"><a href="{to(link)}"><picture>'
            f'<source srcset="{to("_pictures/" + node["name"])}-dark.png" media="(prefers-color-scheme: dark)">'
            f'<img src="{to("_pictures/" + node["name"])}-light.png" alt="{escape(node["alt"])}" loading="lazy">'
            f'</picture></a><figcaption>{translator.encode(node["caption"])} '
            f'<a href="{to(link)}">{words}</a></figcaption></figure>\n')


def visit_picture(translator, node):
    translator.body.append(html_of(translator, node, "_reports/" + node["report"], "The whole report."))
    raise nodes.SkipNode


def visit_gallery(translator, _node):
    builder = translator.builder
    translator.body.append('<div class="gallery">')
    for page, pictures in sorted(pictures_of(builder.env).items()):
        for node in pictures:
            translator.body.append(html_of(translator, node, builder.get_target_uri(page), "How it was made."))
    translator.body.append("</div>\n")
    raise nodes.SkipNode


def forget(_app, env, page):
    pictures_of(env).pop(page, None)


def close_browser(app, _error):
    if hasattr(app, "rebound_browser"):
        app.rebound_browser.__exit__()


def setup(app):
    app.add_config_value("rebound_chromium", "", "env")
    app.add_directive("picture", Picture)
    app.add_directive("gallery", Gallery)
    app.add_node(picture, html=(visit_picture, None))
    app.add_node(gallery, html=(visit_gallery, None))
    app.connect("env-purge-doc", forget)
    app.connect("build-finished", close_browser)
    return {}
