# SPDX-License-Identifier: GPL-3.0-or-later
"""A load that Python prescribes: a weight rolls along a steel strip that is clamped at both ends."""
import numpy

import sherd

LENGTH, WEIGHT, SPEED = 1.0, 5.0, 4.0  # m, N, m/s

simulation = sherd.Simulation({
    "duration": LENGTH / SPEED,
    "sheet": {"strip": {
        "mesh": {"generate": "rectangle", "width": LENGTH, "height": 0.1, "edge_length": 0.033},
        "material": {"preset": "steel", "thickness": 2e-3},
        "clamp": [{"box": [[-1, -1, -1], [0.001, 1, 1]]}, {"box": [[LENGTH - 0.001, -1, -1], [2, 1, 1]]}],
    }},
    "force": {"gravity": [0, 0, 0]},
    "solver": {"step": 1e-3},
})
rest = simulation.positions
middle = numpy.argmin(numpy.hypot(rest[:, 0] - LENGTH / 2, rest[:, 1] - 0.05))
deflection = []
while not simulation.has_ended:
    # The vertices near the weight share it by a Gaussian of their distance.
    at = SPEED * simulation.time
    share = numpy.exp(-((rest[:, 0] - at) / 0.03) ** 2)
    forces = numpy.zeros_like(rest)
    forces[:, 2] = -WEIGHT * share / share.sum()
    simulation.set_forces(forces)
    simulation.step()
    deflection.append(simulation.positions[middle, 2])

deflection = numpy.array(deflection)
static = WEIGHT * LENGTH**3 / (192 * 2.1e11 * 0.1 * 2e-3**3 / 12)
print(f"the middle goes down by {-deflection.min() * 1e3:.2f} mm at most,")
print(f"when the weight is at {(numpy.argmin(deflection) + 1) * 1e-3 * SPEED:.2f} m;")
print(f"if it rested in the middle it would be {static * 1e3:.2f} mm")
