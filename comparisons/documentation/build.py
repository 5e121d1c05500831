#!/usr/bin/env python3
"""Builds the site: build.py PROGRAM CHROMIUM FOLDER [PAGES]. Every warning is an error.

Pages are copied beside what the program writes, so that the sources hold nothing that was made.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import time

program, chromium, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
room = pathlib.Path(__file__).resolve().parent
started = time.monotonic()
for part in ("pages", "html", "tutorials", "doctrees"):
    shutil.rmtree(folder / part, ignore_errors=True)
shutil.copytree(sys.argv[4] if len(sys.argv) > 4 else room / "pages", folder / "pages")
os.environ.update(REBOUND_PROGRAM=str(pathlib.Path(program).resolve()), REBOUND_CHROMIUM=chromium,
                  REBOUND_SCRATCH=str(folder / "tutorials"), PYTHONDONTWRITEBYTECODE="1")
status = subprocess.run([sys.executable, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q", "-n",
                         "-c", room, "-d", folder / "doctrees", folder / "pages", folder / "html"]).returncode
if status:
    sys.exit(status)
print(f"{folder / 'html' / 'index.html'} ({time.monotonic() - started:.0f} s)")
