"""The built site: every link leads somewhere, nothing comes from a network, every page can be read.

usage: check_site.py HTML-FOLDER CHROMIUM EXTENSION-FOLDER
"""
import html.parser
import pathlib
import re
import sys
import unittest
import urllib.parse

SITE, CHROMIUM, EXTENSION = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
sys.path.insert(0, EXTENSION)
from browser import Browser  # noqa: E402

LOADED = {("img", "src"), ("img", "srcset"), ("source", "srcset"), ("script", "src"), ("link", "href"), ("iframe", "src")}


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.identifiers, self.links, self.loaded, self.equations, self.words = set(), [], [], 0, 0
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        self.equations += tag == "math"
        for name, value in attributes:
            if name == "id":
                self.identifiers.add(value)
            if (tag, name) in LOADED:
                self.loaded.append(value)
            if tag == "a" and name == "href":
                self.links.append(value)

    def handle_data(self, data):
        self.words += len(data.split())


# Reports are pages of their own, tested in tests/browser.
PAGES = {file: Page(file) for file in sorted(SITE.rglob("*.html")) if "_reports" not in file.parts}


class Site(unittest.TestCase):
    def test_links_lead_somewhere(self):
        followed = 0
        for file, page in PAGES.items():
            for link in page.links + page.loaded:
                place = urllib.parse.urlparse(link)
                if place.scheme in ("http", "https", "data"):
                    continue
                target = (file.parent / urllib.parse.unquote(place.path)).resolve() if place.path else file
                self.assertTrue(target.is_file(), f"{file.relative_to(SITE)}: {link}")
                if place.fragment and target in PAGES:
                    self.assertIn(place.fragment, PAGES[target].identifiers, f"{file.relative_to(SITE)}: {link}")
                followed += 1
        self.assertGreater(followed, 1000)

    def test_nothing_is_loaded_from_a_network(self):
        for file, page in PAGES.items():
            for address in page.loaded:
                self.assertNotRegex(address, r"^(https?:)?//", str(file))
        for file in [*SITE.rglob("*.css"), *SITE.rglob("_static/*.js")]:
            text = file.read_text(encoding="utf-8")
            self.assertNotRegex(text, r"url\(\s*['\"]?(https?:)?//|@import", str(file))

    def test_what_must_be_there(self):
        def page(name):
            return PAGES[SITE / f"{name}.html"]

        self.assertGreater(page("theory/laws").equations, 15)
        self.assertGreater(page("theory/diagnosis").equations, 5)
        pictures = [address for address in page("gallery").loaded if address.startswith("_pictures")]
        self.assertGreater(len(pictures), 16, "light and dark")
        for folder in ("commands", "files", "output"):
            self.assertGreater(len(list((SITE / "reference" / folder).glob("*.html"))), 13)
        for file, one in PAGES.items():
            self.assertGreater(one.words, 20, str(file))

    def test_pages_can_be_read(self):
        """On a telephone nothing is wider than the screen; no complaint, no request but for files, drawn equations."""
        with Browser(CHROMIUM) as browser:
            for file, page in PAGES.items():
                for dark in (False, True):
                    browser.open(file, 390, dark)
                    self.assertEqual(browser.evaluate("document.documentElement.scrollWidth"), 390, str(file))
                    self.assertEqual(browser.complaints, [], str(file))
                    asked = [one for one in browser.requests if not re.match("file:|data:|about:", one)]
                    self.assertEqual(asked, [], str(file))
                self.assertEqual(browser.evaluate(
                    "[...document.querySelectorAll('math')].filter(m => m.getBoundingClientRect().width > 4).length"),
                    page.equations, str(file))
                contrast = browser.evaluate("getComputedStyle(document.body).color + getComputedStyle(document.body).backgroundColor")
                self.assertEqual(contrast, "rgb(230, 233, 236)rgb(20, 25, 30)", f"{file} in the dark")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
