# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the player for Blender without Blender, for a recording with obstacles: each must be an object of its own at its
recorded pose; half way between frames its middle must have moved half way in a straight line, and its rotation be half.

usage: check_player_obstacles.py BLENDER RECORDING.h5, BLENDER: app/blender"""
import sys
import types

import h5py
import numpy as np

from check_player import player, scene


def poses(frame):
    return frame["obstacle/pose"][:].reshape(-1, 3, 4)


def rotation(pose):
    return pose[:3, :3]


def check_half_way(solid, earlier, later):
    pose, near = np.array(solid.matrix_basis), dict(rtol=0, atol=1e-12)
    way = rotation(pose) @ rotation(earlier).T
    assert np.allclose(way @ way, rotation(later) @ rotation(earlier).T, **near), "half of the turn"
    assert np.trace(way) >= 1 - 1e-12, "the longer way round"
    middle = solid.data.vertices.values["co"].reshape(-1, 3).mean(axis=0)
    start, end = (p[:, :3] @ middle + p[:, 3] for p in (earlier, later))
    assert np.allclose(pose[:3, :3] @ middle + pose[:3, 3], (start + end) / 2, **near), "the middle"


def main(folder, recording):
    module, shown = player(folder), scene()
    linked = []
    shown.collection.objects.link = linked.append
    target = module.load(recording, types.SimpleNamespace(scene=shown), slow=1)
    solids = linked[1:]
    assert linked[0] is target and all(solid.parent is target for solid in solids)
    target.children = solids
    with h5py.File(recording) as file:
        names = file["obstacles/names"].asstr()[:]
        assert [solid.name for solid in solids] == [f"obstacle_{name}" for name in names]
        for number, solid in enumerate(solids):
            surface = file[f"obstacles/{number}"]
            assert np.array_equal(solid.data.vertices.values["co"], surface["position"][:].ravel())
            assert np.array_equal(solid.data.loops.values["vertex_index"], surface["face"][:].ravel())
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        times = [frame.attrs["time"] for frame in frames]
        moved = 0
        for number in range(len(frames) - 1, -1, -1):
            shown.frame_subframe = (times[number] - times[0]) * 24
            module.show(target, shown)
            for solid, pose in zip(solids, poses(frames[number])):
                assert np.array_equal(np.array(solid.matrix_basis), np.vstack([pose, [0, 0, 0, 1]]))
            if number == 0:
                break
            shown.frame_subframe = ((times[number] + times[number - 1]) / 2 - times[0]) * 24
            module.show(target, shown)
            for solid, earlier, later in zip(solids, poses(frames[number - 1]), poses(frames[number])):
                check_half_way(solid, earlier, later)
                moved += not np.array_equal(earlier, later)
    assert moved > 0, "no obstacle moves in this recording"
    print(f"the player shows {len(solids)} obstacles in {len(frames)} frames and half way between")


main(*sys.argv[1:])
