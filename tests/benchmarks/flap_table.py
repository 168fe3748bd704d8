#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tears a flap out of a sheet and prints the exponent of its width as a power of the distance to its point.

    tests/benchmarks/flap_table.py build/release/app/sherd [SEEDS [EDGE...]]

EDGE: edge lengths of the meshes, m. Takes minutes. Needs h5py and numpy.
"""
import itertools
import sys

import h5py
import numpy

from recorded_run import recorded_run

SCENE = "experiments/torn_flap.toml"


def widths(recording):
    """Returns places along the flap and its widths, m, from the start of the cracks to the end of the shorter one."""
    with h5py.File(recording) as file:
        frame, failure = file["frames"][sorted(file["frames"])[-1]], file["events/failure"]
        rest = frame["rest/position"][:][frame["vertex/original"][:]]
        ends = rest[failure["vertices"][:][failure["step"][:] > 0].ravel()]
    sides = [numpy.unique(ends[side][:, [1, 0]], axis=0) for side in (ends[:, 0] < 0, ends[:, 0] > 0)]
    y = numpy.linspace(max(side[0, 0] for side in sides), min(side[-1, 0] for side in sides), 40)
    return y, sum(numpy.interp(y, side[:, 0], abs(side[:, 1])) for side in sides)


def free_power(y, width):
    """Returns the point and the exponent that fit best in the logarithm of widths."""
    def fit(point):
        line, residual, *_ = numpy.polyfit(numpy.log(point - y), numpy.log(width), 1, full=True)
        return residual[0], point, line[0]
    return min(fit(point) for point in numpy.linspace(y[-1] + 1e-4, y[-1] + 0.15, 600))[1:]


def miss(y, width, power):
    """Returns the root mean square residual of the width, m, if width^(1/power) is fitted by a line."""
    line = numpy.polyfit(y, width ** (1 / power), 1)
    return numpy.sqrt(((width - numpy.maximum(numpy.polyval(line, y), 0) ** power) ** 2).mean())


def main():
    program, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2
    edges = [float(edge) for edge in sys.argv[3:]] or [0.002]
    print("| edges (mm) | seed | point (mm from the cuts) | power | off 8/11 (mm) | off 9/8 (mm) |")
    print("| --- " * 6 + "|")
    for edge, seed in itertools.product(edges, range(1, seeds + 1)):
        with recorded_run(program, SCENE, [f"seed={seed}", f"sheet.plate.mesh.edge_length={edge}"]) as recording:
            y, width = widths(recording)
        point, power = free_power(y, width)
        off = " | ".join(f"{1000 * miss(y, width, n):.1f}" for n in (8 / 11, 9 / 8))
        print(f"| {1000 * edge:g} | {seed} | {1000 * (point - y[0]):.0f} | {power:.2f} | {off} |", flush=True)


if __name__ == "__main__":
    main()
