"""No room for a file, in any command that writes: exit code 4, the file named, nothing torn.

usage: full_disk_test.py PROGRAM TRIAL-GENERATOR STUDY [all]

A limit on the size of files lets each of a command's files fail in turn; where the kernel lets a test mount one,
a disk of a few kilobytes does too. `all` takes the commands that last longest too.
"""
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

from targets import Bench
from whole_files import torn_files
from writers import LONG, WRITERS, command_line, name_of, prepare

DISKS = [0, 8, 24, 60, 160, 400, 1200]  # kilobytes


def limits_of(out, most):
    """Sizes below which one more file of a folder cannot be written, the largest among them."""
    sizes = sorted({path.stat().st_size for path in out.rglob("*") if path.is_file()})
    chosen = sizes[:: max(1, len(sizes) // most)] + sizes[-1:]
    return sorted({max(0, size - 1) for size in chosen})


class Disk:
    """What a command says where a file may not grow, or a disk is full."""

    def __init__(self, bench, everything):
        self.most_limits, self.sizes = (8, DISKS) if everything else (1, DISKS[::3])
        self.bench, self.failures, self.refused, self.disk_refused = bench, [], 0, 0

    def run(self, words, limit=None):
        def hold():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        return subprocess.run([self.bench.program, *words], cwd=self.bench.folder, capture_output=True,
                              preexec_fn=hold if limit is not None else None, text=True, errors="replace")

    def judge(self, writer, out, run, where, must_fail):
        name = name_of(writer)
        torn = torn_files(out) if out.exists() else []
        left = [str(p) for p in out.rglob("*.partial-*")] if out.exists() else []
        if torn or left:
            self.failures.append(f"{name}, {where}: torn {torn}, left {left}")
        if run.returncode == 4 and not re.search(r"^rebound: \S*/\S+: ", run.stderr, re.MULTILINE):
            self.failures.append(f"{name}, {where}: no file is named: {run.stderr}")
        if run.returncode not in ((4,) if must_fail else (0, 1, 4)):
            self.failures.append(f"{name}, {where}: exit {run.returncode}: {run.stderr[-300:]}")
        return run.returncode == 4

    def with_limits(self, writer):
        whole = self.bench.folder / "whole"
        run = self.run(command_line(writer, whole.name, self.bench.folder))
        if run.returncode not in (0, 1):
            raise SystemExit(f"{name_of(writer)}: {run.returncode} {run.stderr}")
        for limit in limits_of(whole, self.most_limits):
            out = self.bench.folder / "limited"
            run = self.run(command_line(writer, out.name, self.bench.folder), limit)
            self.refused += self.judge(writer, out, run, f"files of {limit} bytes at most", True)
            shutil.rmtree(out, ignore_errors=True)
        shutil.rmtree(whole, ignore_errors=True)

    def with_disks(self, writer, disk):
        for kilobytes in self.sizes:
            subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={max(4, kilobytes)}k", "tmpfs", disk], check=True)
            try:
                if kilobytes == 0:
                    (disk / "filler").write_bytes(bytes(4096))
                out = disk / "out"
                run = self.run(command_line(writer, str(out.relative_to(self.bench.folder)), self.bench.folder))
                self.disk_refused += self.judge(writer, out, run, f"a disk of {kilobytes} kB", kilobytes == 0)
            finally:
                subprocess.run(["umount", disk], check=True)


def may_mount():
    return subprocess.run(["unshare", "-m", "true"], capture_output=True, check=False).returncode == 0


def main():
    program, trial_generator, study = sys.argv[1:4]
    everything = sys.argv[4:] == ["all"]
    if may_mount() and "REBOUND_OWN_MOUNTS" not in os.environ:
        os.environ["REBOUND_OWN_MOUNTS"] = "1"
        os.execvp("unshare", ["unshare", "-m", sys.executable, "-B", *sys.argv])
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(program, study, pathlib.Path(folder))
        prepare(bench, trial_generator)
        (bench.folder / "disk").mkdir()
        disk = Disk(bench, everything)
        writers = [w for w in WRITERS if everything or w[0] not in LONG]
        for writer in writers:
            disk.with_limits(writer)
            if "REBOUND_OWN_MOUNTS" in os.environ:
                disk.with_disks(writer, bench.folder / "disk")
    for said in disk.failures:
        print(said)
    print(f"{len(writers)} commands: {disk.refused} refused files, {disk.disk_refused} full disks, "
          f"{len(disk.failures)} ended wrongly")
    return 1 if disk.failures or not disk.refused else 0


if __name__ == "__main__":
    sys.exit(main())
