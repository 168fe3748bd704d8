#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints how fast a shard creeps on a slope of 10 degrees, on which friction of 0.3 can hold it: the largest
displacement of a vertex in the second half of a run of 1 s, as a velocity.

    tests/benchmarks/slope_table.py build/release/app/sherd

Needs h5py and numpy; takes ten seconds.
"""
import math
import pathlib
import sys
import tempfile

import h5py
import numpy

from recorded_run import recorded_run

TILT = math.radians(10)
SCENE = f"""duration = 1
[sheet.shard]
mesh = {{ generate = "rectangle", width = 0.05, height = 0.03, edge_length = 0.01 }}
place = {{ translate = [0, 0, 0.00205], rotate = {{ axis = [0, 1, 0], degrees = 10 }} }}
material = {{ preset = "stoneware" }}
[obstacle.ramp]
plane = {{ point = [0, 0, 0], normal = [{math.sin(TILT)}, 0, {math.cos(TILT)}] }}
young = 1e9
friction = 0.3
[output]
every = 0.5
"""


def creep(program, scene, scheme, step):
    settings = [f"solver.scheme={scheme}", f"solver.step={step}"]
    with recorded_run(program, scene, settings) as recording, h5py.File(recording) as file:
        half, end = (file["frames"][name]["vertex/position"][:] for name in sorted(file["frames"])[1:])
        return numpy.linalg.norm(end - half, axis=1).max()


def main():
    print("| scheme | step (s) | creeps (m/s) |\n| --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "slope.toml"
        scene.write_text(SCENE)
        for scheme, step in (("implicit-euler", 1e-3), ("implicit-euler", 1e-4), ("bdf2", 1e-3),
                             ("explicit", 1e-4), ("auto", 1e-3)):
            print(f"| {scheme} | {step:g} | {creep(sys.argv[1], scene, scheme, step) / 0.5:.1e} |", flush=True)


if __name__ == "__main__":
    main()
