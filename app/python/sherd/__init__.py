# SPDX-License-Identifier: GPL-3.0-or-later
"""Sherd breaks plates and shells: runs scenes from Python, step by step, with numpy arrays as input and output.

    import sherd

    scene = sherd.Scene("plate_drop.toml", set={"duration": 0.005})
    simulation = sherd.Simulation(scene)
    with sherd.record(simulation, "plate.h5"):
        simulation.run(observe=lambda report: print(report.time, report.fragments))
    print(simulation.snapshot().positions)

Scene       a scene from a file or a dict; meshes may be arrays
Simulation  steps a scene: state, forces, motions, prescribed failure of edges
record      records a simulation, as `sherd run` does
Recording   reads recordings
Snapshot    state of all sheets at one time, from a Simulation or a Recording
StepReport  energies, losses, contacts and peaks of a step
cut         opens edges of a mesh, without mechanics
Mechanics   energy, gradient and Hessian of sheets at given positions, without time
Error       an error, with the program's message

All values are in SI units. Vertices, edges and faces are numbered from 0, by the rows of the arrays; numbers stay valid
while cracks append new elements. Arrays of Snapshot are read-only views and never change; all other arrays are copies
that the caller owns. Other Python threads run while a step is computed; only one thread at a time may use a simulation,
and two simulations may run in two threads. Ctrl-C takes effect after the current step, and the simulation stays usable.
Results are bitwise equal to those of the program for the same scene.
"""
from ._cut import Cut, cut
from ._mechanics import Mechanics
from ._recording import Recording, record
from ._scene import Scene
from ._sherd import Error, Snapshot, StepReport, __version__
from ._simulation import Simulation

__all__ = ["Cut", "Error", "Mechanics", "Recording", "Scene", "Simulation", "Snapshot", "StepReport", "cut", "record"]
