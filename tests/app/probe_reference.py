# SPDX-License-Identifier: GPL-3.0-or-later
"""probe_reference.py SHERD MESHES

Evaluates the quantities of `sherd probe` by the paper's equations, with code of its own, and compares every number: on
a crumpled mesh that is made here (needle triangles, a hole, two components, vertices that no face uses) and on
MESHES/spot.obj if it exists. The energies accept complex positions, so that a complex step gives their gradients to
round-off. If this test fails, the program's energies or forces are not the paper's."""

import itertools
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

from coupled_reference import Arcs, CoupledHinges

TOLERANCE = 1e-10


# Meshes. Vertices [V, 3], faces [F, 3].


def read_obj(path):
    vertices, faces = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            vertices.append([float(x) for x in rest[:3]])
        elif word == "f":
            faces.append([int(corner.split("/")[0]) - 1 for corner in rest])
    return np.array(vertices), np.array(faces)


def write_obj(path, vertices, faces):
    lines = ["v " + " ".join(repr(float(x)) for x in v) for v in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def patch(random, columns, rows):
    """Returns a rolled, creased sheet of unequal triangles: widths of columns and rows span two decades."""
    u, v = (np.concatenate([[0], np.cumsum(10 ** random.uniform(-2, 0, n))]) for n in (columns, rows))
    u, v = np.meshgrid(u / u[-1], v / v[-1], indexing="ij")
    u = u + 0.2 * (v - v * v)
    radius = 0.4 + 0.3 * np.abs(np.sin(9 * u + v))
    points = np.stack([radius * np.cos(4 * u), radius * np.sin(4 * u), v + 0.1 * u * u], axis=-1)
    number = np.arange(u.size).reshape(u.shape)
    faces = []
    for i, j in itertools.product(range(columns), range(rows)):
        a, b, c, d = number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]
        faces += [[a, b, c], [a, c, d]] if random.uniform() < 0.5 else [[a, b, d], [b, c, d]]
    return points.reshape(-1, 3), np.array(faces)


def crumpled_mesh(random):
    first, second = patch(random, 14, 11), patch(random, 5, 4)
    vertices = np.concatenate([first[0], second[0] + [2, 0, 1], random.normal(size=(3, 3))])
    faces = np.concatenate([np.delete(first[1], [130, 131, 132, 133], axis=0), second[1] + len(first[0])])
    faces = np.array([np.roll(face, random.integers(3)) for face in random.permutation(faces)])
    order = random.permutation(len(vertices))
    renumbered = np.empty_like(vertices)
    renumbered[order] = vertices
    return renumbered, order[faces]


def deformed(random, vertices, faces):
    """Returns deformed positions: large smooth waves, random displacements that rotate hinges by radians, and a rigid
    motion."""
    size = np.ptp(vertices, axis=0).max()
    x = vertices.copy()
    for _ in range(6):
        wave, phase = random.normal(size=3) * 4 / size, random.uniform(0, 2 * math.pi)
        x = x + 0.08 * size * np.sin(vertices @ wave + phase)[:, None] * random.normal(size=3)
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    shortest = np.full(len(vertices), np.inf)
    for side in (0, 1):
        np.minimum.at(shortest, ends[:, side], np.linalg.norm(vertices[ends[:, 0]] - vertices[ends[:, 1]], axis=1))
    shortest[np.isinf(shortest)] = 1
    x = x + 0.4 * shortest[:, None] * random.normal(size=x.shape)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return x @ (turn * np.linalg.det(turn)).T + random.normal(size=3) * size


def hinges_of(faces):
    """Returns x0, x1, x2, x3 of every interior edge: triangle (x0, x1, x2) on its left, (x0, x3, x1) on its right."""
    apex = {}
    for a, b, c in faces:
        apex.update({(a, b): c, (b, c): a, (c, a): b})
    return np.array([[a, b, apex[a, b], apex[b, a]] for a, b in apex if a < b and (b, a) in apex])


# Vectors [..., 3], real or complex, without conjugates.


def dot(a, b):
    return np.sum(a * b, axis=-1)


def norm(a):
    return np.sqrt(dot(a, a))


def edges(x):
    """Returns the edges e0 .. e4 of hinges at positions [H, 4, 3]."""
    x0, x1, x2, x3 = np.moveaxis(x, 1, 0)
    return x1 - x0, x2 - x0, x3 - x0, x2 - x1, x3 - x1


def angle(x):
    e0, e1, e2, _, _ = edges(x)
    n0, n1 = np.cross(e0, e1), np.cross(e2, e0)
    cosine, sine = dot(n0, n1), -dot(np.cross(n0, n1), e0) / norm(e0)
    theta = np.arctan2(sine.real, cosine.real)
    if not np.iscomplexobj(x):
        return theta
    slope = cosine.real * sine.imag - sine.real * cosine.imag  # derivative of the arc tangent, for complex steps
    return theta + 1j * slope / (cosine.real**2 + sine.real**2)


def cotangent(a, b):
    return dot(a, b) / norm(np.cross(a, b))


def gradient(function, x):
    """Returns d function / dx, [N, 3 n] or [N, 3 n, m] for values [N] or [N, m] of positions [N, n, 3]."""
    columns, step = [], 1e-30
    for vertex, axis in itertools.product(range(x.shape[1]), range(3)):
        moved = x.astype(complex)
        moved[:, vertex, axis] += 1j * step
        columns.append(function(moved).imag / step)
    return np.stack(columns, axis=1)


class Hinges:
    """All hinges of a mesh at rest, with their stiffness."""

    def __init__(self, rest, stiffness):
        e0, e1, e2, e3, e4 = edges(rest)
        self.rest, self.stiffness = rest, stiffness
        self.length = norm(e0)
        self.area = (norm(np.cross(e0, e1)) + norm(np.cross(e0, e2))) / 2
        self.angle = angle(rest)
        self.c01, self.c03 = cotangent(e0, e1), cotangent(-e0, e3)
        self.c02, self.c04 = cotangent(e0, e2), cotangent(-e0, e4)
        self.correction = None

    def strain(self, x):
        change = angle(x) - self.angle
        return self.length / self.area * (change - 2 * math.pi * np.round(change / (2 * math.pi)))

    def nonlinear(self, x):
        """Returns the energies by eqs. 3 and 4, with exact angles."""
        return 3 * self.stiffness * self.length**2 / self.area * (1 - np.cos(angle(x) - self.angle))

    def cubic_2007(self, x):
        """Returns the energies by eq. 4, with cosine and sine of the angle by eqs. 5 and 6, from rest cotangents."""
        e0, e1, e2, e3, e4 = edges(x)
        t0 = -(self.c03[:, None] * e1 + self.c01[:, None] * e3)
        t1 = -(self.c04[:, None] * e2 + self.c02[:, None] * e4)
        cosine = 1 - dot(t0 + t1, t0 + t1) / (2 * self.length**2)
        sine = (self.c01 + self.c03) * (self.c02 + self.c04) * dot(np.cross(e0, e1), e2) / self.length**3
        bent = 1 - np.cos(self.angle) * cosine - np.sin(self.angle) * sine
        return 3 * self.stiffness * self.length**2 / self.area * bent

    def cubic(self, x):
        """Returns cubic_2007() less the multiples of squared edge lengths that make its gradient vanish at rest."""
        if self.correction is None:
            slopes, lengths = gradient(self.cubic_2007, self.rest), gradient(squared_lengths, self.rest)
            q, r = np.linalg.qr(lengths)
            self.correction = np.linalg.solve(r, np.swapaxes(q, 1, 2) @ slopes[..., None])[..., 0]
        change = squared_lengths(x) - squared_lengths(self.rest)
        return self.cubic_2007(x) - np.sum(self.correction * change, axis=1)


def squared_lengths(x):
    return np.stack([dot(e, e) for e in edges(x)], axis=1)


class Constants:
    """Elastic constants from the keys of a material file: Y0, Y1, Y01, G01 (section 4)."""

    def __init__(self, material):
        young, nu = material["young"], material["poisson"]
        self.thickness = material["thickness"]
        self.young0, self.young1 = young if isinstance(young, list) else (young, young)
        self.young01 = nu * self.young1
        self.shear = material.get("shear", self.young0 / (2 * (1 + nu)))
        self.share = 1 if material.get("calibration") == "paper" else 1 / 3
        self.free = 1 - self.young01**2 / (self.young0 * self.young1)

    def hinge_stiffness(self, angle):
        """Returns the stiffness by section 5.1, calibrated. angle: rad, between the edge and the first axis."""
        h = self.thickness**3 / 12
        bend = self.young0 * np.sin(angle) ** 4 + self.young1 * np.cos(angle) ** 4
        twist = self.young01 / (2 * self.free) + self.shear
        return self.share * h * (bend / self.free + twist * np.sin(2 * angle) ** 2)

    def membrane(self, strain):
        """Returns the energy per area in plane stress, [F], of strains [F, 2, 2] in the material axes."""
        e00, e11, e01 = strain[:, 0, 0], strain[:, 1, 1], strain[:, 0, 1]
        stretch = self.young0 * e00**2 + self.young1 * e11**2 + 2 * self.young01 * e00 * e11
        return self.thickness * (stretch / (2 * self.free) + 2 * self.shear * e01**2)


def unit_normal(rest):
    normal = np.cross(rest[:, 1] - rest[:, 0], rest[:, 2] - rest[:, 0])
    return normal / norm(normal)[:, None]


def material_axes(rest, axis):
    """Returns the first axis in each triangle [F, 3, 3] at rest: `degrees` from the projected x axis, or a projected
    direction."""
    normal = unit_normal(rest)
    direction = np.array(axis.get("direction", [1.0, 0.0, 0.0]))
    along = direction - dot(normal, direction)[:, None] * normal
    along = along / norm(along)[:, None]
    turn = math.radians(axis.get("degrees", 0))
    return math.cos(turn) * along + math.sin(turn) * np.cross(normal, along)


def hinge_axis_angles(vertices, faces, stencils, axes):
    """Returns the angles between edges and axes: half the mean direction of the doubled angles in both triangles."""
    face_of = {}
    for face, (a, b, c) in enumerate(faces.tolist()):
        face_of.update({(a, b): face, (b, c): face, (c, a): face})
    normals, mean = unit_normal(vertices[faces]), 0
    edge = vertices[stencils[:, 1]] - vertices[stencils[:, 0]]
    for ends in (stencils[:, [0, 1]], stencils[:, [1, 0]]):
        face = [face_of[tuple(side)] for side in ends.tolist()]
        angle_to = np.arctan2(dot(axes[face], np.cross(normals[face], edge)), dot(axes[face], edge))
        mean = mean + np.exp(2j * angle_to)
    return np.angle(mean) / 2


def green_strain(rest, x, axes):
    """Returns the Green strain [F, 2, 2] in an orthonormal frame of each rest triangle, whose first axis is `axes`."""
    sides = np.stack([rest[:, 1] - rest[:, 0], rest[:, 2] - rest[:, 0]], axis=1)
    other = np.cross(unit_normal(rest), axes)
    shape = np.stack([dot(sides, axes[:, None]), dot(sides, other[:, None])], axis=1)
    now = np.stack([x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]], axis=-1)
    f = now @ np.linalg.inv(shape)
    return (np.swapaxes(f, 1, 2) @ f - np.eye(2)) / 2


# The comparison.


def agree(what, found, expected, scale):
    """Requires that entries differ by at most TOLERANCE of `scale`, a number or an array with one for each entry."""
    found, expected = np.asarray(found), np.asarray(expected)
    assert found.shape == expected.shape, f"{what}: shape {found.shape}, not {expected.shape}"
    error = float(np.max(np.abs(found - expected) / scale, initial=0))
    print(f"    {what:<28}{error:9.1e}")
    assert error <= TOLERANCE, f"{what}: off by {error:.2g} of its scale"


def check_energy(name, energy, stencils, x, probed, forces):
    local = x[stencils]
    amounts = energy(local)
    agree(f"energy.{name}", probed["energy"][name], math.fsum(amounts), abs(math.fsum(amounts)))
    slopes = gradient(energy, local).reshape(len(stencils), -1, 3)
    force = np.zeros_like(x)
    np.subtract.at(force, stencils, slopes)
    # The scale of a force is the sum of the forces that cancel in it; for vertices without forces, the smallest number.
    size = np.full((len(x), 1), np.finfo(float).tiny)
    np.add.at(size, stencils, norm(slopes)[..., None])
    agree(f"force/{name}", forces[:], force, size)
    agree(f"force_norm.{name}", probed["force_norm"][name], np.linalg.norm(force), np.linalg.norm(force))


def check_coupled(coupled, x, probed, forces):
    energies, moments, sizes = coupled.energy_and_moments(x)
    agree("energy.bending_coupled", probed["energy"]["bending_coupled"], math.fsum(energies), math.fsum(energies))
    slopes = gradient(angle, x[coupled.stencils]).reshape(len(moments), -1, 3)
    force, size = np.zeros_like(x), np.full((len(x), 1), np.finfo(float).tiny)
    np.subtract.at(force, coupled.stencils, moments[:, None, None] * slopes)
    np.add.at(size, coupled.stencils, sizes[:, None, None] * norm(slopes)[..., None])
    agree("force/bending_coupled", forces[:], force, size)


def check_arcs(arcs, x, probed, forces):
    y = arcs.unknowns(x)
    energy, slopes = math.fsum(arcs.energy(y)), gradient(arcs.energy, y).reshape(-1, 4, 3)
    agree("energy.membrane_arc", probed["energy"]["membrane_arc"], energy, energy)
    moments, sizes = arcs.moments(slopes[:, 3])
    turns = gradient(angle, x[arcs.stencils]).reshape(len(moments), -1, 3)
    force, size = np.zeros_like(x), np.full((len(x), 1), np.finfo(float).tiny)
    np.subtract.at(force, arcs.corners, slopes[:, :3])
    np.add.at(size, arcs.corners, norm(slopes[:, :3])[..., None])
    np.subtract.at(force, arcs.stencils, moments[:, None, None] * turns)
    np.add.at(size, arcs.stencils, sizes[:, None, None] * norm(turns)[..., None])
    agree("force/membrane_arc", forces[:], force, size)


def matched(vertices, stencils):
    """Returns the row of `stencils` for each of `vertices`, which may list a hinge from either end of its edge."""
    row = {tuple(stencil): i for i, stencil in enumerate(stencils.tolist())}
    row.update({(b, a, d, c): i for (a, b, c, d), i in list(row.items())})
    found = [row[tuple(hinge)] for hinge in vertices.tolist()]
    assert sorted(found) == list(range(len(stencils))), "not every hinge is there once"
    return found


def check_hinges(hinges, stencils, x, probed, file):
    order = matched(file["hinge/vertices"][:], stencils)
    angles, strains = hinges.angle[order], hinges.strain(x[stencils])[order]
    agree("hinge/rest_angle", file["hinge/rest_angle"][:], angles, 1)
    agree("hinge/angle", file["hinge/angle"][:], angle(x[stencils])[order], 1)
    agree("hinge/strain", file["hinge/strain"][:], strains, (hinges.length / hinges.area)[order])
    agree("hinge/stiffness", file["hinge/stiffness"][:], hinges.stiffness[order], hinges.stiffness[order])
    most = probed["largest_strain"]["bending"]
    assert most["hinge"] == np.argmax(np.abs(strains)), "the largest bending strain is elsewhere"
    assert most["vertices"] == file["hinge/vertices"][most["hinge"]].tolist()
    agree("largest_strain.bending", most["strain"], strains[most["hinge"]], abs(most["strain"]))


def check_face(strain, faces, probed):
    values, most = np.linalg.eigvalsh(strain), probed["largest_strain"]["membrane"]
    strains = values[np.arange(len(values)), np.argmax(np.abs(values), axis=1)]
    assert most["face"] == np.argmax(np.abs(strains)), "the largest membrane strain is elsewhere"
    assert sorted(most["vertices"]) == sorted(faces[most["face"]].tolist())
    agree("largest_strain.membrane", most["strain"], strains[most["face"]], abs(most["strain"]))


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    return json.dumps(value)


def run_probe(sherd, folder, rest, x, faces, material):
    write_obj(folder / "rest.obj", rest, faces)
    write_obj(folder / "deformed.obj", x, faces)
    lines = [f"{key} = {toml(value)}" for key, value in material.items()]
    (folder / "material.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
    command = [sherd, "probe", "rest.obj", "deformed.obj", "--material", "material.toml"]
    command += ["--json", "-o", "probe.h5"]
    return json.loads(subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE).stdout)


def check(sherd, rest, x, faces, material):
    stencils, constants = hinges_of(faces.tolist()), Constants(material)
    axes = material_axes(rest[faces], material.get("axis", {}))
    stiffness = constants.hinge_stiffness(hinge_axis_angles(rest, faces, stencils, axes))
    hinges = Hinges(rest[stencils], np.full(len(stencils), material.get("bending_stiffness", stiffness)))
    areas = norm(np.cross(rest[faces[:, 1]] - rest[faces[:, 0]], rest[faces[:, 2]] - rest[faces[:, 0]])) / 2
    print(f"  {len(rest)} vertices, {len(faces)} faces, {len(stencils)} hinges, angles up to "
          f"{np.abs(angle(x[stencils])).max():.3f} rad, at rest {np.abs(hinges.angle).max():.3f} rad")
    energies = {"bending_nonlinear": (hinges.nonlinear, stencils), "bending_cubic": (hinges.cubic, stencils),
                "bending_cubic_2007": (hinges.cubic_2007, stencils),
                "membrane": (lambda y: areas * constants.membrane(green_strain(rest[faces], y, axes)), faces)}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        probed = run_probe(sherd, folder, rest, x, faces, material)
        with h5py.File(folder / "probe.h5", "r") as file:
            assert (probed["vertices"], probed["faces"], probed["hinges"]) == (len(rest), len(faces), len(stencils))
            # Coupled hinges need the plate's material, which a given stiffness of hinges does not tell.
            coupled = "bending_stiffness" not in material
            others = {"membrane_arc"} | ({"bending_coupled"} if coupled else set())
            assert set(file["force"]) == set(probed["energy"]) == set(energies) | others
            check_arcs(Arcs(rest, faces, stencils, axes, constants, angle), x, probed, file["force/membrane_arc"])
            if coupled:
                coupled = CoupledHinges(rest, faces, stencils, axes, constants, angle)
                check_coupled(coupled, x, probed, file["force/bending_coupled"])
            for key, (energy, elements) in energies.items():
                check_energy(key, energy, elements, x, probed, file["force"][key])
            check_hinges(hinges, stencils, x, probed, file)
            check_face(green_strain(rest[faces], x[faces], axes), faces, probed)


def main():
    sherd, meshes = sys.argv[1], pathlib.Path(sys.argv[2])
    random = np.random.default_rng(20070803)
    steel = {"density": 7850.0, "thickness": 0.001, "young": 2.1e11, "poisson": 0.3}
    print("crumpled mesh")
    vertices, faces = crumpled_mesh(random)
    check(sherd, vertices, deformed(random, vertices, faces), faces, steel)
    print("two material axes")
    wood = {"density": 500.0, "thickness": 0.004, "young": [1.1e10, 7e8], "poisson": 0.4, "shear": 9e8}
    check(sherd, vertices, deformed(random, vertices, faces), faces, {**wood, "axis": {"degrees": 35.0}})
    wood.update({"axis": {"direction": [1.0, -2.0, 0.5]}, "calibration": "paper"})
    check(sherd, vertices, deformed(random, vertices, faces), faces, wood)
    print("a shape with sharper folds at rest than deformed")
    check(sherd, deformed(random, vertices, faces), vertices, faces, {**steel, "bending_stiffness": 0.37})
    if not (meshes / "spot.obj").is_file():
        print(f"SKIPPED: {meshes / 'spot.obj'} is not there; a real mesh was not compared", file=sys.stderr)
        return
    print("spot.obj")
    vertices, faces = read_obj(meshes / "spot.obj")
    check(sherd, vertices, deformed(random, vertices, faces), faces, steel)


main()
