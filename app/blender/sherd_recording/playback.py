# SPDX-License-Identifier: GPL-3.0-or-later
"""States of a recording at any time, interpolated between its frames. Does not depend on Blender."""

import math
from bisect import bisect_right

import numpy as np

NEAR = 1e-6  # share of the time between two frames that counts as round-off
NEWEST = 4  # version of the recording's format


def frame_names(file):
    if file.attrs.get("format") != "sherd recording":
        raise ValueError(f"{file.filename} is not a recording of sherd")
    if file.attrs["format_version"] > NEWEST:
        raise ValueError(f"{file.filename} was written by a newer sherd; use the player that came with it")
    return sorted(file["frames"])


def default_slowdown(seconds):
    """Returns the smallest of 1, 2, 5, 10, 20, ... with which a run of `seconds` plays for at least 4 s."""
    factor, digits = 1.0, (2, 2.5, 2)
    for step in range(300):
        if not 0 < seconds * factor < 4 * (1 - 1e-9):
            break
        factor *= digits[step % 3]
    return factor if seconds > 0 else 1.0


def run_times(frames, names):
    """Returns the times (s) of the first and the last frame."""
    return frames[names[0]].attrs["time"], frames[names[-1]].attrs["time"]


def position_at(frames, names, time):
    """Returns the position of a time (s) in the recording: the number of a frame, or a number between two."""
    number = max(0, bisect_right(names, time, key=lambda name: frames[name].attrs["time"]) - 1)
    if number + 1 == len(names):
        return float(number)
    start, end = (frames[name].attrs["time"] for name in names[number : number + 2])
    share = max(0.0, (time - start) / (end - start))
    return number + (0.0 if share < NEAR else 1.0 if share > 1 - NEAR else share)


def face_strain(frame):
    """Returns the largest absolute strain of each face's edges, [F] 1/m."""
    faces, edges = frame["face/vertices"][:].astype(np.int64), frame["edge/vertices"][:].astype(np.int64)
    count = frame["vertex/position"].shape[0]

    def keys(ends):
        return ends.min(axis=1) * count + ends.max(axis=1)

    order = np.argsort(keys(edges))
    known, strain = keys(edges)[order], np.abs(frame["edge/strain"][:])[order]
    sides = [strain[np.searchsorted(known, keys(faces[:, side]))] for side in ([0, 1], [1, 2], [2, 0])]
    return np.maximum.reduce(sides)


def recorded(frame):
    """Reads the displayed data of a frame: its mesh and fields, the rest mesh (rest_of()) and the look (look_of())."""
    return {
        "rest": rest_of(frame),
        "look": look_of(rest_group(frame), frame.file["rest"]),
        "faces": frame["face/vertices"][:],
        "fragment": frame["face/fragment"][:],
        "strain": face_strain(frame),
        "position": frame["vertex/position"][:],
        "velocity": frame["vertex/velocity"][:],
        "original": frame["vertex/original"][:],
    }


def rest_group(frame):
    return frame["rest"] if "rest" in frame else frame.file["rest"]  # older recordings: faces do not change


def rest_of(frame):
    """Reads the rest mesh of a frame: positions (m), corners of faces, the parent of each face in the unfractured mesh,
    and whether any face has parts of several parents."""
    rest = rest_group(frame)
    faces = rest["faces"][:]
    return {
        "position": rest["position"][:],
        "faces": faces,
        "parent": rest["face_parent"][:] if "face_parent" in rest else np.arange(len(faces)),
        "mixed": "face_mixed" in rest,
    }


def materials_of(rest):
    """Reads names and definitions (lines of .mtl) of the materials of a rest mesh."""
    if "surface_material" not in rest:
        return []
    texts = (rest[f"surface_material_{part}"].asstr()[:] for part in ("names", "definitions"))
    return list(zip(*texts))


def look_of(rest, unbroken):
    """Reads the look of a frame. rest: the frame's rest group; unbroken: the recording's. Slots are the recording's
    materials in their order, followed by one for faces without a material. texture: [F, 3, 2]; slot: [F]; colour:
    [F, 3, 4] of corners, sRGB, 0 to 1; None where the recording has no such data."""
    look = {"texture": None, "slot": None, "colour": None}
    if "texture" in rest:
        look["texture"] = rest["texture"][:].reshape(-1, 3, 2)
    slots = materials_of(unbroken)
    if slots:
        row = [slots.index(material) for material in materials_of(rest)] + [len(slots)]  # the last is row -1
        look["slot"] = np.array(row)[rest["surface_material"][:]]
    if "vertex_colour" in rest:
        look["colour"] = rest["vertex_colour"][:][rest["faces"][:]] / 255
    elif "face_colour" in rest:
        look["colour"] = np.repeat(rest["face_colour"][:][:, None], 3, axis=1) / 255
    return look


def coordinates(rest, faces, point):
    """Returns the barycentric coordinates of a point, projected into the planes of rest faces, [N, 3]; NaN for a face
    without area."""
    corners = rest["position"][rest["faces"][faces]]
    first, second, way = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], point - corners[:, 0]
    normal = np.cross(first, second)
    size = (normal * normal).sum(axis=1)
    size[size == 0] = np.nan  # a face without area
    to_second = (np.cross(way, second) * normal).sum(axis=1) / size
    to_third = (np.cross(first, way) * normal).sum(axis=1) / size
    return np.column_stack([1 - to_second - to_third, to_second, to_third])


def deepest(rest, faces, point):
    """Returns the face in which the smallest barycentric coordinate of a point is largest, so the face in which the
    point lies if there is one, and its barycentric coordinates there."""
    places = coordinates(rest, faces, point)
    best = np.nan_to_num(places.min(axis=1), nan=-np.inf).argmax()
    return faces[best], places[best]


class Births:
    """Locates changed parts of the later frame's mesh in the earlier one: faces and vertices that were split, inserted,
    moved or flipped lie in the plane of the earlier face that contains the middle of the face, or around it."""

    def __init__(self, earlier, later):
        self.earlier, self.later = earlier, later
        self.old, self.new = earlier["rest"], later["rest"]
        self.any_mixed = self.old["mixed"] or self.new["mixed"]
        count = min(len(self.old["position"]), len(self.new["position"]))
        self.stays = np.zeros(len(self.new["position"]), bool)  # [V] whether the rest position is the same
        self.stays[:count] = (self.old["position"][:count] == self.new["position"][:count]).all(axis=1)

    def unchanged(self):
        """Returns for each face of the earlier frame whether the later frame has it unchanged."""
        old, new = self.old["faces"], self.new["faces"][: len(self.old["faces"])]
        return (old == new).all(axis=1) & self.stays[new].all(axis=1)

    def around(self, vertices):
        """Returns the earlier faces that have a corner in `vertices`, vertices of the rest mesh."""
        return np.flatnonzero(np.isin(self.old["faces"], vertices).any(axis=1))

    def whole_of(self, face):
        parts = np.flatnonzero(self.old["parent"] == self.new["parent"][face])
        corners = self.new["faces"][face]
        if self.any_mixed:
            parts = np.union1d(parts, self.around(corners))
        return deepest(self.old, parts, self.new["position"][corners].mean(axis=0))[0]

    def same_vertex(self, vertex, whole):
        """Returns the earlier vertex for a rest vertex at the earlier face `whole`; None if it has moved, or has
        several copies none of which is a corner of that face."""
        if not self.stays[vertex]:
            return None
        at = np.flatnonzero(self.old["faces"][whole] == vertex)
        if len(at):
            return self.earlier["faces"][whole][at[0]]
        copies = np.flatnonzero(self.earlier["original"] == vertex)
        return copies[0] if len(copies) == 1 else None

    def place(self, vertex, whole):
        point = self.new["position"][vertex]
        candidates = np.array([whole])
        if self.any_mixed and coordinates(self.old, candidates, point).min() < -1e-9:
            near = self.around(self.old["faces"][whole])
            fragment = self.earlier["fragment"]
            candidates = np.append(candidates, near[fragment[near] == fragment[whole]])
        return deepest(self.old, candidates, point)


def ancestry(earlier, later):
    """Locates the later frame's mesh in the earlier one. Returns for each vertex three earlier vertices and their
    weights, and for each face the earlier face that it was, or was a part of. Faces keep their corners, which shows
    the vertices that cracks have split."""
    births = Births(earlier, later)
    count, faces = len(earlier["faces"]), later["faces"]
    before = np.minimum(np.arange(len(later["position"])), len(earlier["position"]) - 1)
    vertices, shares = np.repeat(before[:, None], 3, axis=1), np.tile((1.0, 0.0, 0.0), (len(before), 1))
    wholes = np.arange(len(faces))
    same = births.unchanged()
    vertices[faces[:count][same].ravel()] = earlier["faces"][same].ravel()[:, None]
    for face in np.append(np.flatnonzero(~same), np.arange(count, len(faces))):
        whole = wholes[face] = births.whole_of(face)
        for corner, vertex in enumerate(faces[face]):
            at_rest = births.new["faces"][face, corner]
            known = births.same_vertex(at_rest, whole)
            if known is not None:
                vertices[vertex], shares[vertex] = known, (1, 0, 0)
            else:
                of, shares[vertex] = births.place(at_rest, whole)
                vertices[vertex] = earlier["faces"][of]
    return vertices, shares, wholes


def between(earlier, later, share):
    """Returns the mesh and look of the later frame with interpolated positions: a vertex that a crack made in between
    starts where it was in the earlier mesh. Fragments are the earlier frame's until the later one is reached."""
    vertices, shares, wholes = ancestry(earlier, later)
    shown = {**later, "fragment": earlier["fragment"][wholes]}
    for name, start in (
        ("position", np.einsum("vi,vix->vx", shares, earlier["position"][vertices])),
        ("velocity", np.einsum("vi,vix->vx", shares, earlier["velocity"][vertices])),
        ("strain", earlier["strain"][wholes]),
    ):
        shown[name] = start + share * (later[name] - start)
    return shown


def state_at(frames, names, position):
    number = int(position)
    state = recorded(frames[names[number]])
    if position == number:
        return state
    return between(state, recorded(frames[names[number + 1]]), position - number)


def turned(earlier, later, share):
    """Returns the rotation [3, 3] between two others, by the smaller angle at constant speed."""
    way = later @ earlier.T
    twist = np.array([way[2, 1] - way[1, 2], way[0, 2] - way[2, 0], way[1, 0] - way[0, 1]])
    size = np.linalg.norm(twist)  # 2 sin(angle): nearly 0 for half a turn and for a tiny one
    angle = share * math.atan2(size, np.trace(way) - 1)
    axis = np.linalg.eigh(way + way.T + np.outer(twist, twist) / max(size, 1e-300))[1][:, -1]
    x, y, z = axis if axis @ twist >= 0 else -axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return (np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross) @ earlier


def between_poses(earlier, later, share, middle):
    """Returns the pose [3, 4] of an obstacle between two others; its middle (m, in its own frame) moves straight."""
    rotation = turned(earlier[:, :3], later[:, :3], share)
    start, end = (pose[:, :3] @ middle + pose[:, 3] for pose in (earlier, later))
    return np.column_stack([rotation, start + share * (end - start) - rotation @ middle])


def poses_at(frames, names, position, middles):
    """Returns the poses of obstacles and bodies, from their own frames to space, [O, 3, 4]."""
    number, share = int(position), position % 1
    earlier, later = (frames[names[i]]["obstacle/pose"][:].reshape(-1, 3, 4) for i in (number, math.ceil(position)))
    if share == 0:
        return earlier
    return np.array([between_poses(*both, share, middle) for *both, middle in zip(earlier, later, middles)])


def points_at(frames, names, position, number):
    """Returns the points of an obstacle that deforms, in space, [P, 3] m."""
    earlier, later = (frames[names[i]][f"obstacle/{number}/position"][:] for i in (int(position), math.ceil(position)))
    return earlier + position % 1 * (later - earlier)
