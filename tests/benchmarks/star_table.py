#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Strikes plates of PMMA at several speeds on several meshes and prints how many arms their stars have.

    tests/benchmarks/star_table.py build/release/app/sherd [SEEDS]

Arms are counted where cracks cross circles around the blow, at rest; energy is what went to cracks over the fracture
energy times their area. Takes minutes. Needs h5py and numpy.
"""
import collections
import sys

import h5py
import numpy

from recorded_run import recorded_run

SCENE = "experiments/struck_plate.toml"
BLOW = numpy.array([0.001, 0.0007])
THICKNESS, FRACTURE_ENERGY = 1e-3, 1.1e6 ** 2 / 3.2e9  # m, J/m^2: K_Ic^2 / Y
SPEEDS, EDGES, RADII = ("20", "50", "70"), (0.002, 0.0016, 0.00125), (0.005, 0.01, 0.015)


def cracks(recording):
    """Ends at rest of the edges that have failed: [N, 2, 2] m, each crack once, and no rim; shares of the area of all
    pieces; energy that went to cracks (J)."""
    with h5py.File(recording) as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        original, faces = frame["vertex/original"][:], frame["rest/faces"][:]
        rest, area = frame["rest/position"][:, :2], frame["rest/area"][:]
        edges, states = original[frame["edge/vertices"][:]], frame["edge/state"][:]
        shares = numpy.bincount(frame["face/fragment"][:], weights=area) / area.sum()
        lost = file["steps/lost_to_cracks"][-1]
    sides = collections.Counter(tuple(sorted((face[i], face[(i + 1) % 3]))) for face in faces for i in range(3))
    failed = {tuple(sorted(edge)) for edge, state in zip(edges, states) if state}
    return numpy.array([rest[list(edge)] for edge in sorted(failed) if sides[edge] == 2]), shares, lost


def main():
    program, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2
    print("| speed (m/s) | edges (mm) | arms at 5 / 10 / 15 mm, a mesh each | length of cracks (mm) | energy | pieces |")
    print("| --- | --- | --- | --- | --- | --- |")
    speeds, counts = [], []
    for speed in SPEEDS:
        for edge in EDGES:
            arms, lengths, energies, pieces = [], [], [], []
            for seed in range(1, seeds + 1):
                settings = [f"seed={seed}", f"sheet.plate.mesh.edge_length={edge}"]
                with recorded_run(program, SCENE, settings, "--variant", speed) as recording:
                    found, shares, lost = cracks(recording)
                away = numpy.linalg.norm(found - BLOW, axis=2)
                at = [int(((away < r).sum(axis=1) == 1).sum()) for r in RADII]
                speeds.append(float(speed))
                counts.append(at[1])
                arms.append("/".join(map(str, at)))
                length = numpy.linalg.norm(found[:, 0] - found[:, 1], axis=1).sum()
                lengths.append(f"{1000 * length:.0f}")
                energies.append(f"{lost / (FRACTURE_ENERGY * THICKNESS * length):.2f}")
                pieces.append(str(int((shares > 0).sum())))
            columns = [", ".join(column) for column in (arms, lengths, energies, pieces)]
            print(f"| {speed} | {1000 * edge:g} | {' | '.join(columns)} |", flush=True)
    (power, _), covariance = numpy.polyfit(numpy.log(speeds), numpy.log(counts), 1, cov=True)
    print(f"arms at 10 mm go with the power {power:.2f} of the speed, with a deviation of {covariance[0, 0] ** 0.5:.2f}")


if __name__ == "__main__":
    main()
