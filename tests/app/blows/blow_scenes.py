# SPDX-License-Identifier: GPL-3.0-or-later
"""Random impacts: scenes in which something strikes a sheet, each determined by its seed. A scene has at most 300 faces
and 20 steps. `Blow` has the data that the checks need and the recording lacks."""
import dataclasses
import math

import numpy

from blow_parts import (Chance, Keys, flat, material, pace, placed, sheet_words, spin, striker_shape, target, turn,
                        vector)
from blow_solids import closed_box, turned

SCHEMES = ["implicit-euler"] * 4 + ["bdf2"] * 2 + ["explicit"] * 2 + ["auto"] * 2


@dataclasses.dataclass
class Blow:
    """A scene, and data for its checks. struck: the sheet that nothing may pass through, or None if its sides cannot be
    told apart; border: why they can: "pinned": the boundary is at rest, "closed": there is no boundary, or "large": the
    sheet is large compared with the striker's path."""
    seed: int
    kind: str
    scheme: str
    pace: float  # sheet sizes a step
    step: float  # s
    speed: float  # m/s
    text: str
    files: dict = dataclasses.field(default_factory=dict)
    struck: str | None = None
    border: str | None = None
    solids: dict = dataclasses.field(default_factory=dict)  # obstacles by name: vertices as placed, triangles
    turns: dict = dataclasses.field(default_factory=dict)  # blow_parts.Keys of obstacles that have keys, by name


def scene_text(chance, much, bodies):
    solver = [f'scheme = "{much.scheme}"', f"step = {much.step:.9g}"]
    if much.scheme in ("implicit-euler", "bdf2") and chance.random() < 0.2:
        solver.append('method = "newton"')
    gravity = [0, 0, -9.81] if chance.random() < 0.2 else [0, 0, 0]
    friction = chance.uniform(0.1, 0.8) if chance.random() < 0.3 else 0
    return (f"duration = {much.step * much.steps:.12g}\nforce.gravity = {vector(gravity)}\n[contact]\n"
            f"friction = {friction:.3g}\n[solver]\n" + "\n".join(solver)
            + f"\n[output]\nevery = {much.step:.9g}\n" + bodies)


def made(seed, kind, much, text, **known):
    return Blow(seed, kind, much.scheme, much.sizes, much.step, much.speed, text, **known)


def keyed(chance, struck, much, size, at, tilt, gap):
    """Returns a motion into the target, as far as the target can yield. size: of the striker if it rotates, or None."""
    way = much.path
    if struck.border == "pinned":
        way = min(way, gap + much.size * chance.between(0.02, 0.25))
    begin, lasts = chance.choice([0, much.step * chance.uniform(0, 2)]), way / much.speed
    degrees = math.degrees(min(turn(chance, much, size) * lasts / much.step, 6)) if size else 0.
    return Keys(begin, begin + lasts, -tilt * way, chance.direction(), degrees, at, chance.random() < 0.3)


def striker(chance, struck, shape, much, motion):
    """Returns scene text of a striker that comes from outside, its solid as placed, and its keys or None."""
    axis, degrees = chance.direction(), chance.uniform(0, 180)
    corner = shape.solid[0] @ turned(axis, degrees).T
    tilt = struck.normal + 0.3 * chance.random() * chance.direction()
    tilt /= numpy.linalg.norm(tilt)
    gap = struck.thickness + min(much.path * chance.uniform(0.05, 0.6), much.size * chance.uniform(0.05, 3))
    at = struck.point - struck.normal * (corner @ struck.normal).min() + tilt * gap
    size = 2 * numpy.linalg.norm(corner, axis=1).max()
    lines = [f"[obstacle.striker]\n{shape.words}", placed(axis, degrees, at)]
    keys = None
    if motion == "free":
        lines += [f"density = {chance.between(100, 20000):.4g}", f"velocity = {vector(-tilt * much.speed)}"]
        if chance.random() < 0.3:
            lines.append(spin(chance, much, size))
    else:
        keys = keyed(chance, struck, much, size if motion == "turning" else None, at, tilt, gap)
        lines.append(keys.words())
    if chance.random() < 0.3:
        lines.append(f"friction = {chance.uniform(0.1, 1):.3g}")
    if chance.random() < 0.3:
        lines.append(f"young = {chance.between(1e6, 2e11):.4g}")
    return "\n".join(lines) + "\n", (corner + at, shape.solid[1]), keys


def obstacle_blow(chance, seed, scheme):
    """Returns the impact of a striker of any kind on a sheet of any kind."""
    how = chance.choice(["pinned"] * 3 + ["closed", "large", "free"] * 2 + ["spinning", "tube", "bowl"])
    much = pace(chance, scheme, how)
    struck = target(chance, much, how)
    kind = chance.choice(["sphere", "box", "mesh", "rod", "wire", "cylinder"])
    widest = {"large": 0.15, "pinned": 0.4}.get(how, 1.5)
    shape = striker_shape(chance, much.size * chance.between(0.05, widest), kind)
    motion = chance.choice(["keyed", "turning", "free", "free"] if shape.free else ["keyed", "turning"])
    words, solid, keys = striker(chance, struck, shape, much, motion)
    text = scene_text(chance, much, struck.words + words)
    return made(seed, f"{kind} {motion} on {how}", much, text, files=shape.files, border=struck.border,
                struck="struck" if struck.border else None, solids={"striker": solid},
                turns={"striker": keys} if keys else {})


def sheet_blow(chance, seed, scheme):
    """Returns the impact of a flat sheet on another sheet."""
    how = chance.choice(["pinned", "pinned", "closed", "large", "free", "tube"])
    much = pace(chance, scheme, how)
    struck = target(chance, much, how)
    size = much.size * chance.between(0.1, 0.15 if how == "large" else 0.5)
    mesh, middle = flat(chance, size, chance.randint(6, 60))
    stuff = material(chance, size, 3e-3)
    axis, degrees = chance.direction(), chance.uniform(0, 180)
    matrix = turned(axis, degrees)
    extent = numpy.array([[x, y, 0] for x in (-1, 1) for y in (-1, 1)]) * size / 2 @ matrix.T
    gap = stuff.thickness + struck.thickness + min(much.path * chance.uniform(0.05, 0.6), much.size)
    at = struck.point + struck.normal * (gap - (extent @ struck.normal).min())
    more = [placed(axis, degrees, at - matrix @ middle), f"velocity = {vector(-struck.normal * much.speed)}"]
    if chance.random() < 0.3:
        more.append(spin(chance, much, size))
    words = struck.words + sheet_words("flying", mesh, stuff, more)
    return made(seed, f"sheet on {how}", much, scene_text(chance, much, words),
                struck="struck" if struck.border else None, border=struck.border)


def fold_blow(chance, seed, scheme):
    """Returns the scene of a strip whose one end is folded over onto the other, or, where steps are long, beyond it."""
    much = pace(chance, scheme, "folded", thickest=0.01)
    size, degrees = much.size, chance.uniform(90, 170)
    much.steps = max(much.steps, 5)
    if much.steps < 12 and chance.random() < 0.5:
        degrees = chance.uniform(185, 260)
    much.sizes = math.radians(degrees) / 2 / much.steps
    width, edge = size * chance.uniform(0.1, 0.3), size * chance.uniform(0.06, 0.09)
    mesh = f'{{ generate = "rectangle", width = {size:.6g}, height = {width:.6g}, edge_length = {edge:.6g} }}'
    end = (f"{{ box = [[{size * 0.95:.6g}, -1, -1], [{size * 1.05:.6g}, 1, 1]], centre = [{size / 2:.6g}, 0, 0], "
           f"keys = [{{ time = 0 }}, {{ time = {much.step * much.steps:.9g}, rotate = {{ axis = [0, 1, 0], "
           f"degrees = {-degrees:.6g} }} }}] }}")
    start = f"{{ box = [[-1, -1, -1], [{size * 0.05:.6g}, 1, 1]] }}"
    words = sheet_words("strip", mesh, much.stuff, [f"pin = [{start}, {end}]"])
    return made(seed, "end on strip", much, scene_text(chance, much, words))


def crush_blow(chance, seed, scheme):
    """Returns the scene of a tube or sphere on an anvil, which a hammer presses until it folds and touches itself."""
    much = pace(chance, scheme, "crushed", thickest=0.01)
    size, closed = much.size, chance.random() < 0.5
    edge = size * chance.uniform(0.2, 0.28)
    mesh = (f'{{ generate = "sphere", radius = {size / 2:.6g}, edge_length = {edge:.6g} }}' if closed else
            f'{{ generate = "cylinder", radius = {size / 2:.6g}, height = {size:.6g}, edge_length = {edge:.6g} }}')
    middle = 0 if closed else size / 2
    block = numpy.array([2 * size, size, 3 * size])
    way = size * chance.uniform(0.4, 0.75)
    much.sizes = min(way / much.path, 1) * much.sizes
    gap, lasts = 2 * much.stuff.thickness, way / much.speed
    anvil, hammer = [numpy.array([0, sign * (size + gap), middle]) for sign in (-1, 1)]
    keys = Keys(0, lasts, numpy.array([0, -way, 0]), numpy.array([0, 0, 1.]), 0., hammer, chance.random() < 0.5)
    words = sheet_words("struck", mesh, much.stuff, [])
    for name, at, more in (("anvil", anvil, ""), ("hammer", hammer, keys.words() + "\n")):
        words += f"[obstacle.{name}]\nbox = {{ size = {vector(block)}, centre = {vector(at)} }}\n{more}"
    corner, faces = closed_box(block)
    return made(seed, f"hammer on crushed {'sphere' if closed else 'tube'}", much, scene_text(chance, much, words),
                struck="struck" if closed else None, border="closed" if closed else None,
                solids={"hammer": (corner + hammer, faces), "anvil": (corner + anvil, faces)}, turns={"hammer": keys})


def blow(seed):
    chance = Chance(seed)
    scheme = chance.choice(SCHEMES)
    make = chance.choice([obstacle_blow] * 14 + [sheet_blow] * 4 + [fold_blow, crush_blow])
    return make(chance, seed, scheme)
