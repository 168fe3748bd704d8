# SPDX-License-Identifier: GPL-3.0-or-later
"""check_recording.py RUN.h5 [SUMMARY.json]

Reads a recording with h5py and numpy alone and checks the statements of docs/recording.md about it. Writes the data
that ParaView should find in each frame to SUMMARY.json, for check_paraview.py."""

import json
import sys

import h5py
import numpy as np


def extremes(values):
    return [float(np.min(values)), float(np.max(values))]


def check_units(name, item):
    if isinstance(item, h5py.Dataset) and name not in ("scene", "rest/sheet_names", "obstacles/names"):
        assert isinstance(item.attrs["unit"], str) and item.attrs["unit"], f"{name} has no unit"


def check_head(file):
    assert file.attrs["format"] == "sherd recording"
    assert file.attrs["format_version"] == 4
    assert file.attrs["sherd_version"]
    assert file.attrs["wall_seconds"] >= 0
    assert file.attrs["end"] and file.attrs["scene_file"]
    int(file.attrs["seed"])
    assert isinstance(file["scene"][()], bytes) and file["scene"].asstr()[()]
    faces = file["rest/faces"].shape[0]
    assert file["rest/area"].shape == (faces,) and np.all(file["rest/area"][:] > 0)
    assert file["rest/thickness"].shape == (faces,) and np.all(file["rest/thickness"][:] > 0)
    file.visititems(check_units)


def check_tables(file):
    kinds = ("failure", "opening", "split", "fragment", "vertex_birth", "face_birth")
    for group in ("steps", "tips", *(f"events/{kind}" for kind in kinds)):
        rows = {column.shape[0] for column in file[group].values() if isinstance(column, h5py.Dataset)}
        assert len(rows) == 1, f"the columns of {group} differ in length: {rows}"
    reactions = file.get("steps/reaction", {})
    for support in reactions.values():
        assert support.attrs["name"] and support.attrs["kind"] in ("pin", "clamp", "symmetry", "obstacle")
        for column in ("force", "moment"):
            assert support[column].shape == (len(file["steps/step"]), 3)
            assert np.all(np.isfinite(support[column][:]))
    if "obstacle.floor" in reactions:
        assert np.max(reactions["obstacle.floor/force"][:, 2]) > 0
    assert np.all(np.diff(file["steps/step"][:]) == 1)
    assert np.all(np.diff(file["steps/time"][:]) > 0)
    for group in kinds:
        assert np.all(np.diff(file[f"events/{group}/time"][:]) >= 0)
    check_tips(file["tips"])


def check_tips(tips):
    assert np.all(np.diff(tips["step"][:]) >= 0)
    assert len(np.unique(np.stack([tips["step"][:], tips["tip"][:]]), axis=1).T) == len(tips["tip"]), "twice in a step"
    assert np.allclose(np.linalg.norm(tips["direction"][:], axis=1), 1, rtol=0, atol=1e-9)
    assert np.all(tips["G"][:] >= 0) and np.all(tips["G_c"][:] > 0) and np.all(tips["speed"][:] >= 0)


def check_modes(file):
    """Checks that mode shapes are orthonormal by mass, and that frames show their step's mode as a sine in time."""
    assert "not physical" in file.attrs["times"]
    frequency, growth, shape = (file["modes"][name][:] for name in ("frequency", "growth", "shape"))
    assert shape.shape == (len(frequency), len(file["rest/position"]), 3) and growth.shape == frequency.shape
    assert np.all(np.diff(frequency) >= 0) and not np.any((frequency > 0) & (growth > 0))
    frames = [file["frames"][name] for name in sorted(file["frames"])]
    mass = frames[0]["vertex/mass"][:]
    assert np.allclose(np.einsum("v,ivx,jvx->ij", mass, shape, shape), np.eye(len(shape)), atol=1e-7)
    largest = np.linalg.norm(shape, axis=2).max(axis=1)
    box = np.ptp(file["rest/position"][:], axis=0)
    for frame in frames:
        mode, time = frame.attrs["step"], frame.attrs["time"]
        assert mode - 1 <= time <= mode
        shown = 0.05 * np.linalg.norm(box) / largest[mode - 1] * shape[mode - 1]
        angle = 2 * np.pi * time
        moved = frame["vertex/position"][:] - file["rest/position"][:]
        assert np.allclose(moved, np.sin(angle) * shown, rtol=0, atol=1e-9 * np.abs(shown).max())
        assert np.allclose(frame["vertex/velocity"][:], 2 * np.pi * np.cos(angle) * shown, rtol=0, atol=1e-9)
    assert [frame.attrs["step"] for frame in frames] == sorted(frame.attrs["step"] for frame in frames)


def edge_face_counts(faces):
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    return dict(zip(map(tuple, *np.unique(sides, axis=0)[None]), np.unique(sides, axis=0, return_counts=True)[1]))


def check_obstacles(file, frame):
    if "obstacles" not in file:
        assert "obstacle" not in frame
        return
    count = len(file["obstacles/names"])
    assert file["obstacles/plane"].shape == (count,)
    for i in range(count):
        surface = file[f"obstacles/{i}"]
        assert 0 <= surface["face"][:].min() and surface["face"][:].max() < len(surface["position"])
    rotation = poses_of(frame)[:, :, :3]
    assert np.allclose(rotation @ rotation.transpose(0, 2, 1), np.eye(3))


def poses_of(frame):
    return frame["obstacle/pose"][:].reshape(-1, 3, 4)


def check_places(file, frames):
    """Checks that a frame has the points of those obstacles whose pose differs from the one in the frame before, in the
    first frame from the identity."""
    if "obstacles" not in file:
        return
    before = [np.eye(3, 4)] * len(file["obstacles/names"])
    for frame in frames:
        for i, pose in enumerate(poses_of(frame)):
            assert (f"obstacle/{i}" in frame) == (not np.array_equal(pose, before[i])), (frame.name, i)
            if f"obstacle/{i}" in frame:
                placed = frame[f"obstacle/{i}/position"][:]
                assert np.allclose(placed, places_of(file, frame, i), rtol=0, atol=1e-12 * (1 + np.abs(placed).max()))
        before = poses_of(frame)


def places_of(file, frame, i):
    pose = poses_of(frame)[i]
    return file[f"obstacles/{i}/position"][:] @ pose[:, :3].T + pose[:, 3]


def obstacle_summary(file, frame):
    """Returns name, triangles and points (m) of each obstacle in a frame."""
    if "obstacles" not in file:
        return []
    return [
        {"name": name, "face": file[f"obstacles/{i}/face"][:].tolist(), "points": places_of(file, frame, i).tolist()}
        for i, name in enumerate(file["obstacles/names"].asstr()[:])
    ]


def check_links(file):
    """Checks that a run that changes no face writes no rest mesh but /rest."""
    mixed = any("face_mixed" in frame["rest"] for frame in file["frames"].values())
    if not mixed and not len(file["events/face_birth/created"]) and not len(file["events/vertex_birth/created"]):
        links = [frame.get("rest", getlink=True) for frame in file["frames"].values()]
        assert all(isinstance(link, h5py.SoftLink) and link.path == "/rest" for link in links)


def check_rest(file, rest, faces):
    """Checks the rest mesh of a frame. faces: the frame's faces, with original vertices in place of their copies."""
    assert np.array_equal(faces, rest["faces"][:])
    assert rest["area"].shape == rest["thickness"].shape == rest["face_parent"].shape == (len(faces),)
    parents, weights = rest["vertex_parents"][:], rest["vertex_weights"][:]
    assert np.allclose(weights.sum(axis=1), 1, rtol=0, atol=1e-12) and weights.min() >= 0
    places = np.einsum("vi,vix->vx", weights, file["rest/position"][:][parents])
    if "face_mixed" not in rest or np.ptp(rest["position"][:], axis=0).min() == 0:  # new faces are chords of a tube
        assert np.allclose(places, rest["position"][:], rtol=0, atol=1e-12), "vertices are not where their parents say"
    shares = np.bincount(rest["face_parent"][:], rest["area"][:], len(file["rest/area"]))
    if "face_mixed" not in rest:
        assert np.allclose(shares, file["rest/area"][:], rtol=1e-9), "the parts of a face are not all of it"
        return
    mixed, flat = rest["face_mixed"][:], np.ptp(rest["position"][:], axis=0).min() == 0
    assert mixed.shape == (len(faces),) and set(mixed) <= {0, 1} and np.any(mixed)
    assert not flat or np.isclose(shares.sum(), file["rest/area"][:].sum(), rtol=1e-9), "faces are not all of the sheet"


def check_held(edge):
    """Checks `held`, which only frames with cohesive forces at failed edges have."""
    if "held" not in edge:
        return
    held = edge["held"][:]
    assert held.shape == edge["state"].shape and np.all(held >= 0) and np.all(held <= 1) and np.any(held > 0)
    assert np.all(edge["state"][:][held > 0] != 0), "an unbroken edge opens"


def check_frame(file, frame):
    vertices = frame["vertex/position"].shape[0]
    faces, edges = frame["face/vertices"][:], frame["edge/vertices"][:]
    check_obstacles(file, frame)
    assert frame["vertex/position"].shape == frame["vertex/velocity"].shape == (vertices, 3)
    for name in ("speed", "mass", "original"):
        assert frame["vertex"][name].shape == (vertices,)
    assert frame["face/fragment"].shape == frame["face/sheet"].shape == (len(faces),)
    assert frame["edge/state"].shape == frame["edge/strain"].shape == (len(edges),)
    check_held(frame["edge"])
    speed = np.linalg.norm(frame["vertex/velocity"][:], axis=1)
    assert np.allclose(speed, frame["vertex/speed"][:], rtol=1e-14, atol=0)
    assert np.array_equal(np.unique(faces), np.arange(vertices)), "a vertex without a face"
    # A face keeps its corners, except that copies replace split vertices.
    check_rest(file, frame["rest"], frame["vertex/original"][:][faces])
    fragments = np.unique(frame["face/fragment"][:])
    assert np.array_equal(fragments, np.arange(len(fragments))), "fragments are not numbered from 0"
    counts = edge_face_counts(faces)
    assert len(counts) == len(edges) and set(map(tuple, np.sort(edges, axis=1))) == set(counts)
    open_edges = np.array([counts[tuple(sorted(edge))] == 1 for edge in edges.tolist()])
    assert np.array_equal(frame["edge/state"][:] == 2, open_edges), "state 2 is not the boundary"
    assert np.all(frame["edge/strain"][:][open_edges] == 0)


FIELDS = ("curvature", "membrane_strain", "stress_top", "stress_bottom")


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def axes_of(points):
    """Returns axes [F, 2, 3] of faces: along the first side, and perpendicular to it. points: [F, 3, 3]."""
    first = unit(points[:, 1] - points[:, 0])
    normal = unit(np.cross(first, points[:, 2] - points[:, 0]))
    return np.stack([first, np.cross(normal, first)], axis=1)


def green_strain(rest, now):
    """Returns the strain of triangles [F, 3, 3]: (F^T F - 1) / 2 in the axes at rest, 00, 11 and 2 * 01."""
    local = np.einsum("fax,fcx->fac", axes_of(rest), rest[:, 1:] - rest[:, :1])
    slope = np.einsum("fcx,fca->fxa", now[:, 1:] - now[:, :1], np.linalg.inv(local))
    strain = (np.einsum("fxa,fxb->fab", slope, slope) - np.eye(2)) / 2
    return np.stack([strain[:, 0, 0], strain[:, 1, 1], 2 * strain[:, 0, 1]], axis=1)


def check_fields(frame):
    """Checks the fields of faces, for isotropic sheets."""
    face, corners = frame["face"], frame["face/vertices"][:]
    now, rest = frame["vertex/position"][:][corners], frame["rest/position"][:][frame["rest/faces"][:]]
    assert np.allclose(face["axes"][:].reshape(-1, 2, 3), axes_of(now), rtol=0, atol=1e-12)
    assert np.allclose(face["membrane_strain"][:], green_strain(rest, now), rtol=0, atol=1e-10)
    for name in FIELDS:
        values = face[name][:]
        tensor = (values / [1, 1, 1 if name.startswith("stress") else 2])[:, [0, 2, 2, 1]].reshape(-1, 2, 2)
        size = np.abs(values).max() + 1e-300
        assert np.allclose(face[f"{name}_principal"][:][:, ::-1], np.linalg.eigvalsh(tensor), rtol=0, atol=1e-12 * size)
    # In plane stress the traces of stress and strain are proportional, and so are the shears. Bending towards the
    # normal compresses the top.
    half = frame["rest/thickness"][:][:, None] / 2
    strain = np.concatenate([face["membrane_strain"][:] - side * half * face["curvature"][:] for side in (1, -1)])
    stress = np.concatenate([face["stress_top"][:], face["stress_bottom"][:]])
    for got, cause in ((stress[:, 0] + stress[:, 1], strain[:, 0] + strain[:, 1]), (stress[:, 2], strain[:, 2])):
        modulus = cause @ got / (cause @ cause) if np.any(cause) else 1
        assert modulus > 0 and np.allclose(got, modulus * cause, rtol=0, atol=1e-9 * np.abs(got).max())


def summary(frame):
    fields = [name for name in FIELDS if name in frame["face"]]
    return {
        "time": float(frame.attrs["time"]),
        "points": frame["vertex/position"].shape[0],
        "surface": {
            "cells": frame["face/vertices"].shape[0],
            "cell": {
                **{name: extremes(frame["face"][name]) for name in ("fragment", "sheet")},
                **{name: extremes(frame["face"][name][:, 2]) for name in fields},
                **{f"{name}_principal": extremes(frame["face"][f"{name}_principal"][:, 1]) for name in fields},
            },
            "point": {"speed": extremes(frame["vertex/speed"]), "velocity": extremes(frame["vertex/velocity"][:, 2])},
        },
        "edges": {
            "cells": frame["edge/vertices"].shape[0],
            "cell": {name: extremes(frame["edge"][name]) for name in ("state", "strain")},
            "point": {},
        },
    }


def main():
    with h5py.File(sys.argv[1], "r") as file:
        check_head(file)
        (check_modes if "modes" in file else check_tables)(file)
        check_links(file)
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        for frame in frames:
            check_frame(file, frame)
            if "axes" in frame["face"]:
                check_fields(frame)
        check_places(file, frames)
        result = [{**summary(frame), "obstacles": obstacle_summary(file, frame)} for frame in frames]
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", encoding="utf-8") as out:
            json.dump(result, out)
    print(f"{len(result)} frames are as they should be")


main()
