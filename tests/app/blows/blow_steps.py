#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""blow_steps.py SCENE RECORDING: runs a scene from Python and records each single step, for blow_recording.py. The
program's recordings have frames only at the ends of the scene's steps, not of the parts of halved steps and of the
short steps of "auto" in between."""
import sys

import h5py
import numpy
import sherd


def frame(file, number, simulation):
    group = file.create_group(f"frames/{number:09}")
    group.attrs["time"] = simulation.time
    group["vertex/position"] = simulation.positions
    group["vertex/velocity"] = simulation.velocities
    if simulation.poses:
        group["obstacle/pose"] = numpy.array([pose[:3].ravel() for pose in simulation.poses.values()])
    return group


def main():
    scene, recording = sys.argv[1:]
    simulation = sherd.Simulation(scene)
    with h5py.File(recording, "w") as file:
        file["rest/sheet_names"] = [name.encode() for name in simulation.scene.sheets]
        if simulation.poses:
            file["obstacles/names"] = [name.encode() for name in simulation.poses]
        first = frame(file, 0, simulation)
        state = simulation.snapshot()
        first["vertex/mass"], first["face/vertices"], first["face/sheet"] = state.masses, state.faces, state.face_sheets
        count = 0
        while not simulation.has_ended:
            simulation.step()
            count += 1
            frame(file, count, simulation)


if __name__ == "__main__":
    main()
