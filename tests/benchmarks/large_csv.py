#!/usr/bin/env python3
"""How fast a record of any length is read, and in how much memory.

    python3 tests/benchmarks/large_csv.py build/rebound [--megabytes 2000] [--folder /tmp]

Writes a file of one impact in a long record (six columns, decimal points, every half microsecond),
makes a data set of it with `init dataset --from`, and inspects that. For each: bytes a second of
processor time, so that other work of the machine does not count, and the largest resident set; beside
them `wc -l` on the same file. Exit 1 where a command needs 200 MB or more, or reads below 100 MB/s
and below half of what `wc -l` does. Everything that was written is removed.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

MOST_MEMORY = 200e6
LEAST_SPEED = 100e6
BYTES_A_ROW = 54
ROWS = """BEGIN {
  print "time [us],force [N],gauge [V],temperature [K],channel 5,channel 6"
  for (i = 0; i < rows; ++i) {
    phase = (i * 0.5 - rows * 0.25) / 1900
    force = phase >= 0 && phase <= 1 ? 3000 * sin(3.14159265 * phase) : 0
    printf "%011.1f,%010.4f,0.123456,293.1500,1.00000,2.00000\\n", i * 0.5, force + (i * 7919 % 13) - 6
  }
}"""


def write(path, rows):
    with open(path, "wb") as file:
        subprocess.run(["awk", "-v", f"rows={rows}", ROWS], stdout=file, check=True)


def measured(arguments, folder):
    """Processor seconds and largest resident set [bytes] of one command."""
    child = subprocess.Popen(arguments, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = child.stderr.read().decode()
    _, status, usage = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        raise SystemExit(f"{' '.join(arguments)}: {errors}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program")
    options.add_argument("--megabytes", type=int, default=2000)
    options.add_argument("--folder", default=None)
    options.add_argument("--memory-only", action="store_true", help="judge no speed: of short files and busy machines")
    asked = options.parse_args()
    program = str(pathlib.Path(asked.program).resolve())
    good = True
    with tempfile.TemporaryDirectory(dir=asked.folder) as folder:
        path = pathlib.Path(folder, "record.csv")
        write(path, asked.megabytes * 1000000 // BYTES_A_ROW)
        size = path.stat().st_size
        count, _ = measured(["wc", "-l", path.name], folder)
        print(f"{size / 1e6:.0f} MB; wc -l: {size / count / 1e6:.0f} MB/s")
        commands = {
            "init dataset": ["init", "dataset", "--from", path.name, "--mass", "89.6 g", "--diameter", "66.2 mm",
                             "--speed", "15 m/s", "--out", "ball"],
            "inspect": ["inspect", "ball"],
        }
        for name, command in commands.items():
            if name == "inspect":  # one file, not two
                pathlib.Path(folder, "ball", path.name).unlink()
                os.link(path, pathlib.Path(folder, "ball", path.name))
            seconds, memory = measured([program, *command], folder)
            speed = size / seconds
            fast = asked.memory_only or speed >= min(LEAST_SPEED, 0.5 * size / count)
            met = memory < MOST_MEMORY and fast
            good &= met
            print(f"{name}: {speed / 1e6:.0f} MB/s of processor time, {memory / 1e6:.0f} MB"
                  f"{'' if met else '  <- misses'}", flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
