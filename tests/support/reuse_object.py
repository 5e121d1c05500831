"""reuse_object.py COMPILER ARGUMENT...: compiler launcher of builds that are used for seconds.

Takes an object over from a build that is there where it would come out the same: that object is younger than all
that went into it, its command differs in folders that are searched at most, and every file that was read has an
equal one here. Compiles otherwise, without optimisation.

Of the environment: DONE_SOURCE and DONE_BUILD, the folders of the build that is there; NEW_SOURCE and NEW_BUILD,
those of this one, where what is compiled is added to compiled.txt.
"""
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

# The build folder stands in the source folder: it comes first.
FOLDERS = [(os.environ["DONE_BUILD"], os.environ["NEW_BUILD"]), (os.environ["DONE_SOURCE"], os.environ["NEW_SOURCE"])]
DONE_BUILD, NEW_BUILD = FOLDERS[0]


def of_here(path):
    """The path here of a file there."""
    for there, here in FOLDERS:
        if path == there or path.startswith(there + "/"):
            return here + path[len(there):]
    return path


def following(arguments, flag):
    return arguments[arguments.index(flag) + 1] if flag in arguments else ""


def without_dependency_flags(arguments):
    """As compile_commands.json has them."""
    kept, skipped = [], 0
    for argument in arguments:
        skipped = {"-MD": 1, "-MT": 2, "-MF": 2}.get(argument, skipped)
        if skipped == 0:
            kept.append(argument)
        skipped = max(0, skipped - 1)
    return kept


def is_same_command(here, there):
    """Definitions have to be equal as they stand: a path in one goes into the object."""
    def is_same(before, mine, other):
        if before in ("-c", "-isystem"):
            return mine == of_here(other)
        return mine == other or (mine.startswith("-I") and mine == "-I" + of_here(other[2:]))

    return len(here) == len(there) and all(map(is_same, ["", *here], here, there))


def is_same_file(there):
    """Of a file that the build itself has written, paths may differ."""
    here = of_here(there)
    if here == there:
        return True
    try:
        mine, other = pathlib.Path(here).read_bytes(), pathlib.Path(there).read_bytes()
    except OSError:
        return False
    if there.startswith(DONE_BUILD + "/"):
        for folder, counterpart in FOLDERS:
            other = other.replace(folder.encode(), counterpart.encode())
    return mine == other


def reused(arguments):
    """What went into the object that was taken over; nothing where there is none to take."""
    wanted = following(arguments, "-o")
    done = pathlib.Path(DONE_BUILD, wanted)
    if not wanted or not done.exists() or not pathlib.Path(DONE_BUILD, "build.ninja").exists():
        return []
    commands = json.loads(pathlib.Path(DONE_BUILD, "compile_commands.json").read_bytes())
    command = next((each["command"] for each in commands if f" -o {wanted} " in each["command"]), "")
    if not is_same_command(without_dependency_flags(arguments), shlex.split(command)):
        return []
    said = subprocess.run(["ninja", "-C", DONE_BUILD, "-t", "deps", wanted], capture_output=True, text=True, check=True)
    head, *files = said.stdout.split("\n")
    files = [os.path.normpath(os.path.join(DONE_BUILD, file.strip())) for file in files if file]
    age = done.stat().st_mtime
    if "VALID" not in head or not all(os.path.exists(file) and os.path.getmtime(file) <= age and is_same_file(file)
                                      for file in files):
        return []
    shutil.copyfile(done, wanted)
    return [of_here(file) for file in files]


def main(arguments):
    files = reused(arguments)
    if files:
        written = " ".join(file.replace(" ", "\\ ") for file in files)
        pathlib.Path(following(arguments, "-MF")).write_text(f"{following(arguments, '-o')}: {written}\n", encoding="utf-8")
        return
    with open(pathlib.Path(NEW_BUILD, "compiled.txt"), "a", encoding="utf-8") as compiled:
        compiled.write(following(arguments, "-o") + "\n")
    # Kernels keep their optimisation: without it, inline functions of one instruction set would be shared with another.
    plain = [] if "/fem/kernel/" in following(arguments, "-c") else ["-O0"]
    os.execvp(arguments[0], arguments + plain)


main(sys.argv[1:])
