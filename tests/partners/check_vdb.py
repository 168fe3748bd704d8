# SPDX-License-Identifier: GPL-3.0-or-later
"""check_vdb.py RUN.h5 FOLDER

Reads the level sets that export_all.py wrote into FOLDER, one for each frame, with OpenVDB's vdb_print: the lowest
value must be minus half the thickness, the background three voxels, and the bounding box that of the sheet."""

import os
import re
import subprocess
import sys

import h5py
import numpy as np


def number(text, what):
    return float(re.search(what + r": +\[?(-?[0-9.e-]+)", text).group(1))


def corner(text, which):
    return np.array([int(n) for n in re.search(which + r": \[([-0-9, ]+)\]", text).group(1).split(",")])


def check_file(path, frame, thickness):
    text = subprocess.run(["vdb_print", "-l", path], check=True, capture_output=True, text=True).stdout
    voxel = thickness / 4
    assert "Name: surface" in text and "class: level set" in text, text
    assert np.isclose(number(text, "voxel size"), voxel)
    assert np.isclose(number(text, "Background value"), 3 * voxel)
    # The centre of at least one voxel is nearly on the middle surface.
    assert -thickness / 2 - 1e-9 < number(text, "Min value") < -thickness / 2 + voxel / 4
    points = frame["vertex/position"][:]
    for found, bound, side in (("file_bbox_min", points.min(axis=0), -1), ("file_bbox_max", points.max(axis=0), 1)):
        expected = bound + side * (thickness / 2 + 3 * voxel)
        assert np.all(np.abs(corner(text, found) * voxel - expected) < 2 * voxel), (path, found)


def main():
    with h5py.File(sys.argv[1], "r") as file:
        names = sorted(file["frames"])
        for name in names:
            path = os.path.join(sys.argv[2], f"volume_{name}.vdb")
            check_file(path, file["frames"][name], file["rest/thickness"][:].min())
    print(f"vdb_print shows all {len(names)} level sets")


main()
