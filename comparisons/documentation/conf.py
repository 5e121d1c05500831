"""How Sphinx makes the site. Its sources are the copy of `pages/` that build.py made."""
import os
import pathlib
import sys

room = pathlib.Path(__file__).parent
sys.path.insert(0, str(room / "extension"))

project = "Rebound"
copyright = "the authors of Rebound"
extensions = ["equations", "docstrings", "tutorials", "pictures", "program_reference"]
rebound_source = str(room.parent.parent)
rebound_program = os.environ["REBOUND_PROGRAM"]
rebound_chromium = os.environ["REBOUND_CHROMIUM"]
rebound_scratch = os.environ["REBOUND_SCRATCH"]

nitpicky = True
html_theme = "rebound"
html_theme_path = [str(room / "theme")]
html_math_renderer = "mathml"
html_copy_source = False
html_show_sphinx = False
html_use_index = False
highlight_language = "none"
