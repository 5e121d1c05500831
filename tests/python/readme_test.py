"""The Python blocks of the README, run as a user would after its commands; their numbers are checked.

usage: readme_test.py README

A comment `# 0.661` behind a print is what it prints.
"""
import contextlib
import io
import os
import re
import subprocess
import sys
import tempfile

with open(sys.argv[1], encoding="utf-8") as readme:
    blocks = re.findall(r"^```python\n(.*?)^```", readme.read(), re.M | re.S)
assert blocks, "the README holds no Python block"

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    program = os.environ["REBOUND_PROGRAM"]
    subprocess.run([program, "init", "--out", "first"], check=True)
    subprocess.run([program, "synthesize", "first/synthesis.toml", "--out", "first/experiment"], check=True)
    for block in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(block, "README.md", "exec"), {})
        claimed = re.findall(r"^ *print\(.*\) +# (.*)$", block, re.M)
        print(printed.getvalue())
        assert claimed, "a block claims nothing"
        assert printed.getvalue().splitlines() == claimed, claimed
    os.chdir("/")
