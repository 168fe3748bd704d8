# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a mesh along edges, without mechanics: a globe becomes gores like those of a beach ball, in gores.obj."""
import numpy

import sherd

AROUND, DOWN, GORES = 24, 12, 6

# A globe of triangles: rings of vertices between two poles.
angle, height = 2 * numpy.pi * numpy.arange(AROUND) / AROUND, numpy.pi * numpy.arange(1, DOWN) / DOWN
rings = numpy.stack([numpy.outer(numpy.sin(height), numpy.cos(angle)), numpy.outer(numpy.sin(height), numpy.sin(angle)),
                     numpy.outer(numpy.cos(height), numpy.ones(AROUND))], axis=-1).reshape(-1, 3)
positions = numpy.concatenate([rings, [[0, 0, 1], [0, 0, -1]]])
number = numpy.arange(len(rings)).reshape(DOWN - 1, AROUND)
beside = numpy.roll(number, -1, axis=1)
north, south = len(rings), len(rings) + 1
faces = numpy.concatenate([
    numpy.stack([number[1:], beside[1:], number[:-1]], axis=-1).reshape(-1, 3),
    numpy.stack([beside[1:], beside[:-1], number[:-1]], axis=-1).reshape(-1, 3),
    [[a, b, north] for a, b in zip(number[0], beside[0])],
    [[b, a, south] for a, b in zip(number[-1], beside[-1])],
])

# The edges to open: meridians from pole to pole.
edges = []
for seam in range(0, AROUND, AROUND // GORES):
    meridian = [north, *number[:, seam], south]
    edges += zip(meridian[:-1], meridian[1:])
cut = sherd.cut(positions, faces, edges)

print(f"{len(edges)} edges opened: {cut.fragments.max() + 1} pieces, {len(cut.positions)} vertices of {len(positions)}")
with open("gores.obj", "w") as file:
    for piece in range(cut.fragments.max() + 1):
        # Moves each piece a little away from the others.
        corners = cut.faces[cut.fragments == piece]
        used = numpy.unique(corners)
        cut.positions[used] += 0.2 * cut.positions[used].mean(0)
    file.writelines(f"v {x} {y} {z}\n" for x, y, z in cut.positions)
    for piece in range(cut.fragments.max() + 1):
        file.write(f"g gore_{piece}\n")
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in cut.faces[cut.fragments == piece] + 1)
