# SPDX-License-Identifier: GPL-3.0-or-later
"""pvpython check_pvd.py RUN.pvd RUN.h5

Steps through the .pvd with ParaView and compares every array of every frame with the recording, to the last bit."""

import sys

import h5py
import numpy as np
from paraview.servermanager import Fetch
from paraview.simple import PVDReader
from vtk.util.numpy_support import vtk_to_numpy


def face_strain(frame):
    """Largest absolute strain of each face's edges, found another way than the program does."""
    strain = {}
    for ends, value in zip(frame["edge/vertices"][:].tolist(), frame["edge/strain"][:]):
        strain[frozenset(ends)] = abs(value)
    return np.array(
        [
            max(strain[frozenset(side)] for side in ((a, b), (b, c), (c, a)))
            for a, b, c in frame["face/vertices"][:].tolist()
        ]
    )


def check_frame(data, frame):
    same = np.testing.assert_array_equal
    same(vtk_to_numpy(data.GetPoints().GetData()), frame["vertex/position"][:])
    same(vtk_to_numpy(data.GetPointData().GetArray("velocity")), frame["vertex/velocity"][:])
    speed = vtk_to_numpy(data.GetPointData().GetArray("speed"))
    assert np.allclose(speed, frame["vertex/speed"][:], rtol=1e-14, atol=0)
    same(vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3), frame["face/vertices"][:])
    for name in ("fragment", "sheet"):
        same(vtk_to_numpy(data.GetCellData().GetArray(name)), frame["face"][name][:])
    same(vtk_to_numpy(data.GetCellData().GetArray("strain")), face_strain(frame))


def main():
    reader = PVDReader(FileName=sys.argv[1])
    reader.UpdatePipelineInformation()
    with h5py.File(sys.argv[2], "r") as file:
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        assert list(reader.TimestepValues) == [frame.attrs["time"] for frame in frames], list(reader.TimestepValues)
        for frame in frames:
            reader.UpdatePipeline(frame.attrs["time"])
            check_frame(Fetch(reader), frame)
    print(f"ParaView shows all {len(frames)} frames of the .pvd as they were recorded")


main()
