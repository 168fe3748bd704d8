# SPDX-License-Identifier: GPL-3.0-or-later
"""Couples a body of the user's: a ball that is integrated here bounces on a rubber sheet that Sherd steps."""
import numpy

import sherd

RADIUS, MASS, STIFFNESS = 0.05, 0.1, 50.0  # m, kg, N/m for each vertex in contact
GRAVITY = numpy.array([0, 0, -9.81])

simulation = sherd.Simulation({
    "duration": 0.4,
    "sheet": {"trampoline": {
        "mesh": {"generate": "rectangle", "width": 0.4, "height": 0.4, "edge_length": 0.02},
        "material": {"density": 1100, "thickness": 3e-4, "young": 2e6, "poisson": 0.45},
        "pin": {"boundary": True},
    }},
    "force": {"gravity": [0, 0, 0]},
    "solver": {"step": 5e-4},
})
centre, velocity = numpy.array([0.2, 0.2, RADIUS + 0.1]), numpy.zeros(3)
touched, lowest, after = None, centre[2], 0.0
while not simulation.has_ended:
    # Vertices inside the ball are pushed outwards by a penalty force, and the ball by the opposite one.
    way = simulation.positions - centre
    distance = numpy.linalg.norm(way, axis=1)
    depth = numpy.maximum(RADIUS - distance, 0)
    forces = STIFFNESS * (depth / distance)[:, None] * way
    simulation.set_forces(forces)
    step = simulation.step().step_size
    velocity += step * (GRAVITY - forces.sum(0) / MASS)
    centre = centre + step * velocity
    if depth.any() and touched is None:
        touched = simulation.time
        print(f"{touched * 1e3:.0f} ms: the ball touches the sheet at {-velocity[2]:.2f} m/s")
    lowest = min(lowest, centre[2])
    if touched and not depth.any() and velocity[2] > after:
        after = velocity[2]
print(f"it sinks to {(lowest - RADIUS) * 1e3:.0f} mm and leaves upwards at {after:.2f} m/s")
