"""`pip install .` without network, from the build there is, into a folder of its own.

usage: wheel_test.py SOURCE-FOLDER BUILD-FOLDER
"""
import os
import pathlib
import subprocess
import sys
import tempfile

source, build = sys.argv[1:]
USE = """
import pathlib, sys
import rebound_impact as ri
assert pathlib.Path(ri.__file__).parent == pathlib.Path(sys.argv[1]), ri.__file__
core = dict(sphere={"mass": 0.0896, "diameter": 0.0662}, impact={"speed": 1})
law = {"law": "hunt-crossley", "exponent": 1.5, "stiffness": 3.5e6, "damping": 0}
print(f"{ri.lumped(**core, model=law).restitution:.6f}")
if ri.has_fem():  # its library is the one that came with it
    material = {"elastic": "neo-hookean", "youngs_modulus": 1e7, "poisson_ratio": 0.4}
    assert ri.fem(**core, model={"cells": 100, "material": material}).restitution_momentum > 0.9
    maps = pathlib.Path("/proc/self/maps").read_text()
    assert sys.argv[1] + "/librebound_fem.so" in maps, "another library was loaded"
"""

with tempfile.TemporaryDirectory() as folder:
    folder = os.path.realpath(folder)
    subprocess.run([sys.executable, "-m", "pip", "install", source, "--no-build-isolation", "--no-index",
                    "--no-deps", "--target", folder, "--config-settings", f"build-folder={build}"],
                   check=True)
    environment = dict(os.environ, PYTHONPATH=folder)
    used = subprocess.run([sys.executable, "-c", USE, folder], env=environment, cwd=folder,
                          capture_output=True, text=True)
    print(used.stdout, used.stderr)
    assert used.returncode == 0, used.returncode
    assert used.stdout == "1.000000\n", used.stdout
