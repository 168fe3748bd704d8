# SPDX-License-Identifier: GPL-3.0-or-later
"""Drops a plate, records it in plate.h5, and prints the areas of its largest fragments."""
import numpy

import sherd

scene = sherd.Scene({
    "duration": 0.01,
    "sheet": {"plate": {
        "mesh": {"generate": "plate", "radius": 0.13, "edge_length": 0.01},
        "place": {"rotate": {"axis": [0, 1, 0], "degrees": 65}, "translate": [0, 0, 0.125]},
        "velocity": [0, 0, -4],
        "material": {"preset": "stoneware"},
        "fracture": {"strain": 0.4},
    }},
    "obstacle": {"floor": {"plane": {}, "young": 1e10, "friction": 0.4}},
    "output": {"every": 1e-3},
})
simulation = sherd.Simulation(scene)


def tell(report):
    if report.step % 20 == 0:
        print(f"{report.time:.3f} s: {report.fragments} fragments, {report.kinetic:.2f} J kinetic")


with sherd.record(simulation, "plate.h5", force=True):
    simulation.run(observe=tell)

recording = sherd.Recording("plate.h5")
last = recording.frame(-1)
areas = numpy.bincount(last.face_fragments, last.rest_areas)
largest = sorted(areas * 1e4)[:-6:-1]
print(f"{len(recording)} frames; the largest pieces have", *(f"{area:.1f}" for area in largest), "cm^2")
print(f"{recording.steps['lost_to_cracks'][-1]:.3g} J went into cracks")
