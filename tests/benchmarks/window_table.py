#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Throws the ball of window_ball with several speeds at several meshes and prints how the pane breaks.

    tests/benchmarks/window_table.py build/release/app/sherd [SEEDS [SPEED...]]

Arms are counted where cracks cross circles about the impact, and where they meet the frame; radial is the share of the
length of the first millisecond's cracks within 20 degrees of the direction away from the impact; dust is the share of
the area in pieces of fewer than 4 faces. Makes as many runs at once as there are processors. Needs h5py and numpy.
"""
import itertools
import multiprocessing.pool
import os
import sys

import h5py
import numpy

from recorded_run import cracks, recorded_run

SCENE = "window_ball.toml"
BLOW, HALF_WIDTH = numpy.array([0.013, 0.008]), 0.2  # m
SPEEDS, EDGES, RADII = (5, 10, 20), (0.008, 0.0067, 0.0056), (0.04, 0.08, 0.12)


def first_millisecond(recording):
    """Returns the radial share of the length of the first millisecond's cracks."""
    with h5py.File(recording) as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        rest = frame["rest/position"][:, :2][frame["vertex/original"][:]]
        failure = file["events/failure"]
        ends = rest[failure["vertices"][:][failure["time"][:] <= 1e-3]]
    along, away = ends[:, 1] - ends[:, 0], ends.mean(axis=1) - BLOW
    length = numpy.linalg.norm(along, axis=1)
    cosine = numpy.abs((along * away).sum(axis=1)) / (length * numpy.linalg.norm(away, axis=1))
    return length[cosine > numpy.cos(numpy.radians(20))].sum() / length.sum()


def dust(recording):
    with h5py.File(recording) as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        piece, area = frame["face/fragment"][:], frame["rest/area"][:]
    return area[numpy.bincount(piece)[piece] < 4].sum() / area.sum()


def measures(program, speed, edge, seed):
    """Returns arms at the circles and at the frame, radial, dust, pieces, and energy lost to cracks (J), of a run."""
    settings = [f"seed={seed}", f"obstacle.ball.velocity=[0,0,-{speed}]", f"sheet.pane.mesh.edge_length={edge}"]
    with recorded_run(program, SCENE, settings) as recording:
        found, shares, lost = cracks(recording)
        away = numpy.linalg.norm(found - BLOW, axis=2)
        arms = [int(((away < r).sum(axis=1) == 1).sum()) for r in RADII]
        at_frame = (numpy.abs(found).max(axis=2) > HALF_WIDTH - 1e-6).sum(axis=1) == 1
        return "/".join(map(str, arms)), at_frame.sum(), first_millisecond(recording), dust(recording), \
            (shares > 0).sum(), lost


def main():
    program, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 5
    speeds = [float(speed) for speed in sys.argv[3:]] or SPEEDS
    print(f"| speed (m/s) | edges (mm) | arms at {' / '.join(f'{100 * r:g}' for r in RADII)} cm, a mesh each | at the "
          "frame | radial | dust | pieces | energy of cracks (J) |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with multiprocessing.pool.ThreadPool(os.cpu_count()) as pool:
        for speed, edge in itertools.product(speeds, EDGES):
            rows = pool.starmap(measures, [(program, speed, edge, seed) for seed in range(1, seeds + 1)], chunksize=1)
            columns = [", ".join(f"{value:{form}}" for value in column)
                       for column, form in zip(zip(*rows), ("s", "d", ".0%", ".2%", "d", ".2f"))]
            print(f"| {speed:g} | {1000 * edge:g} | {' | '.join(columns)} |", flush=True)


if __name__ == "__main__":
    main()
