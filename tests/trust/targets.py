"""Every command with a file that it reads, small enough to run in a fraction of a second where it is right."""
import dataclasses
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "output_schemas"))
import cases  # noqa: E402  (the files that the tests of the output schemas use)

RICH_LUMPED = """schema = 1
[impact]
speed = "5 m/s"
separation = "zero-force"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
exponent = 1.5
stiffness = "3.5e6 N/m^1.5"
damping = "17.63e4 N.s/m^2.5"
[[model.at_speed]]
speed = "5 m/s"
damping = "37.69e4 N.s/m^2.5"
[model.plate]
stiffness = "50 MN/m"
mass = "2 kg"
damping_ratio = 0.02
[[model.effect]]
name = "relaxation"
size = 0.1
relaxation_time = "0.5 ms"
[controls]
relative_tolerance = 1e-9
samples = 101
"""
RICH_FEM = """schema = 1
[impact]
speed = "5 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 60
[model.material]
elastic = "mooney-rivlin"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
modulus = "long-term"
second_share = 0.2
[[model.material.branch]]
ratio = 0.3
relaxation_time = "0.3 ms"
relaxes = "deviator"
[[model.material.layer]]
from = 0.8
modulus_factor = 2.0
[model.plate]
friction = 0.3
stiffness = "50 MN/m"
mass = "2 kg"
damping_ratio = 0.02
[model.adhesion]
work = "1 J/m^2"
"""
PLAN = """schema = 1
name = "a plan"
seed = 5
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.2e6 N/m^1.5"
damping = "7e4 N.s/m^2.5"
[instrument]
force_noise = "20 N"
force_gain_uncertainty = 0.01
force_bandwidth = "20 kHz"
contact_threshold = "10 N"
camera_rate = "4000 Hz"
[[shot]]
speed = "5 m/s"
speed_uncertainty = "0.02 m/s"
[[shot]]
speed = "15 m/s"
repeats = 2
"""
MEMBERS = """schema = 1
base = "lumped.toml"
[design]
kind = "grid"
[[design.factor]]
key = "impact.speed"
low = "1 m/s"
high = "30 m/s"
points = 3
"""


@dataclasses.dataclass(frozen=True)
class Target:
    """A command line in which {file} is damaged; `source` lies in the folder of the test."""
    name: str
    arguments: tuple
    source: str
    schema: str = ""       # of `rebound schema`; empty: none
    effective: bool = False  # --out leaves effective.toml, which is held against the file
    slow: bool = False     # run it only where the file is bad by an independent reading


TARGETS = [
    Target("lumped", ("lumped", "{file}"), "lumped.toml", "lumped", True),
    Target("lumped-rich", ("lumped", "{file}", "--sensitivities"), "rich_lumped.toml", "lumped", True),
    Target("fem", ("fem", "{file}"), "fem.toml", "fem", True),
    Target("fem-rich", ("fem", "{file}"), "rich_fem.toml", "fem", True),
    Target("reference", ("fem", "{file}", "--reference"), "fem.toml", "fem", slow=True),
    Target("compress", ("compress", "{file}"), "compression.toml", "compress", True),
    Target("export", ("export", "{file}", "--to", "febio"), "fem.toml", "fem"),
    Target("audit", ("benchmark", "--audit", "{file}"), "fem.toml", "fem", slow=True),
    Target("drop", ("drop", "{file}"), "lumped.toml", "lumped"),
    Target("calibrate", ("calibrate", "{file}"), "calibrate.toml", "calibrate"),
    Target("calibrate-scalars", ("calibrate", "{file}"), "scalars.toml", "calibrate"),
    Target("calibrate-material", ("calibrate", "{file}"), "material.toml", "calibrate-material", slow=True),
    Target("select", ("select", "{file}"), "select.toml", "select"),
    Target("benchmark", ("benchmark", "{file}"), "benchmark.toml", "benchmark"),
    Target("atlas", ("atlas", "{file}"), "grid.toml", "atlas"),
    Target("convert", ("convert", "{file}"), "convert.toml", "convert"),
    Target("compare", ("compare", "{file}"), "compare.toml", "compare", slow=True),
    Target("campaign", ("campaign", "{file}"), "members.toml", "campaign"),
    Target("synthesize", ("synthesize", "{file}"), "synthesis.toml", "synthesis"),
    Target("design", ("design", "{file}"), "rich_plan.toml", "synthesis", slow=True),
    Target("inspect", ("inspect", "{folder}"), "experiment/data/dataset.toml", "dataset"),
    Target("inspect-drops", ("inspect", "{folder}"), "drops/dataset.toml", "dataset"),
    Target("diagnose", ("diagnose", "experiment/data", "--model", "{file}"), "lumped.toml", "lumped", slow=True),
    Target("diagnose-data", ("diagnose", "{folder}", "--model", "lumped.toml"), "experiment/data/dataset.toml",
           "dataset", slow=True),
    Target("study", ("study", "{file}"), "study.toml", "study", slow=True),
]


class Bench:
    """A folder with every file that the targets need."""

    def __init__(self, program, study, folder):
        self.program, self.folder = program, pathlib.Path(folder)
        self.call("init", "--out", ".")
        files = cases.files(self.folder)
        files["fem.toml"] = files["fem.toml"].replace("cells = 150", "cells = 60")
        files.update({"rich_lumped.toml": RICH_LUMPED, "rich_fem.toml": RICH_FEM, "rich_plan.toml": PLAN,
                      "members.toml": MEMBERS})
        data = pathlib.Path(study).resolve().parent / "../../comparisons/studies/data"
        shutil.copytree(data, self.folder / "data")
        files["study.toml"] = pathlib.Path(study).read_text(encoding="utf-8").replace(
            "../../comparisons/studies/data", "data")
        for name, text in files.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        self.call("lumped", "lumped.toml", "--out", "reference")
        self.call("fem", "fem.toml", "--out", "soft")
        self.call("init", "dataset", "--from", "drops.csv", "--mass", "89.6 g", "--diameter", "66.2 mm")
        self.call("synthesize", "synthesis.toml", "--out", "experiment")

    def call(self, *arguments):
        subprocess.run([self.program, *arguments], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def place(self, target, text, name):
        """Puts a damaged file beside the right one; the command line that reads it."""
        source = pathlib.Path(target.source)
        if len(source.parts) > 1:
            folder = self.folder / name
            shutil.copytree(self.folder / source.parent, folder)
            damaged = folder / source.name
        else:
            damaged = self.folder / (name + source.suffix)
        damaged.write_bytes(text)
        relative = damaged.relative_to(self.folder)
        words = {"file": str(relative), "folder": str(relative.parent)}
        return damaged, [argument.format(**words) for argument in target.arguments]
