# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the natural modes of a cup from the Hessian of its energy and its lumped masses."""
import numpy
import scipy.sparse
import scipy.sparse.linalg

import sherd

cup = sherd.Mechanics({
    "duration": 1,
    "sheet": {"cup": {
        "mesh": {"generate": "revolution", "edge_length": 0.006,
                 "profile": [[0, 0], [0.02, 0], [0.03, 0.01], [0.036, 0.03], [0.04, 0.08]]},
        "material": {"preset": "porcelain"},
    }},
})
rest = cup.rest_positions
stiffness = cup.hessian(rest)
masses = scipy.sparse.diags(numpy.repeat(cup.masses, 3))

# Nothing supports the cup: the six slowest modes are rigid motions, which take no energy.
squares, shapes = scipy.sparse.linalg.eigsh(stiffness, k=12, M=masses, sigma=-1e5)
frequencies = numpy.sqrt(numpy.maximum(squares, 0)) / (2 * numpy.pi)
print(f"{len(rest)} vertices; rigid motions:", *(f"{f:.2f}" for f in frequencies[:6]), "Hz")

radius, angle = numpy.hypot(rest[:, 0], rest[:, 1]), numpy.arctan2(rest[:, 1], rest[:, 0])
rim = rest[:, 2] > rest[:, 2].max() - 1e-6
outward = numpy.stack([numpy.cos(angle), numpy.sin(angle)], axis=1)
for frequency, shape in zip(frequencies[6:], shapes.T[6:]):
    # The number of waves around the rim is the largest Fourier component of its radial displacement.
    way = (shape.reshape(-1, 3)[:, :2] * outward).sum(1)[rim]
    waves = [abs((way * numpy.exp(1j * n * angle[rim])).sum()) for n in range(8)]
    print(f"{frequency:8.1f} Hz: {numpy.argmax(waves)} waves around the rim")
