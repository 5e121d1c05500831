"""kill -9 at any time in any command that writes: no file with a final name is torn, and the command works after.

usage: kills_test.py PROGRAM TRIAL-GENERATOR STUDY KILLS [SEED]

Half of the kills come at a random time of the command's run, half as soon as it begins to write.
"""
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from targets import Bench
from whole_files import torn_files
from writers import LONG, WRITERS, command_line, name_of, prepare


def is_writing(out):
    return out.is_dir() and any(path.is_file() for path in out.rglob("*"))


class Killer:
    def __init__(self, bench, rng):
        self.bench, self.rng, self.duration = bench, rng, {}

    def start(self, writer, out):
        words = [self.bench.program, *command_line(writer, out.name, self.bench.folder)]
        return subprocess.Popen(words, cwd=self.bench.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def whole_run(self, writer, out):
        """Seconds of a run to the end, which has to succeed."""
        begin = time.monotonic()
        process = self.start(writer, out)
        errors = process.communicate()[1]
        if process.returncode not in (0, 1) or torn_files(out):
            raise SystemExit(f"{name_of(writer)}: {process.returncode} {errors.decode()} {torn_files(out)}")
        return time.monotonic() - begin

    def killed(self, writer, out, while_writing):
        """Runs and kills; True where it was still running."""
        name = name_of(writer)
        if name not in self.duration:
            self.duration[name] = self.whole_run(writer, self.bench.folder / (out.name + "-first"))
        process = self.start(writer, out)
        if while_writing:
            while process.poll() is None and not is_writing(out):
                time.sleep(1e-4)
            time.sleep(self.rng.uniform(0.0, 5e-3))
        else:
            time.sleep(self.rng.uniform(0.0, self.duration[name]))
        process.send_signal(signal.SIGKILL)
        process.communicate()
        return process.returncode == -signal.SIGKILL


def main():
    program, trial_generator, study, kills = *sys.argv[1:4], int(sys.argv[4])
    rng = random.Random(int(sys.argv[5]) if len(sys.argv) > 5 else 9)
    few = kills < 200
    writers = [w for w in WRITERS if not (few and w[0] in LONG)]
    failures, killed, rounds = [], 0, 0
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(program, study, pathlib.Path(folder))
        prepare(bench, trial_generator)
        killer = Killer(bench, rng)
        try:
            while killed < kills and rounds < 20 * kills:
                writer, out = writers[rounds % len(writers)], bench.folder / f"out-{rounds}"
                killed += killer.killed(writer, out, rounds // len(writers) % 2 == 0)
                torn = torn_files(out) if out.exists() else []
                if torn:
                    failures.append(f"{name_of(writer)}: torn: {torn}")
                    print(failures[-1], flush=True)
                # It goes on, or begins anew, over what was left; `init` does not write over files.
                if writer[0] != "init" and (few or rounds % 10 == 0):
                    killer.whole_run(writer, out)
                for place in bench.folder.glob("out-*"):
                    shutil.rmtree(place, ignore_errors=True)
                rounds += 1
        except KeyboardInterrupt:
            print(f"stopped in round {rounds}")
    print(f"{killed} kills in {len(writers)} commands, {len(failures)} left a torn file")
    return 1 if failures or killed < kills else 0


if __name__ == "__main__":
    sys.exit(main())
