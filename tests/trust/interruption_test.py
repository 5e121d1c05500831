"""Ctrl-C in every phase of every long command: an answer within a second, and the end soon after.

usage: interruption_test.py PROGRAM TRIAL-GENERATOR STUDY [all]

An answer is the end of the program, or its word on standard error that it stops and keeps what is complete.
"""
import os
import pathlib
import re
import selectors
import signal
import subprocess
import sys
import tempfile
import time

from targets import Bench
from whole_files import torn_files
from writers import prepare

MILLION = ["cells = 60", "cells = 1000000"]
COMMANDS = [
    (["fem", "million.toml", "--out", "{out}"], [0.3, 1.0, 3.0, 8.0]),
    (["fem", "fine.toml", "--out", "{out}"], [0.2, 0.6, 1.5, 4.0]),
    (["compress", "fine_compression.toml", "--out", "{out}"], [0.2, 0.8, 2.5]),
    (["mesh", "--diameter", "66.2 mm", "--cells", "1000000", "--out", "{out}"], [0.1, 0.5, 2.0]),
]
LONG_COMMANDS = [
    (["fem", "fine.toml", "--reference", "--out", "{out}"], [2.0, 12.0]),
    (["fem", "implicit.toml", "--out", "{out}"], [0.5, 2.0, 6.0]),
    (["mesh", "--diameter", "66.2 mm", "--cells", "200000", "--unstructured", "--out", "{out}"], [0.5, 3.0]),
    (["study", "study.toml", "--out", "{out}"], [0.3, 1.0, 3.0]),
    (["atlas", "--out", "{out}"], [0.3, 2.0]),
    (["verify", "--out", "{out}"], [0.3, 2.0, 6.0]),
    (["reproduce", "--out", "{out}"], [0.02]),
    (["diagnose", "experiment/data", "--model", "lumped.toml", "--out", "{out}"], [0.1, 0.5, 1.5, 4.0]),
    (["diagnose", "experiment/data", "--model", "fine.toml", "--out", "{out}"], [0.5, 3.0]),
    (["design", "plan.toml", "--out", "{out}"], [0.2, 1.0, 4.0]),
    (["trials", "blind", "--out", "{out}"], [0.2, 2.0]),
    (["calibrate", "fine_material.toml", "--out", "{out}"], [0.3, 2.0]),
    (["benchmark", "--audit", "fine.toml", "--out", "{out}"], [0.3, 2.0]),
    (["compare", "compare.toml", "--baseline", "{out}", "--record"], [0.3, 2.0]),
    (["drop", "fine.toml", "--out", "{out}"], [0.3, 2.0]),
    (["campaign", "many.toml", "--out", "{out}"], [0.2, 2.0]),
    (["synthesize", "fem_synthesis.toml", "--out", "{out}"], [0.3, 2.0]),
]
ANSWER, END = 1.0, 8.0  # seconds


def write_files(folder):
    fem = (folder / "fem.toml").read_text(encoding="utf-8")
    files = {"million.toml": fem.replace(*MILLION), "fine.toml": fem.replace("cells = 60", "cells = 60000"),
             "implicit.toml": fem.replace('"explicit"', '"implicit"').replace("cells = 60", "cells = 4000"),
             "fine_compression.toml": re.sub(r"cells = \d+", "cells = 20000",
                                             (folder / "compression.toml").read_text(encoding="utf-8")),
             "fine_material.toml": (folder / "material.toml").read_text(encoding="utf-8").replace("fem.toml", "fine.toml"),
             "many.toml": (folder / "members.toml").read_text(encoding="utf-8").replace("lumped.toml", "fine.toml")}
    plan = (folder / "synthesis.toml").read_text(encoding="utf-8")
    start, end = plan.index("[model]"), plan.index("[instrument]")
    material = fem[fem.index("[model]"):fem.index("[controls]")].replace("cells = 60", "cells = 60000")
    files["fem_synthesis.toml"] = plan[:start] + material + plan[end:]
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


def interrupted(program, folder, words, after):
    """(ended by itself, seconds to an answer, seconds to the end, exit code, what it said)"""
    process = subprocess.Popen([program, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        process.wait(timeout=after)
        return True, 0.0, 0.0, process.returncode, process.stderr.read().decode()
    except subprocess.TimeoutExpired:
        pass
    begin = time.monotonic()
    process.send_signal(signal.SIGINT)
    said, answered = b"", None
    os.set_blocking(process.stderr.fileno(), False)
    with selectors.DefaultSelector() as waiting:
        waiting.register(process.stderr, selectors.EVENT_READ)
        while time.monotonic() - begin < 60.0:
            waiting.select(timeout=0.05)
            part = process.stderr.read()
            if part and answered is None:
                answered = time.monotonic() - begin
            said += part or b""
            if part == b"" or process.poll() is not None:
                break
    try:
        process.wait(timeout=END)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    ended = time.monotonic() - begin
    return False, ended if answered is None else answered, ended, process.returncode, said.decode()


def main():
    program, trial_generator, study = sys.argv[1:4]
    everything = sys.argv[4:] == ["all"]
    failures, count, slowest = [], 0, 0.0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bench = Bench(program, study, folder)
        prepare(bench, trial_generator)
        write_files(folder)
        for words, moments in COMMANDS + (LONG_COMMANDS if everything else []):
            for after in moments if everything else moments[1:2]:
                out = folder / f"out-{count}"
                line = [word.format(out=out.name) for word in words]
                by_itself, answer, end, code, said = interrupted(program, folder, line, after)
                count += 1
                what = f"{' '.join(line)} after {after} s"
                if by_itself:
                    if code not in (0, 1):
                        failures.append(f"{what}: ended with {code}: {said}")
                    continue
                slowest = max(slowest, answer)
                if answer > ANSWER or end > END:
                    failures.append(f"{what}: an answer after {answer:.2f} s, the end after {end:.2f} s")
                # Within its first milliseconds a program has no handler yet, and is simply ended.
                if code not in (130, 0, 1, -signal.SIGINT) or (code == 130 and "rebound:" not in said):
                    failures.append(f"{what}: ended with {code}: {said}")
                if out.exists() and torn_files(out):
                    failures.append(f"{what}: torn {torn_files(out)}")
    for said in failures:
        print(said)
    print(f"{count} interruptions, {len(failures)} ended wrongly; the slowest answer took {slowest:.2f} s")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
