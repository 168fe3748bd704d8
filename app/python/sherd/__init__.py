# SPDX-License-Identifier: GPL-3.0-or-later
"""Sherd breaks plates and shells: scenes run from Python, step by step, with arrays of numpy in and out.

    import sherd

    scene = sherd.Scene("plate_drop.toml", set={"duration": 0.005})
    simulation = sherd.Simulation(scene)
    with sherd.record(simulation, "plate.h5"):
        simulation.run(observe=lambda report: print(report.time, report.fragments))
    print(simulation.snapshot().positions)

Scene       a scene, of a file or of a dict; meshes may be arrays
Simulation  steps a scene: state, forces, motions, breaking by hand
record      records a simulation, as `sherd run` does
Recording   reads recordings
Snapshot    all of the sheets at one moment, of a Simulation or a Recording
StepReport  what a step did: energies, losses, contacts, peaks
cut         opens edges of a mesh: topology alone
Mechanics   energy, gradient and Hessian of sheets at given positions, without time
Error       what cannot be done, in the words of the program

Everything is in SI units. Numbers of vertices, edges and faces are rows of the arrays, from 0, and stay what they are
while cracks add others behind them. Arrays of Snapshot are views that nobody can write to and that never change; all
other arrays are copies, the caller's own. While a step is computed other threads of Python run; a simulation belongs to
one thread at a time, and two of them may run in two threads. Ctrl-C ends a step first: the simulation can be used on.
The same scene gives the same bits as with the program.
"""
from ._cut import Cut, cut
from ._mechanics import Mechanics
from ._recording import Recording, record
from ._scene import Scene
from ._sherd import Error, Snapshot, StepReport, __version__
from ._simulation import Simulation

__all__ = ["Cut", "Error", "Mechanics", "Recording", "Scene", "Simulation", "Snapshot", "StepReport", "cut", "record"]
