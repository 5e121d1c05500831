"""Command lines whose --json output stands for all that a command prints, and the files they need."""
import json
import subprocess

RESTITUTION = """schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[given]
convention = "restitution"
stiffness = "3.5e6 N/m^1.5"
restitution = 0.5
"""
GRID = """schema = 1
speeds = [0.03, 0.08]
loss_factors = [0.1]
poisson_ratios = [0.4]
relaxation_times = [0.1]
cells = 100
"""
MATERIAL = """schema = 1
tier = "fem"
model = "fem.toml"
starts = 1
free = ["branch[0].ratio"]
folders = ["soft"]
profiles = "all"
"""
DROPS = """drop [cm];rebound [cm];rebound sd [cm];repeats
80;63,83;0,47;10
100;79,02;0,73;10
"""
SCALARS = """schema = 1
law = "kuwabara-kono"
observable = "scalars"
profiles = "all"
[fixed]
stiffness = "2e6 N/m^1.5"
[[reference]]
folder = "drops"
"""


def files(folder):
    """What the cases need and `init` does not write."""
    def without_branch(text):
        return text[:text.index("[[model.material.branch]]")] + text[text.index("[controls]"):]

    fem = (folder / "fem.toml").read_text(encoding="utf-8").replace("cells = 1000", "cells = 150")
    plan = (folder / "synthesis.toml").read_text(encoding="utf-8")

    def with_hysteresis(size, mass):
        head, rest = plan[:plan.index("[[model.effect]]")], plan[plan.index("[instrument]"):]
        effect = f'[[model.effect]]\nname = "hysteresis"\nsize = {size}\n'
        return head.replace("89.6 g", mass) + effect + rest

    plateau = fem.replace("poisson_ratio", "strain_softening = 0.9\npoisson_ratio")
    return {"plateau.toml": without_branch(plateau), "light.toml": with_hysteresis(0.1, "90 g"), "heavy.toml": with_hysteresis(0.3, "110 g"),
            "convert.toml": RESTITUTION, "grid.toml": GRID, "material.toml": MATERIAL, "drops.csv": DROPS,
            "scalars.toml": SCALARS, "fem.toml": fem, "elastic.toml": without_branch(fem),
            "plan.toml": plan[:plan.index("[[model.effect]]")] + plan[plan.index("[instrument]"):]}


# In this order, in one folder: a case may use what an earlier one has written.
CASES = [
    ["init", "--out", "."],
    ["init", "--list"],
    ["lumped", "lumped.toml", "--out", "reference"],
    ["lumped", "lumped.toml", "--sensitivities"],
    ["fem", "fem.toml", "--out", "soft"],
    ["fem", "fem.toml", "--reference"],
    ["fem", "elastic.toml"],
    ["fem", "plateau.toml"],
    ["compress", "compression.toml"],
    ["mesh", "--diameter", "66.2 mm", "--cells", "200"],
    ["mesh", "--diameter", "66.2 mm", "--cells", "200", "--out", "ball.msh"],
    ["mesh", "ball.msh"],
    ["mesh", "--diameter", "66.2 mm", "--cells", "200", "--compare"],
    ["init", "dataset", "--from", "drops.csv", "--mass", "89.6 g", "--diameter", "66.2 mm"],
    ["calibrate", "calibrate.toml", "--out", "calibrated"],
    ["calibrate", "scalars.toml"],
    ["calibrate", "material.toml"],
    ["drop", "lumped.toml"],
    ["drop", "calibrated"],
    ["drop", "fem.toml"],
    ["select", "select.toml"],
    ["benchmark", "benchmark.toml"],
    ["benchmark", "--audit", "fem.toml"],
    ["atlas", "grid.toml", "--out", "atlas"],
    ["convert", "convert.toml"],
    ["convert", "convert.toml", "--to", "simbody", "--fem", "fem.toml", "--speeds", "15 m/s"],
    ["convert", "convert.toml", "--to", "ode"],
    ["export", "elastic.toml", "--to", "calculix", "--out", "ccx"],
    ["export", "fem.toml", "--to", "febio", "--out", "febio"],
    ["compare", "compare.toml"],
    ["compare", "compare.toml", "--baseline", "kept", "--record"],
    ["compare", "compare.toml", "--baseline", "kept"],
    ["verify", "--tier", "lumped"],
    ["synthesize", "synthesis.toml", "--out", "experiment"],
    ["inspect", "experiment/data"],
    ["inspect", "drops"],
    ["diagnose", "experiment/data", "--model", "lumped.toml"],
    ["diagnose", "drops", "--model", "lumped.toml"],
    ["synthesize", "plan.toml", "--out", "nothing"],
    ["diagnose", "nothing/data", "--model", "lumped.toml", "--no-fem"],
    ["synthesize", "light.toml", "--out", "light"],
    ["synthesize", "heavy.toml", "--out", "heavy"],
    ["diagnose", "light/data", "heavy/data", "--model", "lumped.toml", "--no-fem"],
    ["design", "plan.toml", "--experiments", "1", "--effect", "strain-stiffening"],
    ["trials", "blind", "--count", "2"],
    ["trials", "blind"],
    ["campaign", "campaign.toml", "--out", "store"],
    ["campaign", "query", "campaign.toml", "--out", "store", "--csv", "campaign.csv"],
    ["reproduce"],
    ["study", "{study}", "--out", "study"],
    ["schema", "lumped"],
    ["completion", "bash"],
    ["completion", "--out", "share"],
    ["doctor"],
]


class Outputs:
    """Runs the cases; `of` gives [(command line, printed object)] of one command."""

    def __init__(self, program, trial_generator, study, folder):
        self.program, self.folder, self.printed = program, folder, []
        subprocess.run([trial_generator, "--out", "blind", "--count", "3", "--seed", "3", "--only", "null"],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        for case in CASES:
            arguments = [argument.format(study=study) for argument in case]
            self.printed.append((case, self.run(arguments)))
            if case == CASES[0]:
                for name, text in files(folder).items():
                    (folder / name).write_text(text, encoding="utf-8")

    def run(self, arguments, expected=(0, 1)):
        run = subprocess.run([self.program, *arguments, "--json"], cwd=self.folder, capture_output=True, text=True)
        if run.returncode not in expected:
            raise RuntimeError(f"{arguments}: {run.returncode}\n{run.stdout[:2000]}{run.stderr}")
        return json.loads(run.stdout)

    def of(self, command):
        return [(case, printed) for case, printed in self.printed if case[0] == command]
