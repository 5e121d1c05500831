"""The program to compare with, and examples that it wrote."""
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

PROGRAM = os.environ["REBOUND_PROGRAM"]
CORE = {
    "sphere": {"mass": 0.0896, "diameter": "66.2 mm"},
    "impact": {"speed": 15},
    "model": {"law": "hunt-crossley", "exponent": 1.5, "stiffness": 3.5e6, "damping": 17.63e4},
}
TIMES = ("wall_s", "setup_s")  # of this run, not of the impact


def printed(*arguments):
    """What the program prints under --json."""
    run = subprocess.run([PROGRAM, *map(str, arguments), "--json"], capture_output=True, check=True)
    return json.loads(run.stdout)


def without_times(result):
    return {key: value for key, value in result.items() if key not in TIMES}


class WithExamples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run([PROGRAM, "init", "--out", cls.folder], check=True, stdout=subprocess.DEVNULL)

    def interrupted_after(self, seconds, work):
        """Seconds from Ctrl-C to KeyboardInterrupt."""
        sent = []

        def send():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(seconds, send)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                work()
        finally:
            timer.cancel()
        return time.monotonic() - sent[0]
