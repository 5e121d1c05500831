"""Every command that writes files, as a command line whose --out is {out}."""
import subprocess

FIELDS = "\n[controls]\nfield_frames = 6\n"
WRITERS = [
    ["lumped", "lumped.toml", "--out", "{out}"],
    ["fem", "fields.toml", "--out", "{out}"],
    ["compress", "compression.toml", "--out", "{out}"],
    ["mesh", "--diameter", "66.2 mm", "--cells", "200", "--out", "{out}"],
    ["calibrate", "calibrate.toml", "--out", "{out}"],
    ["select", "select.toml", "--out", "{out}"],
    ["benchmark", "benchmark.toml", "--out", "{out}"],
    ["benchmark", "--audit", "fem.toml", "--out", "{out}"],
    ["atlas", "grid.toml", "--out", "{out}"],
    ["convert", "convert.toml", "--out", "{out}"],
    ["export", "fem.toml", "--to", "febio", "--out", "{out}"],
    ["drop", "lumped.toml", "--out", "{out}"],
    ["compare", "compare.toml", "--baseline", "{out}", "--record"],
    ["verify", "--tier", "lumped", "--out", "{out}"],
    ["inspect", "experiment/data", "--out", "{out}"],
    ["synthesize", "synthesis.toml", "--out", "{out}"],
    ["synthesize", "synthesis.toml", "--seal", "--out", "{out}", "--truth", "{out}/truth.json"],
    ["design", "plan.toml", "--out", "{out}"],
    ["diagnose", "experiment/data", "--model", "lumped.toml", "--no-bootstrap", "--out", "{out}"],
    ["trials", "blind", "--count", "1", "--out", "{out}"],
    ["campaign", "members.toml", "--out", "{out}"],
    ["campaign", "query", "members.toml", "--out", "store", "--csv", "{out}/table.csv"],
    ["init", "--out", "{out}"],
    ["init", "dataset", "--from", "drops.csv", "--mass", "89.6 g", "--diameter", "66.2 mm", "--out", "{out}"],
    ["reproduce", "--out", "{out}"],
    ["schema", "lumped", "--out", "{out}"],
    ["completion", "--out", "{out}"],
    ["study", "study.toml", "--out", "{out}"],
]
# These take longer than all others together.
LONG = ("study", "design", "diagnose", "trials", "verify", "compare", "benchmark")


def prepare(bench, trial_generator):
    """Files that the writers need beside those of the bench."""
    fem = (bench.folder / "fem.toml").read_text(encoding="utf-8")
    (bench.folder / "fields.toml").write_text(fem[:fem.index("[controls]")] + FIELDS, encoding="utf-8")
    bench.call("campaign", "members.toml", "--out", "store")
    subprocess.run([trial_generator, "--out", "blind", "--count", "1", "--seed", "3", "--only", "null"],
                   cwd=bench.folder, check=True, stdout=subprocess.DEVNULL)


def command_line(writer, out, folder):
    """Of a run in `folder`; a table's folder is there before it."""
    if writer[1] == "query":
        (folder / out).mkdir(exist_ok=True)
    return [word.format(out=out) for word in writer]


def name_of(writer):
    return " ".join(word for word in writer if "{out}" not in word and word != "--out")
