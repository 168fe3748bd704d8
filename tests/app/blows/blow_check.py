# SPDX-License-Identifier: GPL-3.0-or-later
"""Decides whether anything passed through a sheet between two frames, by code of its own, independent of the program's.
Bodies and obstacles move by the screw motion between the frames, sheets in straight lines once their mean rotation is
removed. A crossing is a vertex that meets a triangle, or an edge that meets another edge, at a time in between. For a
sheet that is closed, or has a boundary at rest, or is large, its solid angle as seen from a point tells on which side
the point is."""
import dataclasses

import numpy

TURN = 0.1  # rad, largest rotation in a part of a frame in which all points move straight
SHRUNK = 0.97  # scale of solids about their middle: facets of round obstacles lie inside the obstacle
INSIDE = 1e-9  # smallest barycentric coordinate of a point inside an element
BISECTIONS = 40
KNOWN = 1.5  # rad, rotation of a body in a frame below which its direction is unambiguous
FLAT = 1e-9  # distance of an edge's end from a plane over the edge's length, below which the end is in the plane
NEAR = 0.1  # distance of a point from a sheet's boundary over the sheet's extent, below which the point is dropped


# Motions


def rotation_vector(matrix):
    """Returns axis times angle (rad) of a rotation matrix."""
    sine = numpy.array([matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]) / 2
    cosine = (numpy.trace(matrix) - 1) / 2
    angle = numpy.arctan2(numpy.linalg.norm(sine), cosine)
    if angle < 1e-9:
        return sine
    if angle > numpy.pi - 1e-4:  # the symmetric part is nearly the projection on the axis
        square = (matrix + matrix.T) / 4 + numpy.eye(3) / 2
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
    """Motion of a sheet between two frames: straight, once its mean rotation is removed."""
    is_known = True

    def __init__(self, start, end):
        self.begin, self.end = start.mean(axis=0), end.mean(axis=0)
        self.start = start - self.begin
        left, _, right = numpy.linalg.svd((end - self.end).T @ self.start)
        matrix = left @ numpy.diag([1, 1, numpy.sign(numpy.linalg.det(left @ right))]) @ right
        self.turn = rotation_vector(matrix)
        self.change = (end - self.end) @ matrix - self.start

    def at(self, share):
        middle = self.begin + share * (self.end - self.begin)
        return (self.start + share * self.change) @ rotation(share * self.turn).T + middle


class BodyMotion:
    """Motion of a solid between two poses (rotation, translation) relative to its initial place: a screw motion, or,
    where the rotation is so large that its direction is ambiguous, with the solid's middle moving straight."""

    def __init__(self, corner, start, end):
        self.corner = corner @ start[0].T + start[1]
        matrix = end[0] @ start[0].T
        self.turn = rotation_vector(matrix)
        shift = end[1] - matrix @ start[1]  # x goes to matrix x + shift
        angle = numpy.linalg.norm(self.turn)
        self.axis = self.turn / angle if angle > 0 else numpy.zeros(3)
        self.slide = (shift @ self.axis) * self.axis if angle > 1e-9 else shift
        # The point of the screw axis that is nearest to the middle of the solid
        middle = self.corner.mean(axis=0)
        self.fixed = middle
        self.is_known = angle < KNOWN
        if not self.is_known:
            self.slide = matrix @ middle + shift - middle
        elif angle > 1e-9:
            here = matrix @ middle + shift - self.slide - middle
            across = numpy.cross(self.axis, here)
            self.fixed = middle + here / 2 + across / (2 * numpy.tan(angle / 2))

    def at(self, share):
        return (self.corner - self.fixed) @ rotation(share * self.turn).T + self.fixed + share * self.slide


class KeyedMotion:
    """Motion of a solid by the keys of the scene."""
    is_known = True

    def __init__(self, corner, keys, begin, end):
        self.corner, self.keys, self.begin, self.end = corner, keys, begin, end
        first, last = keys.pose(begin)[0], keys.pose(end)[0]
        self.turn = rotation_vector(last @ first.T)

    def at(self, share):
        matrix, shift = self.keys.pose(self.begin + share * (self.end - self.begin))
        return self.corner @ matrix.T + shift


# Crossings of straight motions


def zeros_of(coefficients):
    """Returns up to three zeros in [0, 1] of each cubic, NaN where there is none, and whether the cubic rises there."""
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
        zeros.append((numpy.where(found, (low + high) / 2, numpy.nan), negative))
    return zeros


def coplanar_times(a, b, c):
    """Returns the times at which three vectors, each (start, change), lie in a plane, and whether their volume then
    grows."""
    def triple(u, v, w):
        return numpy.einsum("ij,ij->i", u, numpy.cross(v, w))
    c0 = triple(a[0], b[0], c[0])
    c1 = triple(a[1], b[0], c[0]) + triple(a[0], b[1], c[0]) + triple(a[0], b[0], c[1])
    c2 = triple(a[0], b[1], c[1]) + triple(a[1], b[0], c[1]) + triple(a[1], b[1], c[0])
    return zeros_of((c0, c1, c2, triple(a[1], b[1], c[1])))


def overlapping(first, second):
    """Returns the pairs of boxes (low, high) that overlap."""
    apart = (first[0][:, None, :] > second[1][None]).any(axis=2) | (second[0][None] > first[1][:, None, :]).any(axis=2)
    return numpy.nonzero(~apart)


def boxes(start, end, elements):
    points = numpy.concatenate([start[elements], end[elements]], axis=1)
    return points.min(axis=1), points.max(axis=1)


@dataclasses.dataclass
class Crossing:
    """Two elements that cross each other in a frame an odd number of times: the names of their surfaces, and the
    distance (m) of the crossing from the boundary of the sheet."""
    of: str
    through: str
    depth: float


def at_time(start, end, vertices, time):
    return start[vertices] + time[:, None] * (end - start)[vertices]


def vertex_crossings(points, moving, faces):
    """Finds vertices of `points` that cross triangles of `moving`; both are (start, end). Yields vertices, 1 where they
    move to the side of the triangle's normal and else -1, and times."""
    vertex, face = overlapping((numpy.minimum(*points), numpy.maximum(*points)), boxes(*moving, faces))
    corner = faces[face]
    apart = (corner != vertex[:, None]).all(axis=1) if points is moving else numpy.ones(len(vertex), bool)
    vertex, corner = vertex[apart], corner[apart]
    if len(vertex) == 0:
        return
    start, change = moving[0], moving[1] - moving[0]
    a, b = [(start[corner[:, k]] - start[corner[:, 0]], change[corner[:, k]] - change[corner[:, 0]]) for k in (1, 2)]
    p = (points[0][vertex] - start[corner[:, 0]], (points[1] - points[0])[vertex] - change[corner[:, 0]])
    for zeros, rises in coplanar_times(a, b, p):
        found = ~numpy.isnan(zeros)
        t = zeros[found]
        u, v, w = [x[0][found] + t[:, None] * x[1][found] for x in (a, b, p)]
        first, second = shares(u, v, w)
        inside = (first > INSIDE) & (second > INSIDE) & (first + second < 1 - INSIDE)
        yield vertex[found][inside], numpy.where(rises[found][inside], 1, -1), t[inside]


def shares(u, v, w):
    """Returns the coefficients of w, which lies in the plane of u and v, in terms of u and v; NaN for parallel ones."""
    uu, uv, vv, wu, wv = [numpy.einsum("ij,ij->i", x, y) for x, y in ((u, u), (u, v), (v, v), (w, u), (w, v))]
    with numpy.errstate(all="ignore"):
        area = uu * vv - uv * uv
        found = numpy.stack([(vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area])
    return numpy.where(area > 1e-12 * uu * vv, found, numpy.nan)


def edge_crossings(one, edges_of_one, other, edges_of_other):
    """Finds edges of two surfaces that cross. Yields the edges of the one, the edges of the other, times and places."""
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
    for zeros, _ in coplanar_times(a, b, d):
        found = ~numpy.isnan(zeros)
        t = zeros[found]
        u, v, w = [x[0][found] + t[:, None] * x[1][found] for x in (a, b, d)]
        first, second = shares(u, v, w)
        inside = (first > INSIDE) & (first < 1 - INSIDE) & (second < -INSIDE) & (second > INSIDE - 1)
        e_in, t = e[found][inside], t[inside]
        yield e_in, f[found][inside], t, at_time(*one, e_in[:, 0], t) + first[inside, None] * u[inside]


@dataclasses.dataclass
class Surface:
    """A triangle mesh with its motion between two frames."""
    name: str
    motion: object
    faces: numpy.ndarray
    is_sheet: bool

    def __post_init__(self):
        sides = numpy.concatenate([self.faces[:, [0, 1]], self.faces[:, [1, 2]], self.faces[:, [2, 0]]])
        self.edges, count = numpy.unique(numpy.sort(sides, axis=1), axis=0, return_counts=True)
        self.rim = self.edges[count == 1]
        self.rims = set(map(tuple, self.rim))

    def depth(self, place, time):
        """Returns the distance (m) of a place from the boundary, at a time in the frame from 0 to 1."""
        if len(self.rim) == 0:
            return numpy.inf
        return distances(place[None], self.motion.at(time), self.rim)[0]


def distances(places, corner, edges):
    """Returns the distance (m) of each place from the nearest of the edges."""
    start, way = corner[edges[:, 0]], corner[edges[:, 1]] - corner[edges[:, 0]]
    share = numpy.clip(((places[:, None] - start) * way).sum(axis=2) / (way ** 2).sum(axis=1), 0, 1)
    return numpy.linalg.norm(start + share[..., None] * way - places[:, None], axis=2).min(axis=1)


def parts_of(one, other):
    """Returns begin and end of parts of a frame in which neither surface rotates by more than TURN."""
    turn = max(numpy.linalg.norm(one.motion.turn), numpy.linalg.norm(other.motion.turn))
    times = numpy.linspace(0, 1, (int(numpy.ceil(turn / TURN)) or 1) + 1)
    return zip(times, times[1:])


def crossings_of(one, other):
    """Returns the crossings of two surfaces, or of a sheet with itself, in a frame. Returns none if all crossings are
    undone within the frame: if no vertex stays on the other side of a face and no boundary edge has crossed an edge."""
    # vertices: {(surface, surface passed, vertex): (sum of the signs of its crossings, time and place of the last)};
    # pairs: {pair of edges: (number of crossings, time and place of the last)}
    vertices, pairs = {}, {}
    for begin, end in parts_of(one, other):
        a = (one.motion.at(begin), one.motion.at(end))
        b = a if one is other else (other.motion.at(begin), other.motion.at(end))
        for points, mine, triangles, its in [(a, one, b, other), (b, other, a, one)][:1 if one is other else 2]:
            for vertex, way, t in vertex_crossings(points, triangles, its.faces):
                for i, place in enumerate(at_time(*points, vertex, t)):
                    key = (mine.name, its.name, vertex[i])
                    vertices[key] = (vertices.get(key, (0,))[0] + way[i], begin + t[i] * (end - begin), place)
        for e, f, t, place in edge_crossings(a, one.edges, b, other.edges):
            for i, key in enumerate(zip(map(tuple, e), map(tuple, f))):
                pairs[key] = (pairs.get(key, (0,))[0] + 1, begin + t[i] * (end - begin), place[i])
    sheet = {surface.name: surface for surface in (one, other) if surface.is_sheet}
    found = [Crossing(of, through, (sheet.get(through) or sheet[of]).depth(place, time))
             for (of, through, _), (ways, time, place) in vertices.items() if ways != 0]
    odd = {key: where for key, (times, *where) in pairs.items() if times % 2 == 1}
    if not found and not any(e in one.rims or f in other.rims for e, f in odd):
        return []
    return found + [Crossing(one.name, other.name, min(s.depth(place, time) for s in sheet.values()))
                    for time, place in odd.values()]


def largest_motion(one, other):
    """Returns the largest displacement (m) of any point in a frame, relative to the middle of the other surface."""
    begin, end = [[surface.motion.at(time) for surface in (one, other)] for time in (0, 1)]
    shift = end[1].mean(axis=0) - begin[1].mean(axis=0)
    return max(numpy.linalg.norm(last - first - shift, axis=1).max() for first, last in zip(begin, end))


def standing_crossings(one, other, time):
    """Returns the number of edges that intersect triangles of the other surface, at a time in the frame."""
    count = 0
    for edged, faced in [(one, other), (other, one)][:1 if one is other else 2]:
        corner, points = faced.motion.at(time), edged.motion.at(time)
        edge, face = overlapping(boxes(points, points, edged.edges), boxes(corner, corner, faced.faces))
        ends, triangle = edged.edges[edge], faced.faces[face]
        if one is other:
            apart = (ends[:, :, None] != triangle[:, None, :]).all(axis=(1, 2))
            ends, triangle = ends[apart], triangle[apart]
        corners = [corner[triangle[:, k]] for k in range(3)]
        count += int(is_through(points[ends[:, 0]], points[ends[:, 1]], *corners).sum())
    return count


def is_through(start, end, a, b, c):
    """Returns for each segment whether it passes through its triangle."""
    def volume(p, q, r, s):
        return numpy.einsum("ij,ij->i", q - p, numpy.cross(r - p, s - p))
    sides = numpy.stack([volume(start, end, a, b), volume(start, end, b, c), volume(start, end, c, a)])
    normal = numpy.cross(b - a, c - a)
    normal /= numpy.linalg.norm(normal, axis=1)[:, None]
    before, after = [numpy.einsum("ij,ij->i", end_ - a, normal) for end_ in (start, end)]
    clear = numpy.minimum(abs(before), abs(after)) > FLAT * numpy.linalg.norm(end - start, axis=1)
    return clear & (before * after < 0) & ((sides > 0).all(axis=0) | (sides < 0).all(axis=0))


# Sides


def solid_angles(points, corner, faces):
    """Returns the signed solid angle of the triangles as seen from each point (van Oosterom and Strackee 1983)."""
    rays = corner[None] - points[:, None]
    length = numpy.linalg.norm(rays, axis=2)
    a, b, c = [rays[:, faces[:, k]] for k in range(3)]
    la, lb, lc = [length[:, faces[:, k]] for k in range(3)]
    volume = numpy.einsum("pfi,pfi->pf", a, numpy.cross(b, c))
    dot = [numpy.einsum("pfi,pfi->pf", x, y) for x, y in ((a, b), (b, c), (c, a))]
    return 2 * numpy.arctan2(volume, la * lb * lc + dot[0] * lc + dot[1] * la + dot[2] * lb).sum(axis=1)


def times_through(start, end, corner, faces):
    """Returns how often each segment passes through triangles at rest: +1 to the side of their normals, -1 back."""
    a, b, c = [corner[faces[:, k]] for k in range(3)]
    way = (end - start)[:, None, :]

    def volume(u, v):  # tetrahedron of the segment and a side
        return numpy.einsum("pfi,pfi->pf", numpy.broadcast_to(way, (len(start), len(faces), 3)),
                            numpy.cross(u[None] - start[:, None], v[None] - start[:, None]))
    sides = numpy.stack([volume(a, b), volume(b, c), volume(c, a)])
    normal = numpy.cross(b - a, c - a)
    before = numpy.einsum("pfi,fi->pf", start[:, None] - a[None], normal) >= 0
    after = numpy.einsum("pfi,fi->pf", end[:, None] - a[None], normal) >= 0
    through = (before != after) & ((sides > 0).all(axis=0) | (sides <= 0).all(axis=0))
    return (through * numpy.where(after, 1, -1)).sum(axis=1)


class Sides:
    """Sides of a sheet on which points are, frame by frame. Points that come near a boundary at rest are dropped, since
    between two frames they may move around it."""

    def __init__(self, border, sheet, points):
        self.border, self.rest, self.faces, self.rim = border, sheet.motion.at(0), sheet.faces, sheet.rim
        self.points, self.through = points, numpy.zeros(len(points), int)
        self.kept = numpy.ones(len(points), bool)
        self.near = NEAR * numpy.ptp(self.rest, axis=0).max()
        self.first = solid_angles(points, self.rest, self.faces)

    def step(self, points, corner, known):
        """Returns which points are on the other side at the end of this frame. points: their places at several times in
        the frame. known: whether the path of each point is unambiguous."""
        self.kept &= known
        if self.border == "pinned":
            for place in points:
                self.through += times_through(self.points, place, self.rest, self.faces)
                self.kept &= distances(place, self.rest, self.rim) > self.near
                self.points = place
        last = points[-1]
        now = solid_angles(last, corner, self.faces)
        if self.border == "closed":
            return numpy.rint((now - self.first) / (4 * numpy.pi)) != 0
        if self.border == "large":
            return (now * self.first < 0) & (numpy.abs(self.first) > numpy.pi) & (numpy.abs(now) > numpy.pi)
        between = numpy.rint((now - solid_angles(last, self.rest, self.faces)) / (4 * numpy.pi)).astype(int)
        return self.kept & (between - self.through != 0)
