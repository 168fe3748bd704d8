# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the recording of a random impact, and checks it frame by frame with blow_check.py."""
import collections

import h5py
import numpy

import blow_check

LOOKS = 8  # times in a frame at which places of points are evaluated
FELT = 0.02  # change of velocity over the impact's speed, above which an impact has an effect
MISSED = 0.2  # change of velocity over that with finer steps, below which the impact was missed
INSIDE = 0.5  # solid angle of a solid over the full sphere, above which the point is inside


class Seen:
    """Findings of a recording, as text. passed: certain failures, namely points on the other side of a sheet with known
    sides, edges that intersect faces, vertices in solids; crossed: crossings between two frames; deep: those farther
    from all boundaries than anything moved in the frame. shoved: changes (m/s) of the mean velocity of the struck
    sheet, and of the free body or sheet that strikes."""

    def __init__(self, blow, recording):
        self.blow, self.passed, self.deep, self.crossed = blow, [], [], []
        with h5py.File(recording) as file:
            frames = [file["frames"][name] for name in sorted(file["frames"])]
            self.names = [name.decode() for name in file["obstacles/names"][:]] if "obstacles" in file else []
            self.sheets = [name.decode() for name in file["rest/sheet_names"][:]]
            faces, sheet = frames[0]["face/vertices"][:], frames[0]["face/sheet"][:]
            self.vertices = [numpy.unique(faces[sheet == i]) for i in range(len(self.sheets))]
            self.faces = [numpy.searchsorted(used, faces[sheet == i]) for i, used in enumerate(self.vertices)]
            self.positions = [frame["vertex/position"][:] for frame in frames]
            self.times = [frame.attrs["time"] for frame in frames]
            self.poses = [frame["obstacle/pose"][:].reshape(-1, 3, 4) if self.names else None for frame in frames]
            self.shoved = self.shove(frames)
        self.sides = None
        for k in range(len(self.times) - 1):
            self.look(k)

    def shove(self, frames):
        """Returns the largest changes of velocity in any frame, because pinned sheets swing back."""
        if len(frames) < 2:
            return numpy.zeros(2)
        return numpy.array([self.shove_of_sheet(frames, 0), self.shove_of_striker(frames)])

    def shove_of_sheet(self, frames, i):
        used, mass = self.vertices[i], frames[0]["vertex/mass"][:][self.vertices[i], None]
        velocity = [(frame["vertex/velocity"][:][used] * mass).sum(axis=0) / mass.sum() for frame in frames]
        return numpy.linalg.norm(numpy.array(velocity) - velocity[0], axis=1).max()

    def shove_of_striker(self, frames):
        bodies = [name for name in self.blow.solids if name not in self.blow.turns]
        if not bodies:
            return self.shove_of_sheet(frames, 1) if len(self.sheets) > 1 else 0
        place = numpy.array([pose[self.names.index(bodies[0])][:, 3] for pose in self.poses])
        velocity = numpy.diff(place, axis=0) / numpy.diff(self.times)[:, None]
        return numpy.linalg.norm(velocity - velocity[0], axis=1).max()

    def body(self, name, solid, k):
        corner, faces = solid
        middle = corner.mean(axis=0)
        corner = middle + blow_check.SHRUNK * (corner - middle)
        if name in self.blow.turns:
            motion = blow_check.KeyedMotion(corner, self.blow.turns[name], self.times[k], self.times[k + 1])
        else:
            first, begin, end = [self.poses[i][self.names.index(name)] for i in (0, k, k + 1)]
            turned = [pose[:, :3] @ first[:, :3].T for pose in (begin, end)]
            poses = [(matrix, pose[:, 3] - matrix @ first[:, 3]) for matrix, pose in zip(turned, (begin, end))]
            motion = blow_check.BodyMotion(corner, *poses)
        return blow_check.Surface(name, motion, faces, False)

    def surfaces(self, k):
        """Returns all sheets and solids with their motions between the frames k and k + 1."""
        found = []
        for name, used, faces in zip(self.sheets, self.vertices, self.faces):
            motion = blow_check.SheetMotion(self.positions[k][used], self.positions[k + 1][used])
            found.append(blow_check.Surface(name, motion, faces, True))
        return found + [self.body(name, solid, k) for name, solid in self.blow.solids.items()]

    def look(self, k):
        moving = self.surfaces(k)
        for i, one in enumerate(moving):
            for other in moving[i:]:
                if one.is_sheet:
                    self.look_at_pair(k, one, other)
        if self.blow.struck:
            self.look_at_sides(k, moving)

    def look_at_pair(self, k, one, other):
        where = f"frame {k + 1}: {one.name} and {other.name}"
        count = blow_check.standing_crossings(one, other, 1)
        if count:
            self.passed.append(f"{where}: {count} edges stand in faces")
        if not other.is_sheet:
            within = blow_check.solid_angles(one.motion.at(1), other.motion.at(1), other.faces) / (4 * numpy.pi)
            if (numpy.abs(within) > INSIDE).any():
                self.passed.append(f"{where}: {(numpy.abs(within) > INSIDE).sum()} vertices are in the solid")
        if self.blow.border in ("closed", "large") and one is not other:
            return  # look_at_sides() decides
        found = blow_check.crossings_of(one, other)
        if found:
            moved = blow_check.largest_motion(one, other)
            self.crossed.append(f"{where}: {len(found)} crossings")
            deep = [crossing.depth for crossing in found if crossing.depth > moved]
            if deep:
                self.deep.append(f"{where}: {len(deep)} crossings up to {max(deep):.3g} m from the rim, "
                                 f"all moved up to {moved:.3g} m")

    def look_at_sides(self, k, moving):
        target, striker = next(s for s in moving if s.name == self.blow.struck), self.striker(moving)
        if self.sides is None:
            self.sides = blow_check.Sides(self.blow.border, target, self.points(striker, 0))
        known = numpy.ones(len(self.sides.points), bool)
        known[:-1] = striker.motion.is_known
        ways = [self.points(striker, time) for time in numpy.linspace(0, 1, LOOKS + 1)[1:]]
        beyond = self.sides.step(ways, target.motion.at(1), known)
        if beyond.any():
            self.passed.append(f"frame {k + 1}: {beyond.sum()} of {len(beyond)} points of {striker.name} are on the "
                               f"other side")

    @staticmethod
    def points(striker, time):
        """Returns the striker's vertices; for a solid followed by its middle."""
        corner = striker.motion.at(time)
        return corner if striker.is_sheet else numpy.vstack([corner, corner.mean(axis=0)])

    def striker(self, moving):
        return next((s for s in moving if s.name != self.blow.struck), moving[0])

    def shows_less_than(self, finer):
        """Returns whether this run has hardly any of the effect that the run with finer steps has."""
        felt = finer.shoved > FELT * self.blow.speed
        return bool(felt.any() and (self.shoved < MISSED * finer.shoved)[felt].all())

    def words(self):
        lines = (self.passed or self.deep or self.crossed)
        kinds = collections.Counter(line.split(": ", 1)[1] for line in lines)
        return "; ".join(lines[:2]) + (f" and {len(lines) - 2} more" if len(kinds) > 2 else "")
