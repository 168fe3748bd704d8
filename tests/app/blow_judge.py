# SPDX-License-Identifier: GPL-3.0-or-later
"""Says of a recording whether anything passed through a sheet. It shares nothing with the program but the file: bodies
and obstacles move by the screw between two frames, sheets straight after their mean rotation is taken out, and a vertex
that meets a triangle, or an edge another edge, at a time between is a crossing. Where a sheet is closed, by itself or by
a rim that rests, or is large, the solid angle that it fills as seen from a point says on which side the point is."""
import dataclasses

import numpy

TURN = 0.1  # rad, in a part of a frame in which all moves straight
SHRUNK = 0.97  # solids, about their middle: round obstacles have facets, which lie within
INSIDE = 1e-9  # of an element, beside its border
BISECTIONS = 40


# Motions


def rotation_vector(matrix):
    """Axis times angle (rad) of a rotation."""
    sine = numpy.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2
    cosine = (numpy.trace(matrix) - 1) / 2
    angle = numpy.arctan2(numpy.linalg.norm(sine), cosine)
    if angle < 1e-9:
        return sine
    if angle > numpy.pi - 1e-4:  # the axis is that of the projection that is left
        square = (matrix + numpy.eye(3)) / 2
        axis = square[:, numpy.argmax(numpy.diag(square))]
        axis = axis / numpy.linalg.norm(axis)
        return angle * (axis if axis @ sine >= 0 else -axis)
    return angle * sine / numpy.linalg.norm(sine)


def rotation(vector):
    angle = numpy.linalg.norm(vector)
    if angle == 0:
        return numpy.eye(3)
    x, y, z = vector / angle
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


class SheetMotion:
    """A sheet between two frames: straight, after its mean rotation is taken out."""

    def __init__(self, start, end):
        self.begin, self.end = start.mean(axis=0), end.mean(axis=0)
        self.start = start - self.begin
        left, _, right = numpy.linalg.svd((end - self.end).T @ self.start)
        matrix = left @ numpy.diag([1, 1, numpy.sign(numpy.linalg.det(left @ right))]) @ right
        self.turn = rotation_vector(matrix)
        self.change = (end - self.end) @ matrix - self.start

    def at(self, share):
        return (self.start + share * self.change) @ rotation(share * self.turn).T + self.begin + share * (self.end - self.begin)


class BodyMotion:
    """A solid between two poses (rotation, translation) against its place: by their screw."""

    def __init__(self, corner, start, end):
        self.corner = corner @ start[0].T + start[1]
        matrix = end[0] @ start[0].T
        self.turn = rotation_vector(matrix)
        shift = end[1] - matrix @ start[1]  # x goes to matrix x + shift
        angle = numpy.linalg.norm(self.turn)
        self.axis = self.turn / angle if angle > 0 else numpy.zeros(3)
        self.slide = (shift @ self.axis) * self.axis if angle > 1e-9 else shift
        # The point that the rotation leaves where it is, nearest to the middle of the solid
        middle = self.corner.mean(axis=0)
        self.fixed = middle
        if angle > 1e-9:
            here = matrix @ middle + shift - self.slide - middle
            across = numpy.cross(self.axis, here)
            self.fixed = middle + here / 2 + across / (2 * numpy.tan(angle / 2))

    def at(self, share):
        return (self.corner - self.fixed) @ rotation(share * self.turn).T + self.fixed + share * self.slide


class KeyedMotion:
    """A solid that moves by its keys, which the scene has."""

    def __init__(self, corner, keys, begin, end):
        self.corner, self.keys, self.begin, self.end = corner, keys, begin, end
        first, last = keys.pose(begin)[0], keys.pose(end)[0]
        self.turn = rotation_vector(last @ first.T)

    def at(self, share):
        matrix, shift = self.keys.pose(self.begin + share * (self.end - self.begin))
        return self.corner @ matrix.T + shift


# Crossings of straight motions


def first_zeros(coefficients):
    """Up to three zeros in [0, 1] of each cubic, in rows; NaN where there is none."""
    c0, c1, c2, c3 = coefficients
    with numpy.errstate(all="ignore"):
        root = numpy.sqrt(c2 * c2 - 3 * c1 * c3)
        sum_ = -(c2 + numpy.where(c2 >= 0, root, -root))
        turns = numpy.stack([sum_ / (3 * c3), c1 / sum_])
    turns = numpy.sort(numpy.clip(numpy.nan_to_num(turns, nan=0., posinf=1., neginf=0.), 0, 1), axis=0)
    ends = [numpy.zeros_like(c0), turns[0], turns[1], numpy.ones_like(c0)]

    def value(t):
        return c0 + t * (c1 + t * (c2 + t * c3))
    zeros = []
    for low, high in zip(ends, ends[1:]):
        negative = value(low) < 0
        found = (negative != (value(high) < 0)) & (high > low)
        low, high = low.copy(), high.copy()
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            left = (value(middle) < 0) == negative
            low, high = numpy.where(left, middle, low), numpy.where(left, high, middle)
        zeros.append(numpy.where(found, (low + high) / 2, numpy.nan))
    return numpy.stack(zeros)


def coplanar_times(a, b, c):
    """When three vectors, each (start, change), lie in a plane."""
    def triple(u, v, w):
        return numpy.einsum("ij,ij->i", u, numpy.cross(v, w))
    c0 = triple(a[0], b[0], c[0])
    c1 = triple(a[1], b[0], c[0]) + triple(a[0], b[1], c[0]) + triple(a[0], b[0], c[1])
    c2 = triple(a[0], b[1], c[1]) + triple(a[1], b[0], c[1]) + triple(a[1], b[1], c[0])
    return first_zeros((c0, c1, c2, triple(a[1], b[1], c[1])))


def overlapping(first, second):
    """Pairs of boxes (low, high) that overlap."""
    apart = (first[0][:, None, :] > second[1][None]).any(axis=2) | (second[0][None] > first[1][:, None, :]).any(axis=2)
    return numpy.nonzero(~apart)


def boxes(start, end, elements):
    points = numpy.concatenate([start[elements], end[elements]], axis=1)
    return points.min(axis=1), points.max(axis=1)


@dataclasses.dataclass
class Crossing:
    """What passes what, when (share of the frame) and where, with the vertices of the second's element, and its two
    weights. way: 1 where a vertex goes to the side of the normal, else -1; 0 of edges."""
    time: float
    place: numpy.ndarray
    of: str
    through: str
    element: tuple
    weights: tuple
    way: int


def at_time(start, end, vertices, time):
    return start[vertices] + time[:, None] * (end - start)[vertices]


def vertex_crossings(points, faces_of, faces):
    """Vertices of `points` through triangles; each (start, end). Yields (pairs, time, weights)."""
    vertex, face = overlapping((numpy.minimum(*points), numpy.maximum(*points)), boxes(*faces_of, faces))
    corner = faces[face]
    mine = (corner != vertex[:, None]).all(axis=1) if points is faces_of else numpy.ones(len(vertex), bool)
    vertex, corner = vertex[mine], corner[mine]
    if len(vertex) == 0:
        return

    def side(array, k):
        return array[corner[:, k]] - array[corner[:, 0]]
    start, end = faces_of
    a, b = [(side(start, k), side(end - start, k)) for k in (1, 2)]
    p = (points[0][vertex] - start[corner[:, 0]], (points[1] - points[0])[vertex] - (end - start)[corner[:, 0]])
    for zeros in coplanar_times(a, b, p):
        found = ~numpy.isnan(zeros)
        t = zeros[found]
        u, v, w = [x[0][found] + t[:, None] * x[1][found] for x in (a, b, p)]
        uu, uv, vv, wu, wv = [numpy.einsum("ij,ij->i", x, y) for x, y in ((u, u), (u, v), (v, v), (w, u), (w, v))]
        with numpy.errstate(all="ignore"):
            area = uu * vv - uv * uv
            first, second = (vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area
            inside = (first > INSIDE) & (second > INSIDE) & (first + second < 1 - INSIDE)
        yield vertex[found][inside], corner[found][inside], t[inside], first[inside], second[inside]


def edge_crossings(one, edges_of_one, other, edges_of_other):
    """Edges that cross edges."""
    first, second = overlapping(boxes(*one, edges_of_one), boxes(*other, edges_of_other))
    if one is other:
        once = first < second
        first, second = first[once], second[once]
    e, f = edges_of_one[first], edges_of_other[second]
    if one is other:
        apart = (e[:, :, None] != f[:, None, :]).all(axis=(1, 2))
        e, f = e[apart], f[apart]
    if len(e) == 0:
        return
    change, other_change = one[1] - one[0], other[1] - other[0]
    a = (one[0][e[:, 1]] - one[0][e[:, 0]], change[e[:, 1]] - change[e[:, 0]])
    b = (other[0][f[:, 1]] - other[0][f[:, 0]], other_change[f[:, 1]] - other_change[f[:, 0]])
    d = (other[0][f[:, 0]] - one[0][e[:, 0]], other_change[f[:, 0]] - change[e[:, 0]])
    for zeros in coplanar_times(a, b, d):
        found = ~numpy.isnan(zeros)
        t = zeros[found]
        u, v, w = [x[0][found] + t[:, None] * x[1][found] for x in (a, b, d)]
        uu, uv, vv, wu, wv = [numpy.einsum("ij,ij->i", x, y) for x, y in ((u, u), (u, v), (v, v), (w, u), (w, v))]
        with numpy.errstate(all="ignore"):
            area = uu * vv - uv * uv
            s, r = (wu * vv - wv * uv) / area, (wu * uv - wv * uu) / area
            inside = (s > INSIDE) & (s < 1 - INSIDE) & (r > INSIDE) & (r < 1 - INSIDE) & (area > 1e-12 * uu * vv)
        yield e[found][inside], f[found][inside], t[inside], s[inside], r[inside]


def edges_of(faces):
    pairs = numpy.sort(numpy.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    return numpy.unique(pairs, axis=0)


@dataclasses.dataclass
class Surface:
    """Something that moves in a frame."""
    name: str
    motion: object
    faces: numpy.ndarray
    edges: numpy.ndarray
    is_sheet: bool


def crossings_of(one, other, parts):
    """All crossings of two surfaces, or of a sheet with itself, in a frame."""
    found = []
    times = numpy.linspace(0, 1, parts + 1)
    for begin, end in zip(times, times[1:]):
        a = (one.motion.at(begin), one.motion.at(end))
        b = a if one is other else (other.motion.at(begin), other.motion.at(end))
        both = [(a, one, b, other)] if one is other else [(a, one, b, other), (b, other, a, one)]
        for points, mine, triangles, its in both:
            for vertex, corner, t, u, v in vertex_crossings(points, triangles, its.faces):
                places = at_time(*points, vertex, t)
                for i in range(len(vertex)):
                    found.append(Crossing(begin + t[i] * (end - begin), places[i], mine.name, its.name,
                                          tuple(corner[i]), (1 - u[i] - v[i], u[i], v[i]), 1))
        for e, f, t, s, r in edge_crossings(a, one.edges, b, other.edges):
            for i in range(len(e)):
                sheet = one if one.is_sheet and not other.is_sheet else other
                edge, weight = (e[i], s[i]) if sheet is one else (f[i], r[i])
                place = a[0][e[i, 0]] + t[i] * (a[1] - a[0])[e[i, 0]]
                found.append(Crossing(begin + t[i] * (end - begin), place, (other if sheet is one else one).name, sheet.name,
                                      tuple(edge), (1 - weight, weight), 0))
    return found


# Sides


def solid_angles(points, corner, faces):
    """How much of the sphere around each point these triangles fill, signed (van Oosterom and Strackee 1983)."""
    rays = corner[None] - points[:, None]
    length = numpy.linalg.norm(rays, axis=2)
    a, b, c = [rays[:, faces[:, k]] for k in range(3)]
    la, lb, lc = [length[:, faces[:, k]] for k in range(3)]
    volume = numpy.einsum("pfi,pfi->pf", a, numpy.cross(b, c))
    dot = [numpy.einsum("pfi,pfi->pf", x, y) for x, y in ((a, b), (b, c), (c, a))]
    return 2 * numpy.arctan2(volume, la * lb * lc + dot[0] * lc + dot[1] * la + dot[2] * lb).sum(axis=1)


def times_through(start, end, corner, faces):
    """How often each straight way goes through resting triangles, signed: once to the side of their normals is 1."""
    a, b, c = [corner[faces[:, k]] for k in range(3)]
    way = (end - start)[:, None, :]

    def volume(u, v):  # of the tetrahedron of the way and a side
        return numpy.einsum("pfi,pfi->pf", numpy.broadcast_to(way, (len(start), len(faces), 3)),
                            numpy.cross(u[None] - start[:, None], v[None] - start[:, None]))
    sides = numpy.stack([volume(a, b), volume(b, c), volume(c, a)])
    normal = numpy.cross(b - a, c - a)
    before = numpy.einsum("pfi,fi->pf", start[:, None] - a[None], normal) >= 0
    after = numpy.einsum("pfi,fi->pf", end[:, None] - a[None], normal) >= 0
    through = (before != after) & ((sides > 0).all(axis=0) | (sides <= 0).all(axis=0))
    return (through * numpy.where(after, 1, -1)).sum(axis=1)


class Sides:
    """On which side of a sheet points are, frame by frame."""

    def __init__(self, border, corner, faces, points):
        self.border, self.rest, self.faces = border, corner, faces
        self.points, self.through = points, numpy.zeros(len(points), int)
        self.first = solid_angles(points, corner, faces)

    def step(self, points, corner):
        """Which of the points are on the other side at the end of this frame. points: at several times in it."""
        if self.border == "pinned":
            for place in points:
                self.through += times_through(self.points, place, self.rest, self.faces)
                self.points = place
        last = points[-1]
        now = solid_angles(last, corner, self.faces)
        if self.border == "closed":
            return numpy.rint((now - self.first) / (4 * numpy.pi)) != 0
        if self.border == "large":
            return (now * self.first < 0) & (numpy.abs(self.first) > numpy.pi) & (numpy.abs(now) > numpy.pi)
        between = numpy.rint((now - solid_angles(last, self.rest, self.faces)) / (4 * numpy.pi)).astype(int)
        return between - self.through != 0
