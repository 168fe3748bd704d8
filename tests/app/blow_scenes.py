# SPDX-License-Identifier: GPL-3.0-or-later
"""Random blows: scenes in which something strikes a sheet, each made of its seed alone. A scene has at most 300 faces
and 20 steps. `Blow` says what the judge has to know of it and cannot read in the recording."""
import dataclasses
import math
import random

import numpy

from blow_solids import as_obj, as_stl, ball, closed_box, octahedron, prism, turned

SCHEMES = ["implicit-euler"] * 4 + ["bdf2"] * 2 + ["explicit"] * 2 + ["auto"] * 2
PRESETS = ["stoneware", "porcelain", "glass", "pmma", "eggshell", "steel", "aluminium", "paper", "cotton"]
EXPLICIT_LOOK = 2e-6  # s, the step of explicit steps unless a scene says so
LARGEST_TURN = 1.5  # rad a step, of what spins freely: beyond half a turn nobody can tell which way it went


@dataclasses.dataclass
class Blow:
    """A scene, and what is known of it. struck: the sheet that must not be passed, or None where no side is known;
    border: what closes it: "pinned" by its own rim, which rests, "closed", or "large" against the way."""
    seed: int
    kind: str
    scheme: str
    pace: float  # sheet sizes a step
    step: float  # s
    text: str
    files: dict
    struck: str | None = None
    border: str | None = None
    solids: dict = dataclasses.field(default_factory=dict)  # of obstacles, by name: vertices as placed, triangles
    turns: dict = dataclasses.field(default_factory=dict)  # of obstacles with keys: what `Keys` has


# The scene


class Chance(random.Random):
    def between(self, least, most):
        """A number, evenly in its logarithm."""
        return math.exp(self.uniform(math.log(least), math.log(most)))

    def direction(self):
        while True:
            way = numpy.array([self.gauss(0, 1) for _ in range(3)])
            if numpy.linalg.norm(way) > 1e-3:
                return way / numpy.linalg.norm(way)


def vector(values):
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"


def material(chance, size, thinnest=2e-4):
    """Words of a material, and its thickness."""
    thickness = size * chance.between(thinnest, 0.05)
    if chance.random() < 0.6:
        return f'{{ preset = "{chance.choice(PRESETS)}", thickness = {thickness:.6g} }}', thickness
    return (f"{{ density = {chance.between(50, 8000):.4g}, thickness = {thickness:.6g}, "
            f"young = {chance.between(1e5, 2e11):.4g}, poisson = {chance.uniform(0, 0.45):.3g} }}"), thickness


@dataclasses.dataclass
class Target:
    """A sheet that is struck at a point of it, from there outward along `normal`."""
    words: str
    point: numpy.ndarray
    normal: numpy.ndarray
    border: str | None
    thickness: float


def flat(chance, size, faces):
    """Words of a flat mesh with about so many faces, and its middle."""
    edge = size * math.sqrt(2.3 / faces)
    if chance.random() < 0.6:
        height = size * chance.uniform(0.5, 1)
        edge = math.sqrt(2.3 * size * height / faces)
        structured = ", structured = true" if chance.random() < 0.3 else ""
        return (f'{{ generate = "rectangle", width = {size:.6g}, height = {height:.6g}, edge_length = {edge:.6g}'
                f"{structured} }}"), numpy.array([size / 2, height / 2, 0])
    return (f'{{ generate = "disc", radius = {size / 2:.6g}, edge_length = {edge * 0.9:.6g} }}'), numpy.zeros(3)


def spin(chance, step, largest):
    return chance.direction() * min(chance.between(0.01, 1) * largest, LARGEST_TURN) / step


def sheet_words(name, mesh, stuff, more):
    return f"[sheet.{name}]\nmesh = {mesh}\nmaterial = {stuff}\n" + "".join(f"{line}\n" for line in more)


def pane(chance, size, step, how):
    """A flat sheet: pinned all around, free, large or spinning."""
    mesh, middle = flat(chance, size, chance.randint(30, 220))
    stuff, thickness = material(chance, size)
    axis, degrees = chance.direction(), chance.uniform(0, 180) if chance.random() < 0.5 else 0
    matrix = turned(axis, degrees)
    more = [f"place = {{ rotate = {{ axis = {vector(axis)}, degrees = {degrees:.9g} }}, "
            f"translate = {vector(-matrix @ middle)} }}"]
    if how == "pinned":
        more.append("pin = { boundary = true }")
    if how == "spinning":
        more.append(f"spin = {vector(spin(chance, step, 1))}")
    inside = 0.25 if how in ("pinned", "large") else 0.45
    offset = matrix @ numpy.array([chance.uniform(-inside, inside) * size * 0.7, chance.uniform(-inside, inside) * size * 0.5, 0])
    border = {"pinned": "pinned", "large": "large"}.get(how)
    return Target(sheet_words("struck", mesh, stuff, more), offset, matrix[:, 2] * chance.choice([-1, 1]), border, thickness)


def shell(chance, size, step, how):
    """A closed sphere or vessel, an open tube or a bowl."""
    stuff, thickness = material(chance, size, 1e-3)
    spinning = [f"spin = {vector(spin(chance, step, 0.5))}"] if chance.random() < 0.3 else []
    radius = size / 2
    if how == "closed":
        if chance.random() < 0.6:
            mesh = f'{{ generate = "sphere", radius = {radius:.6g}, edge_length = {size * chance.uniform(0.2, 0.35):.6g} }}'
            return Target(sheet_words("struck", mesh, stuff, spinning), *on_ball(chance, radius), "closed", thickness)
        mesh = (f'{{ generate = "revolution", edge_length = {size * chance.uniform(0.22, 0.3):.6g}, profile = '
                f"[[0, 0], [{radius * 0.8:.6g}, {radius * 0.1:.6g}], [{radius * 0.8:.6g}, {radius * 1.7:.6g}], [0, {size * 0.9:.6g}]] }}")
        around = chance.uniform(0, 2 * math.pi)
        normal = numpy.array([math.cos(around), math.sin(around), 0])
        return Target(sheet_words("struck", mesh, stuff, spinning), normal * radius * 0.8 + [0, 0, radius * 0.9], normal,
                      "closed", thickness)
    if how == "tube":
        mesh = (f'{{ generate = "cylinder", radius = {radius * 0.5:.6g}, height = {size:.6g}, '
                f"edge_length = {size * chance.uniform(0.14, 0.25):.6g} }}")
        around = chance.uniform(0, 2 * math.pi)
        normal = numpy.array([math.cos(around), math.sin(around), 0])
        return Target(sheet_words("struck", mesh, stuff, spinning), normal * radius * 0.5 + [0, 0, radius], normal, None,
                      thickness)
    mesh = f'{{ generate = "bowl", radius = {radius:.6g}, edge_length = {size * chance.uniform(0.12, 0.2):.6g} }}'
    return Target(sheet_words("struck", mesh, stuff, spinning), numpy.zeros(3), numpy.array([0, 0, -1.]), None, thickness)


def on_ball(chance, radius):
    way = chance.direction()
    return way * radius, way


@dataclasses.dataclass
class Shape:
    """A striker's words, its solid around the origin and the radius of a ball around it."""
    words: str
    solid: tuple
    radius: float
    files: dict
    free: bool  # it may be a free body


def striker_shape(chance, size, kind):
    """Of a striker about as large as `size`."""
    if kind == "sphere":
        radius = size / 2
        return Shape(f"sphere = {{ radius = {radius:.6g} }}", ball(radius), radius, {}, True)
    if kind in ("box", "rod", "wire"):
        thin = {"box": chance.uniform(0.3, 1), "rod": chance.uniform(0.05, 0.2), "wire": chance.uniform(0.01, 0.04)}[kind]
        side = numpy.array([size, size * thin, size * thin * chance.uniform(0.5, 1)])
        chance.shuffle(side)
        if kind == "wire" and chance.random() < 0.5:
            return mesh_shape(chance, prism(size * thin / 2, size, 5), size * thin / 3)
        return Shape(f"box = {{ size = {vector(side)} }}", closed_box(side), numpy.linalg.norm(side) / 2, {}, True)
    if kind == "cylinder":
        radius, length = size * chance.uniform(0.1, 0.5), size * chance.uniform(0.3, 1)
        return Shape(f"cylinder = {{ radius = {radius:.6g}, length = {length:.6g} }}", prism(radius, length, 16),
                     math.hypot(radius, length / 2), {}, False)
    solid = chance.choice([lambda: octahedron(size / 2), lambda: prism(size * chance.uniform(0.1, 0.4), size, chance.randint(3, 8)),
                           lambda: closed_box(numpy.array([size, size * 0.6, size * 0.3]))])()
    return mesh_shape(chance, solid, size / 30)


def mesh_shape(chance, solid, voxel):
    name, write = chance.choice([("striker.obj", as_obj), ("striker.stl", as_stl)])
    return Shape(f'mesh = {{ file = "{name}", voxel = {voxel:.6g} }}', solid,
                 numpy.linalg.norm(solid[0], axis=1).max(), {name: write(*solid)}, True)


@dataclasses.dataclass
class Keys:
    """What a scene says of an obstacle's motion: it begins at a time and ends at another one, moved and turned about
    its centre."""
    begin: float
    end: float
    translate: numpy.ndarray
    axis: numpy.ndarray
    degrees: float
    centre: numpy.ndarray
    smooth: bool

    def pose(self, time):
        """Rotation and translation at a time, against where it was placed."""
        share = min(max((time - self.begin) / (self.end - self.begin), 0), 1)
        share = share * share * (3 - 2 * share) if self.smooth else share
        matrix = turned(self.axis, self.degrees * share)
        return matrix, self.translate * share + self.centre - matrix @ self.centre

    def words(self):
        rest = "{ time = 0 }, " if self.begin > 0 else ""
        return (f'motion = "{"smooth" if self.smooth else "linear"}"\nkeys = [{rest}{{ time = {self.begin:.9g} }}, '
                f"{{ time = {self.end:.9g}, translate = {vector(self.translate)}, "
                f"rotate = {{ axis = {vector(self.axis)}, degrees = {self.degrees:.9g} }} }}]")


@dataclasses.dataclass
class Frame:
    """How long and fast all is. pace: sizes a step."""
    size: float
    pace: float
    step: float
    steps: int
    scheme: str

    @property
    def speed(self):
        return self.pace * self.size / self.step


def frame(chance, pace, steps, scheme):
    size = chance.between(0.005, 0.5)
    speed = chance.between(3, 100)
    if scheme == "explicit":  # at most some 1,000 substeps a step
        speed = max(speed, min(pace * size / 2e-4, 300))
    return Frame(size, pace, pace * size / speed, steps, scheme)


def obstacle(chance, target, shape, much, motion):
    """Words of a striker that meets the target from outside, its solid as placed, and its keys if it has any."""
    thickness = target.thickness
    axis, degrees = chance.direction(), chance.uniform(0, 180)
    matrix = turned(axis, degrees)
    corner = shape.solid[0] @ matrix.T
    tilt = target.normal + 0.3 * chance.random() * chance.direction()
    tilt /= numpy.linalg.norm(tilt)
    reach = -(corner @ target.normal).min()
    path = much.speed * much.step * much.steps
    gap = thickness + min(path * chance.uniform(0.05, 0.6), much.size * chance.uniform(0.05, 3))
    at = target.point + target.normal * reach + tilt * gap
    # No corner below the tangent plane
    lines = [f"[obstacle.striker]\n{shape.words}",
             f"place = {{ rotate = {{ axis = {vector(axis)}, degrees = {degrees:.9g} }}, translate = {vector(at)} }}"]
    if motion == "free":
        lines += [f"density = {chance.between(100, 20000):.4g}", f"velocity = {vector(-tilt * much.speed)}"]
        if chance.random() < 0.3:
            lines.append(f"spin = {vector(spin(chance, much.step, 1))}")
        keys = None
    else:
        keys = keyed(chance, target, much, motion, at, tilt, gap, path, shape.radius)
        lines.append(keys.words())
    if chance.random() < 0.3:
        lines.append(f"friction = {chance.uniform(0.1, 1):.3g}")
    if chance.random() < 0.3:
        lines.append(f"young = {chance.between(1e6, 2e11):.4g}")
    return "\n".join(lines) + "\n", (corner + at, shape.solid[1]), keys


def keyed(chance, target, much, motion, at, tilt, gap, path, radius):
    """A motion into the target, as far as it can give way."""
    way = min(path, gap + much.size * (chance.between(0.02, 0.3) if target.border == "pinned" else 1000))
    begin = chance.choice([0, much.step * chance.uniform(0, 2)])
    lasts = way / much.speed
    axis, degrees = chance.direction(), 0.
    if motion == "turning":
        degrees = math.degrees(min(chance.uniform(0.05, 1.5) * lasts / much.step, 6))
    return Keys(begin, begin + lasts, -tilt * way, axis, degrees, at, chance.random() < 0.3)


def scene_text(chance, much, bodies, sheets=True):
    solver = [f'scheme = "{much.scheme}"', f"step = {much.step:.9g}"]
    if much.scheme in ("implicit-euler", "bdf2") and chance.random() < 0.2:
        solver.append('method = "newton"')
    gravity = [0, 0, -9.81] if chance.random() < 0.2 else [0, 0, 0]
    friction = chance.uniform(0.1, 0.8) if chance.random() < 0.3 else 0
    return (f"duration = {much.step * much.steps:.12g}\nforce.gravity = {vector(gravity)}\n[contact]\nfriction = {friction:.3g}\n"
            f"[solver]\n" + "\n".join(solver) + f"\n[output]\nevery = {much.step:.9g}\n" + bodies)


def obstacle_blow(chance, seed, scheme):
    """A striker of any kind on a sheet of any kind."""
    how = chance.choice(["pinned"] * 3 + ["closed"] * 2 + ["large", "free", "free", "spinning", "tube", "bowl"])
    pace, steps = chance.between(0.01, 10), chance.randint(8, 20)
    if how == "large":
        pace, steps = chance.between(0.005, 0.02), chance.randint(3, 6)
        pace = min(pace, 0.08 / steps)
    much = frame(chance, pace, steps, scheme)
    make = pane if how in ("pinned", "free", "large", "spinning") else shell
    target = make(chance, much.size, much.step, how)
    kind = chance.choice(["sphere", "box", "mesh", "rod", "wire", "cylinder"])
    widest = 0.15 if how == "large" else 0.4 if how == "pinned" else 1.5
    shape = striker_shape(chance, much.size * chance.between(0.03, widest), kind)
    motion = chance.choice(["keyed", "turning", "free", "free"] if shape.free else ["keyed", "turning"])
    words, solid, keys = obstacle(chance, target, shape, much, motion)
    return Blow(seed, f"{kind} {motion} on {how}", scheme, pace, much.step,
                scene_text(chance, much, target.words + words), shape.files, "struck" if target.border else None, target.border,
                {"striker": solid}, {"striker": keys} if keys else {})


def sheet_blow(chance, seed, scheme):
    """A flat sheet that flies at another sheet."""
    how = chance.choice(["pinned", "pinned", "closed", "large", "free", "tube"])
    pace, steps = chance.between(0.01, 10), chance.randint(8, 20)
    if how == "large":
        steps = chance.randint(3, 6)
        pace = min(chance.between(0.005, 0.02), 0.08 / steps)
    much = frame(chance, pace, steps, scheme)
    make = pane if how in ("pinned", "free", "large") else shell
    target = make(chance, much.size, much.step, how)
    size = much.size * chance.between(0.05, 0.15 if how == "large" else 0.5)
    mesh, middle = flat(chance, size, chance.randint(6, 60))
    stuff, thickness = material(chance, size, 1e-3)
    axis, degrees = chance.direction(), chance.uniform(0, 180)
    matrix = turned(axis, degrees)
    extent = numpy.array([[x, y, 0] for x in (-1, 1) for y in (-1, 1)]) * size / 2 @ matrix.T
    reach = -(extent @ target.normal).min()
    path = much.speed * much.step * steps
    gap = thickness + target.thickness + min(path * chance.uniform(0.05, 0.6), much.size)
    at = target.point + target.normal * (reach + gap)
    more = [f"place = {{ rotate = {{ axis = {vector(axis)}, degrees = {degrees:.9g} }}, "
            f"translate = {vector(at - matrix @ middle)} }}", f"velocity = {vector(-target.normal * much.speed)}"]
    if chance.random() < 0.3:
        more.append(f"spin = {vector(spin(chance, much.step, 0.5))}")
    words = target.words + sheet_words("flying", mesh, stuff, more)
    return Blow(seed, f"sheet on {how}", scheme, pace, much.step, scene_text(chance, much, words), {},
                "struck" if target.border else None, target.border)


def fold_blow(chance, seed, scheme):
    """A strip whose ends are moved through each other: one is pinned, the other is turned over onto it, and beyond."""
    much = frame(chance, chance.between(0.01, 1), chance.randint(8, 20), scheme)
    stuff, thickness = material(chance, much.size)
    width, edge = much.size * chance.uniform(0.1, 0.3), much.size * chance.uniform(0.05, 0.08)
    mesh = f'{{ generate = "rectangle", width = {much.size:.6g}, height = {width:.6g}, edge_length = {edge:.6g} }}'
    lasts = much.step * much.steps
    end = (f"{{ box = [[{much.size * 0.95:.6g}, -1, -1], [{much.size * 1.05:.6g}, 1, 1]], centre = [{much.size / 2:.6g}, 0, 0], "
           f"keys = [{{ time = 0 }}, {{ time = {lasts:.9g}, rotate = {{ axis = [0, 1, 0], "
           f"degrees = {-chance.uniform(185, 260):.6g} }} }}] }}")
    start = f"{{ box = [[-1, -1, -1], [{much.size * 0.05:.6g}, 1, 1]] }}"
    words = sheet_words("strip", mesh, stuff, [f"pin = [{start}, {end}]"])
    return Blow(seed, "strip folded", scheme, 1 / much.steps, much.step, scene_text(chance, much, words), {})


def blow(seed):
    chance = Chance(seed)
    scheme = chance.choice(SCHEMES)
    make = chance.choice([obstacle_blow] * 7 + [sheet_blow] * 2 + [fold_blow])
    return make(chance, seed, scheme)
