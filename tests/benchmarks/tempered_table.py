#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Notches panes of tempered glass and prints the numbers of pieces into which they break.

    tests/benchmarks/tempered_table.py build/release/app/sherd [SEEDS [STRESS...]]

STRESS: surface compression of the rows to make, MPa. Pieces are counted as standards of tempered glass do, in a square
of 50 x 50 mm in the middle: pieces that its sides cut count half. Residual: energy of the tempering stress at the end
over that at the start. Takes minutes a row. Needs h5py and numpy.
"""
import sys

import h5py
import numpy

from recorded_run import recorded_run

SCENE = "experiments/tempered_glass.toml"
HALF_WINDOW = 0.025  # m
# Surface compression (Pa), thickness (m), edge length (m), step (s) in which a crack propagates by less than an edge
CASES = ((6e7, 0.006, 0.001, 5e-7), (8e7, 0.006, 0.001, 5e-7), (1.03e8, 0.006, 0.001, 5e-7),
         (1.23e8, 0.006, 0.001, 5e-7), (1.03e8, 0.004, 0.001, 5e-7), (1.03e8, 0.006, 0.0014, 5e-7),
         (1.03e8, 0.006, 0.0007, 3e-7))


def pieces(recording):
    """Returns the numbers of pieces in the window and in the pane, the share of the pane's area in pieces of fewer than
    four faces, and the share of the residual energy that is left."""
    with h5py.File(recording) as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        rest, faces = frame["rest/position"][:, :2], frame["rest/faces"][:]
        piece, area = frame["face/fragment"][:], frame["rest/area"][:]
        residual = file["steps/residual"][:]
    inside = (abs(rest[faces].mean(axis=1) - rest.mean(axis=0)) < HALF_WINDOW).all(axis=1)
    whole, within = numpy.bincount(piece), numpy.bincount(piece[inside], minlength=piece.max() + 1)
    count = (within == whole)[within > 0].sum() + 0.5 * (within < whole)[within > 0].sum()
    return count, (whole > 0).sum(), area[whole[piece] < 4].sum() / area.sum(), residual[-1] / residual[0]


def main():
    program, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2
    chosen = [1e6 * float(stress) for stress in sys.argv[3:]]
    print("| compressed by (MPa) | thickness (mm) | edges (mm) | pieces on 50 x 50 mm, a mesh each | of the pane | "
          "dust | residual |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for stress, thickness, edge, step in CASES:
        if chosen and stress not in chosen:
            continue
        rows = []
        for seed in range(1, seeds + 1):
            settings = [f"seed={seed}", f"sheet.pane.material.tempered={stress}",
                        f"sheet.pane.material.thickness={thickness}",
                        f"sheet.pane.mesh.edge_length={edge}", f"solver.step={step}"]
            with recorded_run(program, SCENE, settings) as recording:
                rows.append(pieces(recording))
        columns = [", ".join(f"{value:{form}}" for value in column)
                   for column, form in zip(zip(*rows), ("g", "d", ".2%", ".2f"))]
        print(f"| {stress / 1e6:g} | {1000 * thickness:g} | {1000 * edge:g} | {' | '.join(columns)} |", flush=True)


if __name__ == "__main__":
    main()
