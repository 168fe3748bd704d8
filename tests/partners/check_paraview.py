# SPDX-License-Identifier: GPL-3.0-or-later
"""pvpython check_paraview.py RUN.xdmf SUMMARY.json

Steps through a recording with ParaView's XDMFReader and compares every frame with the summary that check_recording.py
has made by h5py."""

import json
import sys

import numpy as np
from paraview.servermanager import Fetch
from paraview.simple import XDMFReader
from vtk.util.numpy_support import vtk_to_numpy


def extremes(array, component):
    assert array is not None
    return list(array.GetRange(component))


def check_arrays(data, expected, where):
    assert data.GetNumberOfArrays() == len(expected), where
    for name, limits in expected.items():
        array = data.GetArray(name)
        assert array is not None, f"{where}: no array '{name}'"
        component = array.GetNumberOfComponents() - 1
        assert extremes(array, component) == limits, f"{where} {name}: {extremes(array, component)} != {limits}"


def block_named(data, name):
    for i in range(data.GetNumberOfBlocks()):
        if data.GetMetaData(i).Get(data.NAME()) == name:
            return data.GetBlock(i)
    raise AssertionError(f"no block '{name}'")


def check_obstacles(data, expected):
    for number, wanted in enumerate(expected):
        name, block = data.GetMetaData(2 + number).Get(data.NAME()), data.GetBlock(2 + number)
        # The reader appends [1] to a name that another block has.
        assert name.startswith(f"obstacle {wanted['name']}"), name
        points = vtk_to_numpy(block.GetPoints().GetData())
        assert np.allclose(points, wanted["points"], rtol=0, atol=1e-12 * (1 + np.abs(points).max())), name
        corners = [[block.GetCell(i).GetPointId(k) for k in range(3)] for i in range(block.GetNumberOfCells())]
        assert corners == wanted["face"], name


def check_frame(data, expected):
    assert data.GetNumberOfBlocks() == 2 + len(expected["obstacles"])
    check_obstacles(data, expected["obstacles"])
    for name, corners in (("surface", 3), ("edges", 2)):
        block, wanted = block_named(data, name), expected[name]
        where = f"time {expected['time']} {name}"
        assert block.GetNumberOfCells() == wanted["cells"], where
        assert block.GetNumberOfPoints() == expected["points"], where
        assert all(block.GetCell(i).GetNumberOfPoints() == corners for i in range(wanted["cells"])), where
        check_arrays(block.GetCellData(), wanted["cell"], where)
        check_arrays(block.GetPointData(), wanted["point"], where)


def main():
    with open(sys.argv[2], encoding="utf-8") as file:
        frames = json.load(file)
    reader = XDMFReader(FileNames=[sys.argv[1]])
    reader.UpdatePipelineInformation()
    assert list(reader.TimestepValues) == [frame["time"] for frame in frames], list(reader.TimestepValues)
    for frame in frames:
        reader.UpdatePipeline(frame["time"])
        check_frame(Fetch(reader), frame)
    print(f"ParaView shows all {len(frames)} frames")


main()
