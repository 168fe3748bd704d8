# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes with defects as in meshes of artists and scanners, most 0.2 m long: `write(folder)` makes a file of each."""
import math
import pathlib
import random


def sphere(radius, rings, centre=(0, 0, 0), squeeze=1.0):
    """Returns vertices and triangles of a sphere between two poles, `squeeze` times as high as wide."""
    vertices = [(0, 0, -radius * squeeze)]
    for i in range(1, rings):
        polar = math.pi * (i / rings - 0.5)
        for j in range(2 * rings):
            turn = math.pi * j / rings
            vertices.append((radius * math.cos(polar) * math.cos(turn), radius * math.cos(polar) * math.sin(turn),
                             radius * squeeze * math.sin(polar)))
    vertices.append((0, 0, radius * squeeze))
    count, top = 2 * rings, len(vertices) - 1
    faces = [(0, 1 + (j + 1) % count, 1 + j) for j in range(count)]
    for i in range(rings - 2):
        for j in range(count):
            a, b = 1 + i * count + j, 1 + i * count + (j + 1) % count
            faces += [(a, b, b + count), (a, b + count, a + count)]
    faces += [(top - count + j, top - count + (j + 1) % count, top) for j in range(count)]
    return [tuple(p + c for p, c in zip(v, centre)) for v in vertices], faces


def grid(columns, rows, place):
    """Returns vertices and quads of a grid whose vertex (i, j) is at place(i / columns, j / rows)."""
    vertices = [place(i / columns, j / rows) for j in range(rows + 1) for i in range(columns + 1)]
    corner = lambda i, j: j * (columns + 1) + i
    faces = [(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))
             for j in range(rows) for i in range(columns)]
    return vertices, faces


def box(size, centre=(0, 0, 0), parts=6):
    """Returns a closed box whose sides are grids with common vertices along the edges."""
    joined, vertices, faces = {}, [], []
    axes = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
    for a, b, c in axes:
        for end in (0, 1):
            def place(u, v):
                point = [0.0, 0.0, 0.0]
                point[a], point[b], point[c] = (u - 0.5) * size[a], (v - 0.5) * size[b], (end - 0.5) * size[c]
                return tuple(p + q for p, q in zip(point, centre))
            side, quads = grid(parts, parts, place)
            number = []
            for point in side:
                key = tuple(round(x, 9) for x in point)
                if key not in joined:
                    joined[key] = len(vertices)
                    vertices.append(point)
                number.append(joined[key])
            for quad in quads:
                turned = [number[i] for i in quad]
                faces.append(tuple(turned if end else reversed(turned)))
    return vertices, faces


def together(*meshes):
    vertices, faces = [], []
    for more, others in meshes:
        faces += [tuple(i + len(vertices) for i in face) for face in others]
        vertices += more
    return vertices, faces


def reversed_faces(mesh):
    return mesh[0], [tuple(reversed(face)) for face in mesh[1]]


def plate(width, height, columns, rows, at=(0, 0, 0)):
    return grid(columns, rows, lambda u, v: (at[0] + u * width, at[1] + v * height, at[2]))


def crossing_parts():
    return together(sphere(0.06, 16, (-0.04, 0, 0)), sphere(0.06, 16, (0.04, 0.011, 0.007)), box((0.2, 0.03, 0.02)))


def doubled_faces():
    vertices, faces = plate(0.2, 0.12, 20, 12)
    return vertices, faces + faces[::5]


def inside_out():
    return together(reversed_faces(sphere(0.05, 14, (-0.05, 0, 0))), sphere(0.05, 14, (0.05, 0, 0)))


def open_seams():
    return together(plate(0.1, 0.1, 10, 10), plate(0.1, 0.1, 10, 10, (0.1, 0, 0)))


def edge_of_three():
    fin = grid(20, 6, lambda u, v: (u * 0.2, 0.06, v * 0.05))
    vertices, faces = together(plate(0.2, 0.12, 20, 12), fin)
    known = {}
    number = [known.setdefault(tuple(round(x, 9) for x in v), i) for i, v in enumerate(vertices)]
    return vertices, [tuple(number[i] for i in face) for face in faces]


def point_of_two():
    vertices, faces = together(plate(0.1, 0.1, 10, 10), plate(0.1, 0.1, 10, 10, (0.1, 0.1, 0)))
    corner = vertices.index((0.1, 0.1, 0))
    other = len(vertices) // 2
    return vertices, [tuple(corner if i == other else i for i in face) for face in faces]


def hundred_parts():
    parts = [sphere(0.008, 5, (0.02 * (i % 10), 0.02 * (i // 10), 0)) for i in range(100)]
    return together(*parts)


def needles():
    """Returns a bowl of needles: faces with angles far below a degree."""
    def place(u, v):
        radius, turn = 0.1 * math.sin(1.2 * v), 0.9 * math.pi * u
        return radius * math.cos(turn), radius * math.sin(turn), 0.1 * (1 - math.cos(1.2 * v))
    return grid(300, 4, lambda u, v: place(u, 0.05 + 0.95 * v))


def thin_handle():
    """Returns a ball with a handle, a ring 2 mm thick."""
    vertices, faces = [], []
    around, along = 8, 60
    for i in range(along):
        turn = 2 * math.pi * i / along
        for j in range(around):
            angle = 2 * math.pi * j / around
            radius = 0.04 + 0.001 * math.cos(angle)
            vertices.append((0.1 + radius * math.cos(turn), radius * math.sin(turn), 0.001 * math.sin(angle)))
    for i in range(along):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            c, d = (i + 1) % along * around + j, (i + 1) % along * around + (j + 1) % around
            faces.append((a, c, d, b))
    return together(sphere(0.05, 16), (vertices, faces))


def sharp_box():
    return box((0.2, 0.1, 0.003), parts=12)


def noisy_scan(parts=129):
    """Returns a rounded lump of about 200,000 triangles with noise of a tenth of an edge length."""
    chance = random.Random(1)
    vertices, quads = box((2, 2, 2), parts=parts)
    edge = math.pi * 0.1 / (2 * parts)
    rough = []
    for x, y, z in vertices:
        x, y, z = (math.tan(math.pi / 4 * c) for c in (x, y, z))
        radius = math.sqrt(x * x + y * y + z * z)
        swell = 0.08 * (1 + 0.1 * math.sin(4 * x / radius) * math.cos(3 * y / radius) * math.sin(3.5 * z / radius))
        rough.append(tuple(swell * c / radius + chance.gauss(0, 0.1 * edge) for c in (x, y, z)))
    return rough, quads


def millimetres():
    vertices, faces = sphere(100, 20, squeeze=0.5)
    return vertices, faces


def polygons():
    """Returns quads and pentagons: a curved sheet of quads, of which every third has another vertex on one side."""
    vertices, quads = grid(24, 12, lambda u, v: (0.2 * u, 0.12 * v, 0.05 * math.sin(3 * u) * math.cos(2 * v)))
    vertices = list(vertices)
    middles, faces = {}, []
    for number, quad in enumerate(quads):
        if number % 3 == 0:
            middles[frozenset(quad[:2])] = len(vertices)
            vertices.append(tuple((p + q) / 2 for p, q in zip(vertices[quad[0]], vertices[quad[1]])))
    for quad in quads:
        face = []
        for i, corner in enumerate(quad):
            face.append(corner)
            middle = middles.get(frozenset((corner, quad[(i + 1) % 4])))
            if middle is not None:
                face.append(middle)
        faces.append(tuple(face))
    return vertices, faces


MESHES = [crossing_parts, doubled_faces, inside_out, open_seams, edge_of_three, point_of_two, hundred_parts, needles,
          thin_handle, sharp_box, noisy_scan, millimetres, polygons]


def write(folder, names=None):
    """Writes the meshes of these names, or all, as .obj files; returns the files by name."""
    files = {}
    for make in MESHES:
        if names and make.__name__ not in names:
            continue
        vertices, faces = make()
        file = pathlib.Path(folder) / f"{make.__name__}.obj"
        with open(file, "w", encoding="ascii") as out:
            out.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in vertices)
            out.writelines("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)
        files[make.__name__] = file
    return files
