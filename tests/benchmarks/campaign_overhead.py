#!/usr/bin/env python3
"""What a lumped campaign costs beside its impacts.

    python3 tests/benchmarks/campaign_overhead.py build/rebound [--repeats 7] [--threads 2]

Each repeat runs 10 000 members into a store of its own. Both times are processor times of one
run: that of the impacts alone, and that of the whole from the first look into the store. So
neither other work of the machine nor its clock stands in the ratio. Prints every ratio and the
median; exit 1 where the median is above 5 %.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ASKED = 0.05
BALL = """schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "17.63e4 N.s/m^2.5"
[controls]
samples = 200
"""
CAMPAIGN = """schema = 1
base = "ball.toml"
[design]
kind = "latin-hypercube"
count = 10000
[[design.factor]]
key = "impact.speed"
low = "1 m/s"
high = "30 m/s"
"""


def overhead(program, folder, number, threads):
    out = subprocess.run(
        [program, "campaign", "many.toml", "--out", f"store-{number}", "--threads", str(threads), "--json"],
        cwd=folder, check=True, capture_output=True, text=True)
    said = json.loads(out.stdout)
    assert said["run"] == 10000 and said["failed"] == 0, said
    return said["impact_processor_s"], said["processor_s"]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program")
    options.add_argument("--repeats", type=int, default=7)
    options.add_argument("--threads", type=int, default=2)
    asked = options.parse_args()
    program = str(pathlib.Path(asked.program).resolve())
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("ball.toml", BALL), ("many.toml", CAMPAIGN)):
            pathlib.Path(folder, name).write_text(text)
        for number in range(asked.repeats):
            impacts, whole = overhead(program, folder, number, asked.threads)
            ratios.append(whole / impacts - 1.0)
            print(f"impacts {impacts:.3f} s, all {whole:.3f} s: {100 * ratios[-1]:.2f} %", flush=True)
    median = statistics.median(ratios)
    print(f"median of {len(ratios)}: {100 * median:.2f} %; asked: {100 * ASKED:.0f} %")
    return 0 if median <= ASKED else 1


if __name__ == "__main__":
    sys.exit(main())
