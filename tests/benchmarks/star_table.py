#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Strikes plates of PMMA at several speeds on several meshes and prints the numbers of arms of the star cracks.

    tests/benchmarks/star_table.py build/release/app/sherd [SEEDS [SPEED...]]

Arms are counted where cracks cross circles about the impact, at rest; energy is the energy lost to cracks over the
fracture energy times their area. Takes minutes. Needs h5py and numpy.
"""
import sys

import numpy

from recorded_run import cracks, recorded_run

SCENE = "experiments/struck_plate.toml"
BLOW = numpy.array([0.001, 0.0007])
THICKNESS, FRACTURE_ENERGY = 1e-3, 1.1e6 ** 2 / 3.2e9  # m, J/m^2: K_Ic^2 / Y
SPEEDS, EDGES, RADII = ("12", "20", "50", "70", "100"), (0.002, 0.0016, 0.00125), (0.005, 0.01, 0.015)


def main():
    program, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2
    chosen = sys.argv[3:] or SPEEDS
    print("| speed (m/s) | edges (mm) | arms at 5 / 10 / 15 mm, a mesh each | length of cracks (mm) | energy | pieces |")
    print("| --- | --- | --- | --- | --- | --- |")
    speeds, counts = [], []
    for speed in chosen:
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
    if len(set(speeds)) < 3:
        return
    (power, _), covariance = numpy.polyfit(numpy.log(speeds), numpy.log(counts), 1, cov=True)
    print(f"arms at 10 mm go with the power {power:.2f} of the speed, with a deviation of {covariance[0, 0] ** 0.5:.2f}")


if __name__ == "__main__":
    main()
