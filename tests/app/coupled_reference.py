# SPDX-License-Identifier: GPL-3.0-or-later
"""Reference energies of coupled hinges and of arcs, which share no code and no formulas with the program: patches of
triangles are unfolded into the plane point by point, and the slopes and angles of their facets are evaluated on
quadratic surfaces."""
import numpy as np

LEAST_SIGHT = 0.2  # documented in docs/theory/bending.md
SURFACES = [lambda p: p[0] ** 2 / 2, lambda p: p[1] ** 2 / 2, lambda p: p[0] * p[1] / np.sqrt(2)]
SLOPES = [lambda p: np.array([p[0], 0]), lambda p: np.array([0, p[1]]), lambda p: np.array([p[1], p[0]]) / np.sqrt(2)]


def flat_apex(points, a, b, rest, c):
    """Returns the place of c in the plane, to the left of a -> b, which lie at points[a], points[b]."""
    along, side = rest[b] - rest[a], rest[c] - rest[a]
    length = np.linalg.norm(along)
    x, y = side @ along / length, np.linalg.norm(np.cross(along, side)) / length
    t = (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])
    return points[a] + x * t + y * np.array([-t[1], t[0]])


def facet_slope(points, face, surface):
    p, q, r = (points[v] for v in face)
    return np.linalg.solve([q - p, r - p], [surface(q) - surface(p), surface(r) - surface(p)])


def outward(points, a, b):
    t = (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])
    return np.array([t[1], -t[0]])


class Patches:
    """Unfolded patches of triangles. rest: [V, 3] m; faces: [F, 3]; stencils: [H, 4], x0, x1, x2, x3 of the hinges;
    angle: function of the stencils' positions. Hinges whose rest angle exceeds `sharpest` in absolute value are left
    out."""

    def __init__(self, rest, faces, stencils, angle, sharpest=np.inf):
        self.rest, self.faces, self.stencils, self.angle_of = rest, [tuple(f) for f in faces.tolist()], stencils, angle
        self.rest_angle = angle(rest[stencils])
        self.face_at, self.hinge_at = {}, {}
        for face, corners in enumerate(self.faces):
            for a, b in self.sides(corners):
                self.face_at[a, b] = face
        for hinge, (a, b, _, _) in enumerate(stencils.tolist()):
            if abs(self.rest_angle[hinge]) <= sharpest:
                self.hinge_at[a, b] = self.hinge_at[b, a] = hinge

    @staticmethod
    def sides(corners):
        a, b, c = corners
        return (a, b), (b, c), (c, a)

    def laid(self, face):
        """Returns the corners of a face in the plane, with its first side along x."""
        a, b, c = self.faces[face]
        points = {a: np.zeros(2), b: np.array([np.linalg.norm(self.rest[b] - self.rest[a]), 0.0])}
        points[c] = flat_apex(points, a, b, self.rest, c)
        return points

    def unfolded(self, points, a, b):
        """Returns the face beyond the side a -> b of a face at `points`, and its corners in the same plane."""
        face = self.face_at[b, a]
        c = next(v for v in self.faces[face] if v not in (a, b))
        there = {a: points[a], b: points[b]}
        there[c] = flat_apex(there, b, a, self.rest, c)
        return face, there

    def grown(self, patch):
        around = [self.unfolded(points, a, b) for face, points in patch
                  for a, b in self.sides(self.faces[face]) if (a, b) in self.hinge_at]
        inner = {face for face, _ in patch}
        return patch + [(face, points) for face, points in around if face not in inner]

    def bends(self, patch):
        """Returns for every hinge of a patch its angles on the three surfaces, averaged over its unfoldings."""
        found = {}
        for face, points in patch:
            for a, b in self.sides(self.faces[face]):
                if (a, b) not in self.hinge_at:
                    continue
                other, there = self.unfolded(points, a, b)
                normal = outward(points, a, b)
                found.setdefault(self.hinge_at[a, b], []).append([
                    normal @ (facet_slope(there, self.faces[other], w) - facet_slope(points, self.faces[face], w))
                    for w in SURFACES])
        return {hinge: np.mean(views, axis=0) for hinge, views in found.items()}

    @staticmethod
    def square(bends):
        """Returns the bends as columns, [3, n] with n at least 3: columns of zeros replace missing hinges."""
        columns = np.array(list(bends.values())).T
        return np.hstack([columns, np.zeros((3, max(0, 3 - columns.shape[1])))])

    def seen(self, patch, length):
        """Returns bends() of the patch, or of grown(patch) if its hinges do not determine the curvature well."""
        bends = self.bends(patch)
        if not bends or np.linalg.svd(self.square(bends) / length, compute_uv=False)[2] < LEAST_SIGHT:
            bends = self.bends(self.grown(patch))
        return bends

    def corrected(self, bends, weights, target, length):
        """Returns {hinge: weight}: weights with the smallest change that makes the weighted sum of bends equal to the
        target, within the curvatures that the hinges determine."""
        u, s, v = np.linalg.svd(self.square(bends) / length, full_matrices=False)
        missing = u.T @ (target / length - self.square(bends)[:, :len(bends)] / length @ weights)
        inverse = np.array([1 / x if x > LEAST_SIGHT else 0.0 for x in s])
        return dict(zip(bends, weights + (v.T @ (inverse * missing))[:len(bends)]))


class CoupledHinges(Patches):
    def __init__(self, rest, faces, stencils, axes, constants, angle):
        super().__init__(rest, faces, stencils, angle)
        self.shares = [self.shares_of(hinge) for hinge in range(len(stencils))]
        self.terms = [self.terms_of(face, axes[face], constants) for face in range(len(faces))]
        h = constants.thickness**2 / 12
        self.energy_of = lambda curvature: h * constants.membrane(curvature)

    def shares_of(self, hinge):
        """Returns {hinge: weight} of the angle between the facet left of x0 -> x1 and the tangent at the edge."""
        a, b, c, d = self.stencils[hinge].tolist()
        points = self.laid(self.face_at[a, b])
        length = np.linalg.norm(points[b] - points[a])
        other, there = self.unfolded(points, a, b)
        patch = [(self.face_at[a, b], points), (other, there)]
        bends = self.seen(patch, length)
        middle, normal = (points[a] + points[b]) / 2, outward(points, a, b)
        target = np.array([normal @ (slope(middle) - facet_slope(points, self.faces[self.face_at[a, b]], w))
                           for w, slope in zip(SURFACES, SLOPES)])
        near, far = (abs(normal @ (p[v] - points[a])) for p, v in ((points, c), (there, d)))
        weights = np.array([near / (near + far) if other == hinge else 0.0 for other in bends])
        return self.corrected(bends, weights, target, length)

    def terms_of(self, face, axis, constants):
        """Returns the face's area and {hinge: curvature [2, 2] in the material axes for a radian of its angle}."""
        points = self.laid(face)
        a, b, c = self.faces[face]
        first = (self.rest[b] - self.rest[a]) / np.linalg.norm(self.rest[b] - self.rest[a])
        up = np.cross(first, self.rest[c] - self.rest[a])
        axis = np.array([axis @ first, axis @ np.cross(up / np.linalg.norm(up), first)])
        turn = np.array([axis, [-axis[1], axis[0]]])
        area = abs(np.linalg.det([points[b] - points[a], points[c] - points[a]])) / 2
        known, free = {}, []
        for p, q in self.sides(self.faces[face]):
            normal = turn @ outward(points, p, q)
            part = np.linalg.norm(points[q] - points[p]) / area * np.outer(normal, normal)
            hinge = self.hinge_at.get((p, q))
            if hinge is None:
                free.append(part)
                continue
            left = self.stencils[hinge][0] == p
            weights = dict(self.shares[hinge])
            if not left:
                weights = {other: (other == hinge) - weight for other, weight in weights.items()}
            for other, weight in weights.items():
                known[other] = known.get(other, 0) + weight * part

        def product(one, other):  # inner product by the energy's quadratic form
            both, difference = constants.membrane((one + other)[None]), constants.membrane((one - other)[None])
            return float(both[0] - difference[0]) / 4

        if free:
            basis = [np.array(b, dtype=float) for b in ([[1, 0], [0, 0]], [[0, 0], [0, 1]], [[0, 1], [1, 0]])]
            root = np.linalg.cholesky([[product(i, j) for j in basis] for i in basis]).T
            coordinates = lambda part: root @ [part[0, 0], part[1, 1], part[0, 1]]
            columns = np.array([coordinates(part) for part in free]).T
            for other, part in known.items():
                bend = np.linalg.lstsq(columns, coordinates(part), rcond=None)[0]
                known[other] = part - sum(x * i for x, i in zip(bend, free))
        return area, known

    def changes(self, x):
        change = self.angle_of(x[self.stencils]) - self.rest_angle
        return change - 2 * np.pi * np.round(change / (2 * np.pi))

    def energy_and_moments(self, x):
        """Returns the energy of each face, and for each hinge the derivative by its angle and the sum of the absolute
        values of its terms."""
        changes, energies = self.changes(x), []
        moments, sizes = np.zeros(len(changes)), np.zeros(len(changes))
        for area, terms in self.terms:
            bent = sum((changes[hinge] * part for hinge, part in terms.items()), np.zeros((2, 2)))
            energies.append(area * float(self.energy_of(bent[None])[0]))
            for hinge, part in terms.items():
                both = self.energy_of(np.array([bent + part, bent - part]))
                moments[hinge] += area * float(both[0] - both[1]) / 2
                sizes[hinge] += area * abs(float(both[0] - both[1])) / 2
        return energies, moments, sizes


class Arcs(Patches):
    """Membrane triangles whose sides are arcs. Unknowns of a face are its corners and, as a fourth row, the curvatures
    along the sides opposite to them: [F, 4, 3], real or complex."""

    def __init__(self, rest, faces, stencils, axes, constants, angle):
        super().__init__(rest, faces, stencils, angle, sharpest=np.pi / 4)
        self.corners, self.constants = faces, constants
        self.weights = [[self.weights_of(face, a, b) for a, b in ((q, r), (r, p), (p, q))]
                        for face, (p, q, r) in enumerate(self.faces)]
        sides, others = self.sides_of(rest[faces]), np.cross(axes, np.cross(axes, self.sides_of(rest[faces])[:, 0]))
        others = -others / np.linalg.norm(others, axis=1)[:, None]
        u, v = (np.sum(sides * frame[:, None], axis=-1) for frame in (axes, others))
        self.squares_of_strain = 2 * np.stack([u * u, v * v, 2 * u * v], axis=-1)  # coefficients of E00, E11, E01
        self.areas = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
        self.rest_squares = np.sum(sides**2, axis=-1)
        self.at_rest = self.unknowns(rest)

    @staticmethod
    def sides_of(x):
        return np.stack([x[:, 2] - x[:, 1], x[:, 0] - x[:, 2], x[:, 1] - x[:, 0]], axis=1)

    def weights_of(self, face, a, b):
        """Returns {hinge: weight} of the curvature along a side."""
        points = self.laid(face)
        length = np.linalg.norm(points[b] - points[a])
        patch = [(face, points)] + ([self.unfolded(points, a, b)] if (a, b) in self.hinge_at else [])
        bends = self.seen(patch, length)
        t = (points[b] - points[a]) / length
        target = np.array([t[0] ** 2, t[1] ** 2, np.sqrt(2) * t[0] * t[1]])
        return self.corrected(bends, np.zeros(len(bends)), target, length) if bends else {}

    def unknowns(self, x):
        angles = self.angle_of(x[self.stencils])
        bent = np.array([[sum(w * angles[hinge] for hinge, w in side.items()) for side in sides]
                         for sides in self.weights], dtype=float)
        return np.concatenate([x[self.corners], bent[:, None]], axis=1)

    def squares(self, y):
        return np.sum(self.sides_of(y[:, :3]) ** 2, axis=-1) * (1 + self.rest_squares * y[:, 3] ** 2 / 12)

    def energy(self, y):
        """Returns the energy of each face."""
        strain = np.linalg.solve(self.squares_of_strain, (self.squares(y) - self.squares(self.at_rest))[..., None])
        e00, e11, e01 = np.moveaxis(strain[..., 0], 1, 0)
        tensor = np.stack([np.stack([e00, e01], axis=-1), np.stack([e01, e11], axis=-1)], axis=1)
        return self.areas * self.constants.membrane(tensor)

    def moments(self, by_curvature):
        """Returns for each hinge the derivative by its angle and the sum of the absolute values of its terms."""
        moments, sizes = np.zeros(len(self.stencils)), np.zeros(len(self.stencils))
        for slopes, sides in zip(by_curvature, self.weights):
            for slope, weights in zip(slopes, sides):
                for hinge, weight in weights.items():
                    moments[hinge] += slope * weight
                    sizes[hinge] += abs(slope * weight)
        return moments, sizes
