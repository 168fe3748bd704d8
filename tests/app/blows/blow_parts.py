# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of random impacts, for blow_scenes.py: materials, struck sheets, strikers and their motions, as text of a
scene."""
import dataclasses
import math
import random

import numpy

from blow_solids import as_obj, as_stl, ball, closed_box, octahedron, prism, turned

PRESETS = {"stoneware": 5400, "porcelain": 5400, "glass": 5300, "pmma": 1640, "eggshell": 3600, "steel": 5200,
           "aluminium": 5100, "paper": 1960, "cotton": 63}  # speed of sound, m/s
SUBSTEPS = 4000  # largest number of substeps of a run with explicit steps, about
FASTEST = 0.25  # largest speed over the speed of sound in the sheet, unless that needs too many explicit steps
LARGEST_TURN = 1.5  # rad a step; beyond half a turn the direction of rotation is ambiguous
SMALLEST_VOXEL = 2e-5  # m


class Chance(random.Random):
    def between(self, least, most):
        """Returns a random number, uniform in its logarithm."""
        return math.exp(self.uniform(math.log(least), math.log(most)))

    def direction(self):
        while True:
            way = numpy.array([self.gauss(0, 1) for _ in range(3)])
            if numpy.linalg.norm(way) > 1e-3:
                return way / numpy.linalg.norm(way)


def vector(values):
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"


def placed(axis, degrees, translate):
    return (f"place = {{ rotate = {{ axis = {vector(axis)}, degrees = {degrees:.9g} }}, "
            f"translate = {vector(translate)} }}")


@dataclasses.dataclass
class Material:
    words: str
    thickness: float
    sound: float  # m/s


def material(chance, size, thinnest=2e-4, thickest=0.05):
    """Returns a random material. thinnest, thickest: bounds of its thickness over the size."""
    thickness = size * chance.between(thinnest, thickest)
    if chance.random() < 0.6:
        name = chance.choice(list(PRESETS))
        return Material(f'{{ preset = "{name}", thickness = {thickness:.6g} }}', thickness, PRESETS[name])
    density, young = chance.between(50, 8000), chance.between(1e5, 2e11)
    return Material(f"{{ density = {density:.4g}, thickness = {thickness:.6g}, young = {young:.4g}, "
                    f"poisson = {chance.uniform(0, 0.45):.3g} }}", thickness, math.sqrt(young / density))


@dataclasses.dataclass
class Pace:
    """Size, duration and speed of an impact; material of the struck sheet. sizes: speed in sheet sizes a step."""
    size: float
    sizes: float
    steps: int
    scheme: str
    stuff: Material
    step: float  # s

    @property
    def speed(self):
        return self.sizes * self.size / self.step

    @property
    def path(self):
        return self.sizes * self.size * self.steps


def pace(chance, scheme, how, thickest=0.05):
    """Returns a random pace for a target of the kind `how`; a "large" target is at least ten times larger than the
    striker's path."""
    size, sizes, steps = chance.between(0.005, 0.5), chance.between(0.01, 10), chance.randint(6, 20)
    if how == "large":
        steps = chance.randint(3, 6)
        sizes = min(chance.between(0.005, 0.03), 0.08 / steps)
    implicit = scheme not in ("explicit", "auto")
    stuff = material(chance, size, 2e-4 if implicit else 3e-3, thickest)
    speed = min(chance.between(3, 100), FASTEST * stuff.sound)
    if not implicit:
        lasts = SUBSTEPS * 0.3 * min(size / 7, 5 * stuff.thickness) / stuff.sound
        steps = max(3, min(steps, int(FASTEST * stuff.sound * lasts / (sizes * size))))
        speed = max(speed, sizes * size * steps / lasts)
    return Pace(size, sizes, steps, scheme, stuff, sizes * size / speed)


# Sheets


@dataclasses.dataclass
class Target:
    """A sheet that is struck at `point`, against the outward direction `normal`. border: as in Blow."""
    words: str
    point: numpy.ndarray
    normal: numpy.ndarray
    thickness: float
    border: str | None = None


def flat(chance, size, faces):
    """Returns the scene text of a flat mesh with about this number of faces, and the middle of the mesh."""
    edge = size * math.sqrt(2.3 / faces)
    if chance.random() < 0.6:
        height = size * chance.uniform(0.5, 1)
        edge = math.sqrt(2.3 * size * height / faces)
        structured = ", structured = true" if chance.random() < 0.3 else ""
        return (f'{{ generate = "rectangle", width = {size:.6g}, height = {height:.6g}, edge_length = {edge:.6g}'
                f"{structured} }}"), numpy.array([size / 2, height / 2, 0])
    edge = min(edge * 0.9, size * 0.4)
    return f'{{ generate = "disc", radius = {size / 2:.6g}, edge_length = {edge:.6g} }}', numpy.zeros(3)


def turn(chance, much, size):
    """Returns a random rotation (rad a step) of something of this size, whose surface is about as fast as the impact at
    most."""
    return min(chance.between(0.02, 1) * 2 * much.speed * much.step / size, LARGEST_TURN)


def spin(chance, much, size):
    return f"spin = {vector(chance.direction() * turn(chance, much, size) / much.step)}"


def sheet_words(name, mesh, stuff, more):
    return f"[sheet.{name}]\nmesh = {mesh}\nmaterial = {stuff.words}\n" + "".join(f"{line}\n" for line in more)


def pane(chance, much, how):
    """Returns a flat target: pinned all around, free, large or spinning."""
    size = much.size
    mesh, middle = flat(chance, size, chance.randint(30, 160))
    axis, degrees = chance.direction(), chance.uniform(0, 180) if chance.random() < 0.5 else 0
    matrix = turned(axis, degrees)
    more = [placed(axis, degrees, -matrix @ middle)]
    if how == "pinned":
        more.append("pin = { boundary = true }")
    if how == "spinning":
        more.append(spin(chance, much, size))
    inside = 0.15 if how in ("pinned", "large") else 0.3
    offset = matrix @ numpy.array([chance.uniform(-inside, inside), chance.uniform(-inside, inside), 0]) * size
    return Target(sheet_words("struck", mesh, much.stuff, more), offset, matrix[:, 2] * chance.choice([-1, 1]),
                  much.stuff.thickness, how if how in ("pinned", "large") else None)


def round_about(chance):
    angle = chance.uniform(0, 2 * math.pi)
    return numpy.array([math.cos(angle), math.sin(angle), 0])


def shell(chance, much, how):
    """Returns a curved target: a closed sphere or vessel, an open tube or a bowl."""
    size, radius, edge = much.size, much.size / 2, much.size * chance.uniform(0.14, 0.22)
    if how == "bowl":
        mesh = f'{{ generate = "bowl", radius = {radius:.6g}, edge_length = {edge:.6g} }}'
        point, normal = numpy.zeros(3), numpy.array([0, 0, -1.])
    elif how == "tube":
        mesh = f'{{ generate = "cylinder", radius = {radius / 2:.6g}, height = {size:.6g}, edge_length = {edge:.6g} }}'
        normal = round_about(chance)
        point = normal * radius / 2 + [0, 0, radius]
    elif chance.random() < 0.6:
        mesh = f'{{ generate = "sphere", radius = {radius:.6g}, edge_length = {edge * 1.6:.6g} }}'
        normal = chance.direction()
        point = normal * radius
    else:
        mesh = (f'{{ generate = "revolution", edge_length = {edge * 1.4:.6g}, profile = [[0, 0], '
                f"[{size * 0.4:.6g}, {size * 0.05:.6g}], [{size * 0.4:.6g}, {size * 0.85:.6g}], "
                f"[0, {size * 0.9:.6g}]] }}")
        normal = round_about(chance)
        point = normal * size * 0.4 + [0, 0, size * 0.45]
    more = [spin(chance, much, size)] if chance.random() < 0.3 else []
    return Target(sheet_words("struck", mesh, much.stuff, more), point, normal, much.stuff.thickness,
                  "closed" if how == "closed" else None)


def target(chance, much, how):
    return (pane if how in ("pinned", "free", "large", "spinning") else shell)(chance, much, how)


# Strikers


@dataclasses.dataclass
class Shape:
    """Scene text of a striker, its solid about the origin, and its files."""
    words: str
    solid: tuple
    files: dict
    free: bool  # whether the striker may be a free body


def shape_of_mesh(chance, solid, voxel):
    name, write = chance.choice([("striker.obj", as_obj), ("striker.stl", as_stl)])
    return Shape(f'mesh = {{ file = "{name}", voxel = {max(voxel, SMALLEST_VOXEL):.6g} }}', solid,
                 {name: write(*solid)}, True)


def striker_shape(chance, size, kind):
    """Returns a random striker of this kind that is about as large as `size`."""
    if kind == "sphere":
        return Shape(f"sphere = {{ radius = {size / 2:.6g} }}", ball(size / 2), {}, True)
    if kind in ("box", "rod", "wire"):
        thin = chance.uniform(*{"box": (0.3, 1), "rod": (0.05, 0.2), "wire": (0.02, 0.05)}[kind])
        side = numpy.array([size, size * thin, size * thin * chance.uniform(0.5, 1)])
        chance.shuffle(side)
        if kind == "wire" and chance.random() < 0.5 and size * thin > 8 * SMALLEST_VOXEL:
            return shape_of_mesh(chance, prism(size * thin / 2, size, 5), size * thin / 6)
        return Shape(f"box = {{ size = {vector(side)} }}", closed_box(side), {}, True)
    if kind == "cylinder":
        radius, length = size * chance.uniform(0.1, 0.5), size * chance.uniform(0.3, 1)
        words = f"cylinder = {{ radius = {radius:.6g}, length = {length:.6g} }}"
        return Shape(words, prism(radius, length, 16), {}, False)
    solid = chance.choice([octahedron(size / 2), prism(size * chance.uniform(0.15, 0.4), size, chance.randint(3, 8)),
                           closed_box(numpy.array([size, size * 0.6, size * 0.3]))])
    return shape_of_mesh(chance, solid, size / 30)


@dataclasses.dataclass
class Keys:
    """Motion of an obstacle between two times: a translation, and a rotation about its centre."""
    begin: float
    end: float
    translate: numpy.ndarray
    axis: numpy.ndarray
    degrees: float
    centre: numpy.ndarray
    smooth: bool

    def pose(self, time):
        """Returns rotation and translation at a time, relative to the initial place."""
        share = min(max((time - self.begin) / (self.end - self.begin), 0), 1)
        share = share * share * (3 - 2 * share) if self.smooth else share
        matrix = turned(self.axis, self.degrees * share)
        return matrix, self.translate * share + self.centre - matrix @ self.centre

    def words(self):
        rest = "{ time = 0 }, " if self.begin > 0 else ""
        return (f'motion = "{"smooth" if self.smooth else "linear"}"\nkeys = [{rest}{{ time = {self.begin:.9g} }}, '
                f"{{ time = {self.end:.9g}, translate = {vector(self.translate)}, "
                f"rotate = {{ axis = {vector(self.axis)}, degrees = {self.degrees:.9g} }} }}]")
