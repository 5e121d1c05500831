"""Seconds for the fit of bench_calibration's two_parameters by scipy.

Hunt-Crossley, core A at 15 m/s, 200 samples, force over deflection without the
last 1 % of deflection, the same start; least_squares(method="lm") over
solve_ivp(method="LSODA", rtol=1e-8). Not part of the tests; needs python3-scipy
(Debian's, so /usr/bin/python3). Processor seconds, to be divided by the CPU column of
bench_calibration --benchmark_filter=two_parameters in the same run.

    build/rebound lumped impact.toml --out reference     # samples = 200
    python3 compare_scipy.py reference/trace.csv
"""

import csv
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

MASS, SPEED = 0.0896, 15.0


def force_at(parameters, deflection, loading):
    stiffness, damping = parameters

    def rate(_, y):
        x = max(y[0], 0.0)
        return [y[1], -(x**1.5) * (stiffness + damping * y[1]) / MASS]

    def left(_, y):
        return y[0]

    left.terminal, left.direction = True, -1
    run = solve_ivp(rate, (0.0, 0.02), [0.0, SPEED], method="LSODA", rtol=1e-8,
                    atol=[1e-12, 1e-8], events=left, dense_output=True)
    instants = np.linspace(0.0, run.t[-1], 2001)
    x, v = run.sol(instants)
    top = int(np.argmax(x))
    force = np.clip(x, 0.0, None) ** 1.5 * (stiffness + damping * v)
    return np.where(loading, np.interp(deflection, x[: top + 1], force[: top + 1]),
                    np.interp(deflection, x[top:][::-1], force[top:][::-1]))


def main():
    with open(sys.argv[1], newline="") as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    force, deflection = np.array(rows)[:, 1], np.array(rows)[:, 2]
    top = int(np.argmax(deflection))
    loading = np.arange(len(deflection)) <= top
    kept = deflection <= 0.99 * deflection[top]
    force, deflection, loading = force[kept], deflection[kept], loading[kept]
    peak, reach = force.max(), deflection.max()
    start = np.array([peak / reach**1.5, peak / reach**1.5 / SPEED / 3.0])

    def residuals(scaled):
        return force_at(scaled * start, deflection, loading) - force

    begun = time.process_time()
    found = least_squares(residuals, [1.0, 1.0], method="lm", diff_step=1e-4)
    print(f"{time.process_time() - begun:.4f} s of processor, {found.nfev} evaluations, {found.x * start}")


main()
