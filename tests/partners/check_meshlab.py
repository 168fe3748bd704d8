# SPDX-License-Identifier: GPL-3.0-or-later
"""with_display python3 check_meshlab.py RUN.h5 RUN.ply

Reads the .ply of the last frame with MeshLab's server and compares the statistics of the faces' quality, which is their
strain, with the recording."""

import os
import re
import subprocess
import sys
import tempfile

import h5py
import numpy as np

SCRIPT = '<!DOCTYPE FilterScript>\n<FilterScript><filter name="Per Face Quality Stat"/></FilterScript>\n'


def what_meshlab_says(mesh):
    with tempfile.TemporaryDirectory() as folder:
        script = os.path.join(folder, "statistics.mlx")
        with open(script, "w", encoding="utf-8") as out:
            out.write(SCRIPT)
        command = ["meshlabserver", "-i", os.path.abspath(mesh), "-s", script]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main():
    with h5py.File(sys.argv[1], "r") as file:
        frame = file["frames"][sorted(file["frames"])[-1]]
        strain = {
            frozenset(ends): abs(value)
            for ends, value in zip(frame["edge/vertices"][:].tolist(), frame["edge/strain"][:])
        }
        faces = frame["face/vertices"][:].tolist()
        vertices = frame["vertex/position"].shape[0]
    quality = [max(strain[frozenset(side)] for side in ((a, b), (b, c), (c, a))) for a, b, c in faces]
    said = what_meshlab_says(sys.argv[2])
    assert f"{vertices} vn {len(faces)} fn" in said, said
    lowest, largest = re.search(r"Min +([-0-9.]+) +Max +([-0-9.]+)", said).groups()
    mean = re.search(r"Avg +([-0-9.]+)", said).group(1)
    printed = np.array([float(lowest), float(largest), float(mean)])
    assert np.all(np.abs(printed - [min(quality), max(quality), np.mean(quality)]) < 2e-6), said
    assert max(quality) > 1e-4, "nothing to see"
    print(f"MeshLab finds the strain as quality, {lowest} to {largest} 1/m")


main()
