#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""many_at_rest.py SHERD [--fragments N]

N (10,000) small shards, each tilted differently, fall onto a floor and come to rest there: all must lie on it at the
end, none may move in the second half of the run, and no energy may be created. SHERD_SHORT in the environment: 400
shards."""

import argparse
import math
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import recorded_rest  # noqa: E402

SIDE, PITCH, THICKNESS = 0.008, 0.010, 0.001  # m
SCENE = f"""
duration = 0.4
[sheet.shards]
mesh = {{ file = "shards.obj" }}
material = {{ preset = "stoneware", thickness = {THICKNESS} }}
[obstacle.floor]
plane = {{}}
friction = 0.5
[contact]
friction = 0.5
[solver]
step = 1e-3
[output]
every = 0.01
"""
STILL = 1e-6 * SIDE  # m, largest displacement in the second half
ENERGY = 1e-6        # largest energy residual over the largest energy


def tilted(random):
    """Returns a random rotation matrix: about z, a tilt by 30 degrees at most, about z again."""
    def about(axis, angle):
        turn, (i, j) = numpy.eye(3), [(1, 2), (0, 1)][axis]
        turn[[i, i, j, j], [i, j, i, j]] = math.cos(angle), -math.sin(angle), math.sin(angle), math.cos(angle)
        return turn
    return (about(1, random.uniform(0, math.tau)) @ about(0, random.uniform(0, math.pi / 6))
            @ about(1, random.uniform(0, math.tau)))


def write_shards(file, count):
    """Writes triangles on a square grid, 4 to 7 mm above the floor."""
    random, columns = numpy.random.default_rng(3), math.isqrt(count - 1) + 1
    angles = math.tau * numpy.arange(3) / 3
    triangle = SIDE / math.sqrt(3) * numpy.array([numpy.cos(angles), numpy.sin(angles), numpy.zeros(3)])
    with open(file, "w") as out:
        for i in range(count):
            place = [PITCH * (i % columns), PITCH * (i // columns), random.uniform(0.004, 0.007)]
            for point in (tilted(random) @ triangle).T + place:
                print("v", *map(repr, point.tolist()), file=out)
            print("f -3 -2 -1", file=out)


def problems(recording, count):
    """Returns descriptions of what is wrong with a run."""
    end, moved, nowhere, fragments, steps = recorded_rest.at_the_end(recording)
    highest = end[:, 2].max()
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    print(f"{fragments} fragments in {steps} steps, {seconds:.0f} s of processor time; in the second half they "
          f"move by {moved:.1e} m at most, the highest point is {1e3 * highest:.2f} mm above the floor; {nowhere:.1e} "
          "of the largest energy is unexplained")
    return [words for wrong, words in ((fragments != count, "fragments are lost"), (moved > STILL, "what rests moves"),
                                       (end[:, 2].min() < 0, "one is in the floor"),
                                       (highest > 2 * THICKNESS, "one does not lie on the floor"),
                                       (nowhere > ENERGY, "energy comes from nowhere")) if wrong]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sherd")
    parser.add_argument("--fragments", type=int, default=10_000)
    options = parser.parse_intermixed_args()
    count = min(options.fragments, 400) if "SHERD_SHORT" in os.environ else options.fragments
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_shards(folder / "shards.obj", count)
        (folder / "shards.toml").write_text(SCENE)
        recording = folder / "shards.h5"
        done = subprocess.run([options.sherd, "run", folder / "shards.toml", "-o", recording], capture_output=True,
                              text=True)
        wrong = problems(recording, count) if done.returncode == 0 else [done.stderr]
    sys.exit("; ".join(wrong) or 0)


main()
