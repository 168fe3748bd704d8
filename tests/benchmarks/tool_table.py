#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives blunt tools through a film and prints the wavelength, the swing from side to side and the longest burst of its
oscillating crack over the tool's width; and the energy lost to cracks over G_c times the area of the crack.

    tests/benchmarks/tool_table.py build/release/app/sherd [SEEDS [EDGE...]] [--tool WIDTH]...

EDGE: edge lengths of the meshes, m; WIDTH: width of the tool, m. Takes minutes a run. Needs h5py and numpy.
"""
import argparse
import itertools
import tomllib

import h5py
import numpy

from recorded_run import SCENES, recorded_run

SCENE = "experiments/blunt_tool.toml"
WIDTHS = (0.012, 0.016, 0.019)  # m, widths of tools that fit into the notch


def path(recording, start):
    """Returns the path at rest, m, of the crack that has propagated from a point, and the step of each place."""
    with h5py.File(recording) as file:
        frame, failure = file["frames"][sorted(file["frames"])[-1]], file["events/failure"]
        rest = frame["rest/position"][:][frame["vertex/original"][:]]
        ends, steps = rest[failure["vertices"][:]][:, :, :2], failure["step"][:]
    places, when = [numpy.array(start)], [0]
    for edge, step in zip(ends[steps > 0], steps[steps > 0]):
        away = numpy.linalg.norm(edge - places[-1], axis=1)
        if away.min() < 1e-4:
            places.append(edge[numpy.argmax(away)])
            when.append(step)
    return numpy.array(places), numpy.array(when)


def longest_burst(places, when):
    """Returns the largest propagation of the crack in one step, m."""
    return numpy.bincount(when[1:], numpy.linalg.norm(numpy.diff(places, axis=0), axis=1)).max()


def turns(places, least):
    """Returns the points of a path, [N, 2] m, where x turns back by at least `least` (m)."""
    found, far, sign = [], places[0], 0
    for place in places[1:]:
        if sign * (place[0] - far[0]) >= 0:
            sign = sign or numpy.sign(place[0] - far[0])
            far = place
        elif abs(place[0] - far[0]) >= least:
            found.append(far)
            far, sign = place, -sign
    return numpy.array(found)


def energy_taken(recording, places, film):
    """Returns the energy lost to cracks over G_c times the area of the crack."""
    with h5py.File(recording) as file:
        taken = file["steps/lost_to_cracks"][-1]
    material = film["material"]
    area = numpy.linalg.norm(numpy.diff(places, axis=0), axis=1).sum() * material["thickness"]
    return taken / (film["fracture"]["toughness"] ** 2 / material["young"] * area)


def row(recording, film, width, edge):
    """Returns the cells of a run in the table."""
    places, when = path(recording, film["fracture"]["crack"]["line"][1][:2])
    found = turns(places, 2 * edge)  # smaller turns follow the mesh
    swings = numpy.abs(numpy.diff(found, axis=0)) / width
    length, side = (2 * swings[:, 1].mean(), swings[:, 0].mean()) if len(swings) else (numpy.nan, 0)
    return (f"{len(found)} | {length:.1f} | {side:.1f} | "
            f"{longest_burst(places, when) / width:.1f} | {energy_taken(recording, places, film):.2f} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("seeds", type=int, nargs="?", default=1)
    parser.add_argument("edges", type=float, nargs="*")
    parser.add_argument("--tool", type=float, action="append")
    options = parser.parse_args()
    film = tomllib.loads((SCENES / SCENE).read_text())["sheet"]["film"]
    print("| tool (mm) | edges (mm) | seed | turns | wavelength | from side to side | longest burst | energy |")
    print("| --- " * 8 + "|")
    for width, edge, seed in itertools.product(options.tool or WIDTHS, options.edges or [film["mesh"]["edge_length"]],
                                               range(1, options.seeds + 1)):
        settings = [f"seed={seed}", f"obstacle.tool.cylinder.radius={width / 2}", f"sheet.film.mesh.edge_length={edge}"]
        with recorded_run(options.program, SCENE, settings) as recording:
            print(f"| {1000 * width:g} | {1000 * edge:g} | {seed} | {row(recording, film, width, edge)}", flush=True)


if __name__ == "__main__":
    main()
