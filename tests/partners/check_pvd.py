# SPDX-License-Identifier: GPL-3.0-or-later
"""pvpython check_pvd.py RUN.pvd RUN.h5, of a run with obstacles

Steps through the .pvd with ParaView and compares every array of every frame with the recording, bit by bit. Also reads
the .vtp files with Python's XML parser, base64 and zlib, as other programs do."""

import base64
import pathlib
import sys
import xml.etree.ElementTree
import zlib

import h5py
import numpy as np
from paraview.servermanager import Fetch
from paraview.simple import PVDReader
from vtk.util.numpy_support import vtk_to_numpy


FIELDS = [f"{name}{end}" for name in ("curvature", "membrane_strain", "stress_top", "stress_bottom")
          for end in ("", "_principal")]


def face_strain(frame):
    """Returns the largest absolute strain of each face's edges, by another algorithm than the program's."""
    strain = {}
    for ends, value in zip(frame["edge/vertices"][:].tolist(), frame["edge/strain"][:]):
        strain[frozenset(ends)] = abs(value)
    return np.array(
        [
            max(strain[frozenset(side)] for side in ((a, b), (b, c), (c, a)))
            for a, b, c in frame["face/vertices"][:].tolist()
        ]
    )


def vtp_array(element):
    """Returns the numbers of a DataArray. Its text is a base64 header, with the number of blocks and their sizes before
    and after compression, followed by the blocks, in base64 of their own."""
    text = element.text.strip()
    blocks, whole, last = np.frombuffer(base64.b64decode(text[:32]), np.uint64)
    head = (8 * (3 + int(blocks)) + 2) // 3 * 4
    sizes = np.frombuffer(base64.b64decode(text[:head]), np.uint64)[3:]
    data = base64.b64decode(text[head:])
    ends = np.cumsum(sizes, dtype=int)
    assert ends[-1] == len(data)
    parts = [zlib.decompress(data[end - int(size) : end]) for end, size in zip(ends, sizes)]
    assert all(len(part) == whole for part in parts[:-1]) and len(parts[-1]) == (last or whole)
    return np.frombuffer(b"".join(parts), element.get("type").lower())


def check_vtp(path, frame):
    same = np.testing.assert_array_equal
    root = xml.etree.ElementTree.parse(path).getroot()
    assert root.get("header_type") == "UInt64" and root.get("compressor") == "vtkZLibDataCompressor"
    arrays = {element.get("Name"): vtp_array(element) for element in root.iter("DataArray")}
    same(arrays["Points"].reshape(-1, 3), frame["vertex/position"][:])
    same(arrays["velocity"].reshape(-1, 3), frame["vertex/velocity"][:])
    same(arrays["connectivity"].reshape(-1, 3), frame["face/vertices"][:])
    same(arrays["offsets"], 3 * np.arange(1, len(arrays["fragment"]) + 1))
    for name in ("fragment", "sheet"):
        same(arrays[name], frame["face"][name][:])


def check_frame(data, frame):
    same = np.testing.assert_array_equal
    same(vtk_to_numpy(data.GetPoints().GetData()), frame["vertex/position"][:])
    same(vtk_to_numpy(data.GetPointData().GetArray("velocity")), frame["vertex/velocity"][:])
    speed = vtk_to_numpy(data.GetPointData().GetArray("speed"))
    assert np.allclose(speed, frame["vertex/speed"][:], rtol=1e-14, atol=0)
    same(vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3), frame["face/vertices"][:])
    for name in ("fragment", "sheet", *(name for name in FIELDS if name in frame["face"])):
        same(vtk_to_numpy(data.GetCellData().GetArray(name)), frame["face"][name][:])
    same(vtk_to_numpy(data.GetCellData().GetArray("strain")), face_strain(frame))


def check_obstacles(data, file, frame):
    """Checks the blocks of obstacles, which follow that of the sheets; each has one part."""
    names = file["obstacles/names"].asstr()[:]
    assert data.GetNumberOfBlocks() == 1 + len(names)
    for number, pose in enumerate(frame["obstacle/pose"][:].reshape(-1, 3, 4)):
        block, surface = data.GetBlock(1 + number).GetBlock(0), file[f"obstacles/{number}"]
        assert data.GetMetaData(1 + number).Get(data.NAME()) == f"obstacle_{names[number]}"
        places = surface["position"][:] @ pose[:, :3].T + pose[:, 3]
        assert np.allclose(vtk_to_numpy(block.GetPoints().GetData()), places, rtol=0, atol=1e-12)
        corners = vtk_to_numpy(block.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        np.testing.assert_array_equal(corners, surface["face"][:])


def main():
    reader = PVDReader(FileName=sys.argv[1])
    reader.UpdatePipelineInformation()
    files = xml.etree.ElementTree.parse(sys.argv[1]).getroot().iter("DataSet")
    sheets = [part.get("file") for part in files if part.get("part") == "0"]
    with h5py.File(sys.argv[2], "r") as file:
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        assert list(reader.TimestepValues) == [frame.attrs["time"] for frame in frames], list(reader.TimestepValues)
        for frame, name in zip(frames, sheets, strict=True):
            check_vtp(pathlib.Path(sys.argv[1]).parent / name, frame)
            reader.UpdatePipeline(frame.attrs["time"])
            data = Fetch(reader)
            check_obstacles(data, file, frame)
            check_frame(data.GetBlock(0).GetBlock(0), frame)
    print(f"ParaView shows all {len(frames)} frames of the .pvd as they were recorded")


main()
