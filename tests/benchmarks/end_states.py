#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""end_states [--short] SHERD: compares the default solver with Newton's method converged to 1e-10 mean edge lengths.

Where nothing breaks: the largest distance between corresponding vertices of both runs, in mean edge lengths, after 1,
10 and 50 steps. Where a plate breaks: means and standard deviations over ten meshes from ten seeds, and the probability
that means differ by as much if the results of both solvers are assigned at random (permutation test).

Needs h5py and numpy; takes half an hour of processor time, --short a few minutes.
"""
import itertools
import sys

import h5py
import numpy

from recorded_run import recorded_run

DEFAULT, CONVERGED = ["solver.method=quasi-newton"], ["solver.method=newton", "solver.tolerance=1e-10"]
STEPS = (1, 10, 50)
SEEDS = range(1, 11)
# Scenes in which nothing breaks: scene, step (s), settings, options.
QUIET = [("plate_drop.toml", 1e-4, ["sheet.plate.fracture.strain=1e9"], []),
         ("bowl_drop.toml", 1e-4, ["sheet.bowl.fracture.strain=1e9"], []),
         ("drape.toml", 1e-3, [], []),
         ("sheet_hang.toml", 1e-3, [], []),
         ("paper/figure_5_flags.toml", 1e-3, [], ["--variant", "vertical"])]
BREAKING, UNTIL = "plate_drop.toml", 0.006  # s


def last_frame(file):
    return file["frames"][sorted(file["frames"])[-1]]


def end(program, scene, settings, options):
    """Runs a scene; returns the positions of vertices at the end, [V, 3] m, and the mean length of edges (m)."""
    with recorded_run(program, scene, settings, *options) as recording, h5py.File(recording) as file:
        frame = last_frame(file)
        positions, edges = frame["vertex/position"][:], frame["edge/vertices"][:]
        lengths = numpy.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)
        return positions, lengths.mean()


def quiet_row(program, scene, step, settings, options, counts):
    cells = []
    for count in counts:
        common = settings + [f"solver.step={step}", f"duration={count * step}", f"output.every={count * step}"]
        (one, edge), (other, _) = (end(program, scene, common + way, options) for way in (DEFAULT, CONVERGED))
        cells.append(f"{numpy.linalg.norm(one - other, axis=1).max() / edge:.1e}" if len(one) == len(other) else "broken")
    print(f"| {scene.removesuffix('.toml')} | {step:g} | {len(one)} | {' | '.join(cells)} |", flush=True)


def outcome(program, seed, way):
    """Breaks the plate; returns the quantities of the table by name."""
    settings = [f"duration={UNTIL}", f"output.every={UNTIL}", f"seed={seed}", *way]
    with recorded_run(program, BREAKING, settings) as recording, h5py.File(recording) as file:
        frame, steps = last_frame(file), file["steps"]
        shares = numpy.bincount(frame["face/fragment"][:], weights=frame["rest/area"][:])
        return {"edges that failed": len(file["events/failure/time"]), "fragments": len(shares),
                "largest fragment (share of the area)": shares.max() / shares.sum(),
                "lost to cracks (J)": steps["lost_to_cracks"][-1], "kinetic energy at the end (J)": steps["kinetic"][-1]}


def probability(one, other):
    """Returns the probability that means differ by as much if the values are assigned to both groups at random."""
    both, count = numpy.concatenate([one, other]), len(one)
    sums = numpy.array([sum(chosen) for chosen in itertools.combinations(both, count)])
    apart = numpy.abs(2 * sums - both.sum())
    return numpy.mean(apart >= abs(one.sum() - other.sum()) * (1 - 1e-12))


def breaking_table(program, seeds):
    ways = [[outcome(program, seed, way) for seed in seeds] for way in (DEFAULT, CONVERGED)]
    print(f"\n{BREAKING.removesuffix('.toml')}, {1000 * UNTIL:g} ms, {len(seeds)} meshes:\n\n"
          "| what | default | newton, 1e-10 | probability |\n| --- | --- | --- | --- |")
    for name in ways[0][0]:
        one, other = (numpy.array([run[name] for run in way], float) for way in ways)
        cells = [f"{values.mean():.3g} +- {values.std(ddof=1):.2g}" for values in (one, other)]
        print(f"| {name} | {' | '.join(cells)} | {probability(one, other):.2f} |")


def main():
    short = "--short" in sys.argv
    program = next(word for word in sys.argv[1:] if word != "--short")
    counts = STEPS[:2] if short else STEPS
    print(f"| scene | step (s) | vertices | {' | '.join(f'{count} steps' for count in counts)} |")
    print("| --- " * (3 + len(counts)) + "|")
    for case in QUIET:
        quiet_row(program, *case, counts)
    breaking_table(program, SEEDS[:3] if short else SEEDS)


if __name__ == "__main__":
    main()
