"""Files written by SciPy and h5py, independent of what the program reads them with.

scipy_test.py REBOUND: one record as text, as .mat of versions 4 and 5, in a structure, and compressed in a group of an HDF5
file: `init dataset` and `inspect` say the same of each.
"""
import json
import os
import subprocess
import sys
import tempfile

import h5py
import numpy as np
import scipy.io

program = sys.argv[1]
ball = ["--mass", "89.6 g", "--diameter", "66.2 mm", "--speed", "15 m/s", "--out", "ball"]


def inspected(file):
    subprocess.run([program, "init", "dataset", "--from", file, *ball], check=True, stdout=subprocess.DEVNULL)
    out = subprocess.run([program, "inspect", "ball", "--json"], check=True, stdout=subprocess.PIPE).stdout
    for name in os.listdir("ball"):
        os.remove(os.path.join("ball", name))
    return json.loads(out)["shots"][0]


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    time = np.arange(600) * 1e-2
    inside = (time > 2.0) & (time < 3.5)
    force = np.where(inside, 2.0 * np.sin(np.pi * (time - 2.0) / 1.5), 0.0)
    force += 0.00390625 * (np.arange(600) ** 2 % 7 - 3)
    force = force.astype("f4").astype("f8")  # the same in single precision
    np.savetxt("text.csv", np.c_[time, force], "%.17g", ",", header="time [ms],force [kN]", comments="")
    scipy.io.savemat("five.mat", {"time_ms": time, "force_kN": force, "label": "core A"}, do_compression=True)
    scipy.io.savemat("four.mat", {"time_ms": time, "force_kN": force}, format="4")
    scipy.io.savemat("structure.mat", {"run": {"time_ms": time, "force_kN": force.astype("f4")}})
    with h5py.File("group.h5", "w") as file:
        data = file.create_dataset("scope/time", data=time, compression="gzip", chunks=True)
        data.attrs["units"] = "ms"  # of variable length
        data = file.create_dataset("scope/force", data=force, compression="gzip", shuffle=True)
        data.attrs["unit"] = np.bytes_("kN")
    expected = inspected("text.csv")
    assert abs(expected["numbers"]["peak_force_N"]["value"] - 2000.0) < 20.0, expected
    for name in ("five.mat", "four.mat", "structure.mat", "group.h5"):
        assert inspected(name) == expected, name
        print(name, "as the text")
