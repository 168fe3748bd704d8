#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks a glass tube, a sphere, a bowl and an eggshell and prints the distribution of the fragments' masses.

    tests/benchmarks/fragment_table.py build/release/app/sherd [SEEDS [SCENE...]]

The number of fragments of mass m is assumed to be a power law, m^-tau, between a smallest and a largest mass; tau is
the maximum likelihood estimate, with the interval in which twice the log-likelihood falls by less than 3.84 (95 %).
Takes minutes. Needs h5py and numpy.
"""
import sys

import h5py
import numpy

from recorded_run import recorded_run

# Exponents of Wittel, Kun, Herrmann and Kroeplin 2004, for shells that break by impact and by pressure.
PUBLISHED = {"glass_tube": "", "dropped_sphere": "1.35", "dropped_bowl": "1.35", "burst_egg": "1.54"}
SMALLEST_FACES = 4  # a fragment of fewer faces is as small as the mesh allows
EXPONENTS = numpy.linspace(0, 4, 2001)


def fragments(recording):
    """Returns the areas of the fragments (m^2; for a uniform thickness proportional to mass), the mean area of a face,
    and the largest magnitude of the energy lost to the scheme over the largest energy."""
    with h5py.File(recording) as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        area = frame["rest/area"][:]
        pieces = numpy.bincount(frame["face/fragment"][:], weights=area)
        steps = file["steps"]
        energy = sum(steps[name][:] for name in ("kinetic", "bending", "membrane"))
        made = numpy.abs(steps["lost_to_scheme"][:]).max() / energy.max()
    return pieces[pieces > 0], area.mean(), made


def most_likely(sizes, least, most):
    """Returns tau of m^-tau between two sizes, and its interval."""
    power = 1 - EXPONENTS[:, None]
    with numpy.errstate(divide="ignore", invalid="ignore"):
        norm = numpy.where(numpy.abs(power) < 1e-9, numpy.log(most / least), (most**power - least**power) / power)[:, 0]
    likelihood = -EXPONENTS * numpy.log(sizes).sum() - len(sizes) * numpy.log(norm)
    inside = EXPONENTS[2 * (likelihood.max() - likelihood) < 3.84]
    return EXPONENTS[likelihood.argmax()], inside.min(), inside.max()


def row(program, name, seeds):
    sizes, counts, largest, made = [], [], [], 0
    for seed in range(1, seeds + 1):
        with recorded_run(program, f"experiments/{name}.toml", [f"seed={seed}"]) as recording:
            areas, face, of_scheme = fragments(recording)
        shares = areas / areas.sum()
        sizes += list(shares[(areas > SMALLEST_FACES * face) & (shares < shares.max())])
        counts.append(str(len(areas)))
        largest.append(f"{shares.max():.2f}")
        made = max(made, of_scheme)
        least = SMALLEST_FACES * face / areas.sum()
    exponent = "-"
    if len(sizes) > 4:
        exponent = "{:.2f} ({:.2f} to {:.2f})".format(*most_likely(numpy.array(sizes), least, 0.5))
    return [name, ", ".join(counts), ", ".join(largest), str(len(sizes)), exponent, PUBLISHED[name] or "-", f"{made:.3f}"]


def main():
    program, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    print("| scene | pieces | largest | of 4 faces and more | exponent (95 %) | published | energy of the scheme |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for name in sys.argv[3:] or PUBLISHED:
        print(f"| {' | '.join(row(program, name, seeds))} |", flush=True)


if __name__ == "__main__":
    main()
