#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the accuracy of the time schemes for a wave: the largest curvature of a bent strip that is released, 50 mm
from its end, over the initial curvature (1.428 by theory), by the number of steps until the largest curvature arrives.

    tests/benchmarks/scheme_table.py build/release/app/sherd

Needs h5py and numpy; takes a minute.
"""
import math
import sys

import h5py
import numpy

from recorded_run import recorded_run

SCENE, GAUGE, BENT = "experiments/released_strip.toml", "s50", 0.2  # 1/m
ARRIVAL = 0.05 ** 2 / (4 * math.pi * 0.0015 * math.sqrt(3.8e9 / (12 * 1500)))  # s, time of the largest curvature
STEPS = (3, 10, 30, 100)


def overshoot(program, scheme, step):
    settings = [f"solver.scheme={scheme}", f"solver.step={step}", "solver.damping.stiffness=0",
                f"duration={2 * ARRIVAL}", f"output.every={2 * ARRIVAL}"]
    settings += ["solver.tolerance=1e-8"] if scheme != "explicit" else []
    with recorded_run(program, SCENE, settings, "--variant", "whole") as recording, h5py.File(recording) as file:
        return numpy.abs(file[f"gauges/{GAUGE}/curvature"][:, 0]).max() / BENT


def main():
    program = sys.argv[1]
    print(f"| scheme | {' | '.join(f'{steps} steps' for steps in STEPS)} |")
    print("| --- " * (1 + len(STEPS)) + "|")
    for scheme in ("implicit-euler", "bdf2"):
        print(f"| {scheme} | {' | '.join(f'{overshoot(program, scheme, ARRIVAL / steps):.2f}' for steps in STEPS)} |",
              flush=True)
    print(f"explicit: {overshoot(program, 'explicit', 1e-6):.2f}")


if __name__ == "__main__":
    main()
