"""Bad inputs through the command line: each ends in a right result or in an error with its place.

usage: bad_inputs_test.py PROGRAM STUDY COUNT [SEED] [TARGET]

COUNT command lines are drawn from: keys x bad values, keys x damaged lines, damaged bytes, for a file of every
command; and options x bad values. With the same seed they are the same. A failure prints what to repeat.
"""
import concurrent.futures
import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import tomllib

import jsonschema
from damage import BAD_VALUES, FILE_DAMAGE, LINE_DAMAGE, edited, key_lines, with_value
from quantities import different, out_of_range
from targets import TARGETS, Bench

LONGEST = 120  # seconds: nothing here has a reason to take longer
CRASHED = re.compile(r"terminate called|Sanitizer|Assertion|core dumped|std::|basic_string")
OPTION_VALUES = ["", " ", "x", "-1", "0", "1e308", "nan", "99999999999999999999", "1,5", "../..", "/dev/null",
                 "3 furlong", "$(touch pwned)", "; touch pwned", "ü", "9" * 400, "-", "=", "0x10", "1/0", "0/3"]


def draw_files(rng, count, texts):
    """(target, name of the damage, text) until `count` are there: every target as often as the others."""
    drawn = []
    while len(drawn) < count:
        target = TARGETS[len(drawn) % len(TARGETS)]
        text = texts[target.source]
        kind, line = rng.randrange(4), rng.choice(key_lines(text))
        if kind < 2:
            name = rng.choice(list(BAD_VALUES))
            made = with_value(text, line, name).encode("utf-8")
        elif kind == 2:
            name = rng.choice(list(LINE_DAMAGE))
            made = edited(text, line, LINE_DAMAGE[name]).encode("utf-8")
        else:
            name = rng.choice(list(FILE_DAMAGE))
            made = FILE_DAMAGE[name](rng, text.encode("utf-8"))
        drawn.append((target, f"{name}, line {line + 1}", made))
    return drawn


class Judge:
    def __init__(self, bench):
        self.bench, self.schemas, self.right = bench, {}, {}
        for target in TARGETS:
            if target.schema and target.schema not in self.schemas:
                text = subprocess.run([bench.program, "schema", target.schema], capture_output=True, check=True).stdout
                self.schemas[target.schema] = json.loads(text)

    def wrong_by_itself(self, target, text):
        """What an independent reading finds wrong with a file; "" where nothing."""
        try:
            read = tomllib.loads(text.decode("utf-8-sig"))
        except (UnicodeDecodeError, tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
            return f"no TOML: {error}"[:200]
        if target.schema:
            schema = self.schemas[target.schema]
            for complaint in jsonschema.Draft202012Validator(schema).iter_errors(read):
                return f"schema: {complaint.message}"[:200]
            for key in out_of_range(schema, read):
                return f"range of {key}"
        return ""

    def run(self, arguments, out):
        words = [self.bench.program, *arguments, "--json"]
        if out:
            words += ["--out", out]
        return subprocess.run(words, cwd=self.bench.folder, capture_output=True, timeout=LONGEST, text=True,
                              errors="replace", stdin=subprocess.DEVNULL)

    def complaint(self, run, file="", bad=""):
        """What is wrong with how a run ended; "" where nothing."""
        if run.returncode < 0 or run.returncode > 5 or CRASHED.search(run.stderr):
            return f"crash: {run.returncode} {run.stderr[-300:]}"
        try:
            printed = json.loads(run.stdout)
        except ValueError:
            return f"no JSON: {run.stdout[:200]!r} {run.stderr[:200]!r}"
        if run.returncode <= 1:
            if bad:
                return f"taken, though it is wrong ({bad})"
            return "" if all(map(math.isfinite, numbers(printed))) else "a number that is none"
        error = printed.get("error", {})
        if error.get("code") != run.returncode:
            return f"code {error.get('code')} printed, {run.returncode} returned"
        if not error.get("message") or CRASHED.search(error["message"]):
            return f"no message: {error}"
        if run.returncode == 3 and not bad:
            return ""  # a valid file whose solver has no answer
        if file and not error.get("file"):
            return f"no file: {error}"
        if file and not error.get("line") and not error.get("key") and run.returncode == 2 and \
                pathlib.Path(error["file"]).name == pathlib.Path(file).name and "empty" not in error["message"]:
            return f"no place: {error}"
        return ""

    def of_file(self, number, target, damage, text):
        bad = self.wrong_by_itself(target, text)
        if target.slow and not bad:
            return None  # right, and minutes long: other draws have to do
        file, arguments = self.bench.place(target, text, f"damaged-{number}")
        out = f"out-{number}"
        try:
            run = self.run(arguments, out)
            said = self.complaint(run, str(file), bad)
            if not said and run.returncode == 0 and target.effective:
                effective = (self.bench.folder / out / "effective.toml").read_bytes()
                changed = list(different(tomllib.loads(text.decode("utf-8-sig")), tomllib.loads(effective.decode())))
                said = f"another value went into the run: {changed}" if changed else ""
            if not said and run.returncode > 1 and (self.bench.folder / out / "result.json").exists():
                said = "a result was left beside an error"
        except subprocess.TimeoutExpired:
            said = f"no end in {LONGEST} s"
        return said and f"{target.name}: {damage}: {said}\n    {' '.join(arguments)}"

    def of_options(self, arguments):
        try:
            run = self.run(arguments, "")
        except subprocess.TimeoutExpired:
            return f"{arguments}: no end"
        said = self.complaint(run)
        return said and f"{arguments}: {said}"


def numbers(value):
    if isinstance(value, dict):
        for inner in value.values():
            yield from numbers(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from numbers(inner)
    elif isinstance(value, float):
        yield value


def draw_options(rng, bench, count):
    """Command lines with one bad option, argument or command; those that would take minutes are left out."""
    listed = subprocess.run([bench.program, "completion", "bash"], capture_output=True, check=True, text=True).stdout
    commands = subprocess.run([bench.program, "--help"], capture_output=True, check=True, text=True).stdout
    commands = re.findall(r"^  ([a-z]+) ", commands.split("Subcommands:")[1].split("Exit codes")[0], re.M)
    options = sorted(set(re.findall(r"--[a-z-]+", listed)) - {"--help", "--version", "--out", "--truth"})
    drawn = []
    while len(drawn) < count:
        command = rng.choice(commands)
        value = rng.choice(OPTION_VALUES)
        kind = rng.randrange(4)
        if kind == 0 and command not in ("study", "verify", "reproduce", "doctor", "atlas", "init", "completion"):
            drawn.append([command, value])
        elif kind == 1:
            drawn.append([value, command])
        elif kind == 2:
            drawn.append([command, rng.choice(options), value, "nowhere.toml"])
        else:
            drawn.append([command, "nowhere.toml", "--threads=" + value])
    return drawn


def main():
    program, study, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 16
    only = sys.argv[5] if len(sys.argv) > 5 else ""
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(program, study, folder)
        texts = {target.source: (bench.folder / target.source).read_text(encoding="utf-8") for target in TARGETS}
        judge = Judge(bench)
        for target in TARGETS:  # the files are right before they are damaged
            wrong = judge.wrong_by_itself(target, texts[target.source].encode("utf-8"))
            if wrong:
                raise SystemExit(f"{target.name}: the file is wrong before it is damaged: {wrong}")
        before = {path.name for path in bench.folder.iterdir()}
        option_count = count // 5
        files = draw_files(rng, 2 * (count - option_count), texts)
        failures, ran, by_code = [], 0, {}
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            made = [(i, *drawn) for i, drawn in enumerate(files) if only in drawn[0].name]
            # Slow targets whose damage happens to be none are skipped: others take their place.
            for said in pool.map(lambda one: judge.of_file(*one), made):
                if said is None:
                    continue
                if ran == count - option_count:
                    break
                ran += 1
                failures += [said] if said else []
            lines = draw_options(rng, bench, option_count)
            for said in pool.map(judge.of_options, lines):
                ran += 1
                failures += [said] if said else []
        allowed = re.compile(r"damaged-|out-\d|results$")
        strange = sorted(p.name for p in bench.folder.iterdir() if p.name not in before and not allowed.match(p.name))
        if strange:
            failures.append(f"written outside the folder asked for: {strange}")
    for said in failures:
        print(said)
    print(f"{ran} bad inputs, {len(failures)} ended wrongly (seed {seed})")
    return 1 if failures or ran < count else 0


if __name__ == "__main__":
    sys.exit(main())
