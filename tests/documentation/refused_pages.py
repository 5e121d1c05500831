"""Pages with one fault each: the site must not be built from them.

usage: refused_pages.py SCRATCH-FOLDER COMMAND...   the command takes a folder for the site and one of pages
"""
import pathlib
import shutil
import subprocess
import sys

scratch, command = pathlib.Path(sys.argv[1]), sys.argv[2:]
GOOD = """Title
=====

.. toctree::

   reference/commands/index
   reference/files/index
   reference/output/index

.. math::

   F = k x

.. run::

   rebound init lumped --out first
   rebound lumped first/lumped.toml

It returns :printed:`0.661`.

.. docstring:: lumped/laws/hunt_crossley.hpp HuntCrossley
"""
FAULTS = {
    "a link that leads nowhere": GOOD + "\nSee :doc:`nowhere`.\n",
    "a command that fails": GOOD.replace("rebound lumped first", "rebound lumped second"),
    "a number that was not printed": GOOD.replace("0.661", "0.662"),
    "an equation that cannot be drawn": GOOD.replace("F = k x", r"\unknown{F} = k x"),
    "a docstring that is not there": GOOD.replace("HuntCrossley", "HuntCrosley"),
    "a picture of nothing": GOOD + "\n.. picture:: first/report.html\n   :titled: Force\n   :alt: none\n",
}


def is_built(text):
    shutil.rmtree(scratch, ignore_errors=True)
    (scratch / "pages").mkdir(parents=True)
    (scratch / "pages" / "index.rst").write_text(text, encoding="utf-8")
    run = subprocess.run([*command, scratch / "site", scratch / "pages"], capture_output=True, text=True)
    return run.returncode == 0, run.stderr


built, errors = is_built(GOOD)
assert built, errors
for name, text in FAULTS.items():
    built, errors = is_built(text)
    print(f"{name}: {'built' if built else errors.strip().splitlines()[0][:150] if errors.strip() else 'refused'}")
    assert not built, f"the site was built with {name}"
