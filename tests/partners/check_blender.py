# SPDX-License-Identifier: GPL-3.0-or-later
"""blender -b --factory-startup --python-exit-code 1 --python check_blender.py -- RUN.h5 FOLDER BLENDER

Opens in Blender what `sherd export` wrote into FOLDER (export_all.py) and what the player in BLENDER (app/blender) plays, and
compares every frame with the recording."""

import os
import runpy
import sys

import bpy
import h5py
import numpy as np

RECORDING, FOLDER, BLENDER = sys.argv[sys.argv.index("--") + 1 :]
sys.path.insert(0, BLENDER)
import sherd_recording  # noqa: E402

NEAR = 1e-6  # m, single precision for decimetres
SLOW = 250  # slowdown, as in export_all.py
STEP = 6  # Blender's frames, 24 a second, between two frames of plate_drop, 1 ms apart


def frames(file):
    return [file["frames"][name] for name in sorted(file["frames"])]


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def exported(name):
    return os.path.join(FOLDER, name)


def world_points(target):
    """Returns points and triangles of an object as it is shown, with modifiers, animation and morph targets."""
    shown = target.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = shown.to_mesh()
    points = np.empty(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3) @ np.array(shown.matrix_world)[:3, :3].T + np.array(shown.matrix_world)[:3, 3]
    corners = np.empty(3 * len(mesh.polygons), dtype=np.int32)
    mesh.polygons.foreach_get("vertices", corners)
    shown.to_mesh_clear()
    return points, corners.reshape(-1, 3)


def corners(frame):
    return frame["vertex/position"][:][frame["face/vertices"][:]]


def check_near(found, expected, what, tolerance=NEAR):
    assert found.shape == expected.shape, f"{what}: {found.shape} != {expected.shape}"
    off = np.abs(found - expected).max()
    assert off < tolerance, f"{what}: {off} m off"


def obstacles(frame):
    """Returns the points of obstacles at their poses in a frame, by the names of their objects."""
    poses = frame["obstacle/pose"][:].reshape(-1, 3, 4)
    names = frame.file["obstacles/names"].asstr()[:]
    surfaces = [frame.file[f"obstacles/{i}/position"][:] for i in range(len(names))]
    return {f"obstacle_{name}": points @ pose[:, :3].T + pose[:, 3] for name, points, pose in zip(names, surfaces, poses)}


def check_obj(last):
    clear()
    bpy.ops.wm.obj_import(filepath=exported("run.obj"), forward_axis="Y", up_axis="Z")
    points, faces = world_points(bpy.data.objects["sheets"])
    check_near(points, last["vertex/position"][:], "obj")
    assert np.array_equal(faces, last["face/vertices"][:]), "obj: faces"
    for name, places in obstacles(last).items():
        check_near(world_points(bpy.data.objects[name])[0], places, f"obj: {name}")


def import_mesh(kind):
    """Imports run.KIND by Blender's importer, which has another name since Blender 4.2."""
    importer = getattr(bpy.ops.wm, kind + "_import") if bpy.app.version >= (4, 2) else getattr(bpy.ops.import_mesh, kind)
    importer(filepath=exported("run." + kind))


def check_ply(last):
    clear()
    import_mesh("ply")
    points, faces = world_points(bpy.context.selected_objects[0])
    check_near(points, last["vertex/position"][:], "ply")
    assert np.array_equal(faces, last["face/vertices"][:]), "ply: faces"


def check_stl(last):
    clear()
    import_mesh("stl")
    assert len(bpy.context.selected_objects[0].data.polygons) == last["face/vertices"].shape[0]


def check_cache(extension, all_frames):
    """Requires that all corners of faces are where the recording has them, also before their vertices existed."""
    clear()
    bpy.ops.wm.obj_import(filepath=exported("cache.obj"), forward_axis="Y", up_axis="Z")
    target = bpy.context.selected_objects[0]
    cache = target.modifiers.new("cache", "MESH_CACHE")
    cache.cache_format, cache.filepath = extension.upper(), exported("cache." + extension)
    cache.forward_axis, cache.up_axis = "POS_Y", "POS_Z"
    cache.frame_start = 0
    for number, frame in enumerate(all_frames):
        bpy.context.scene.frame_set(STEP * number)
        points, faces = world_points(target)
        check_near(points[faces], corners(frame), f"{extension} frame {number}")
        if number > 0:  # half way between frames, too
            bpy.context.scene.frame_set(STEP * number - STEP // 2)
            points, faces = world_points(target)
            check_near(points[faces], (corners(all_frames[number - 1]) + corners(frame)) / 2, extension)


def rigid_deviation(found, expected):
    """Returns the largest difference of coordinates between the points and their best rigid fit to `expected`."""
    a, b = found - found.mean(axis=0), expected - expected.mean(axis=0)
    u, _, v = np.linalg.svd(a.T @ b)
    turn = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ v))]) @ v
    return np.abs(a @ turn - b).max()


def check_glb(name, all_frames):
    clear()
    # With the default shading Debian's Blender 3.4 fails, whose importer is older than its NumPy.
    bpy.ops.import_scene.gltf(filepath=exported(name + ".glb"), import_shading="SMOOTH")
    last = all_frames[-1]
    fragments = last["face/fragment"][:]
    nodes = [target for target in bpy.data.objects if target.type == "MESH" and target.name.startswith("fragment_")]
    assert sorted(node.name for node in nodes) == [f"fragment_{i:03}" for i in range(fragments.max() + 1)]
    for number, frame in enumerate(all_frames):
        bpy.context.scene.frame_set(STEP * number)
        for solid, places in obstacles(frame).items():
            found = world_points(bpy.data.objects[solid])[0]
            check_near(np.sort(found, axis=0), np.sort(places, axis=0), f"{name} {solid} frame {number}", 1e-5)
        for node in nodes:
            mine = fragments == int(node.name[-3:])
            points, faces = world_points(node)
            expected, found = corners(frame)[mine].reshape(-1, 3), points[faces].reshape(-1, 3)
            allowed = 1e-5 if name == "morph" else 1e-5 + 1.5 * rigid_deviation(found, expected)
            check_near(found, expected, f"{name} {node.name} frame {number}", allowed)


def check_vdb(all_frames):
    clear()
    for number in range(len(all_frames)):
        bpy.ops.object.volume_import(filepath=exported(f"volume_{number:06}.vdb"))
        volume = bpy.context.object.data
        assert volume.grids.load(), volume.grids.error_message
        assert [grid.name for grid in volume.grids] == ["surface"]


def check_player(all_frames):
    clear()
    sherd_recording.register()
    assert bpy.ops.import_scene.sherd_recording(filepath=RECORDING, slow=SLOW) == {"FINISHED"}
    target = next(item for item in bpy.data.objects if "sherd_recording" in item)
    assert bpy.context.scene.frame_end == STEP * (len(all_frames) - 1)
    for number in [*range(len(all_frames)), 0]:
        bpy.context.scene.frame_set(STEP * number)
        check_played(target, all_frames[number], number)
    for number in range(len(all_frames) - 1):
        bpy.context.scene.frame_set(STEP * number + STEP // 2)
        points, faces = world_points(target)
        check_near(points[faces], (corners(all_frames[number]) + corners(all_frames[number + 1])) / 2, "played between")
        fragments = [item.value for item in target.data.attributes["fragment"].data]
        assert fragments == all_frames[number]["face/fragment"][:].tolist(), "played between: fragments"
    sherd_recording.unregister()


def check_played(target, frame, number):
    points, faces = world_points(target)
    check_near(points, frame["vertex/position"][:], f"played frame {number}")
    assert np.array_equal(faces, frame["face/vertices"][:]), f"played frame {number}: faces"
    assert not target.data.validate(), f"played frame {number}: not a valid mesh"
    for name, places in obstacles(frame).items():
        check_near(world_points(bpy.data.objects[name])[0], places, f"played frame {number}: {name}")
    strain = {frozenset(ends): abs(value) for ends, value in zip(frame["edge/vertices"][:].tolist(), frame["edge/strain"][:])}
    for face, corners in enumerate(frame["face/vertices"][:].tolist()):
        a, b, c = corners
        expected = max(strain[frozenset(side)] for side in ((a, b), (b, c), (c, a)))
        assert abs(target.data.attributes["strain"].data[face].value - expected) <= 1e-6 * expected
        assert target.data.attributes["fragment"].data[face].value == frame["face/fragment"][face]


def check_script_beside_the_installed():
    """Requires that play_recording.py replaces an add-on that is installed and enabled: both cannot run at once."""
    clear()
    sherd_recording.register()
    given, sys.argv = sys.argv, ["blender", "--", RECORDING]
    runpy.run_path(os.path.join(BLENDER, "play_recording.py"))
    sys.argv = given
    assert any("sherd_recording" in target for target in bpy.data.objects), "the script has loaded nothing"
    assert [handler.__name__ for handler in bpy.app.handlers.frame_change_pre] == ["play"]


def main():
    with h5py.File(RECORDING, "r") as file:
        all_frames = frames(file)
        check_obj(all_frames[-1])
        check_ply(all_frames[-1])
        check_stl(all_frames[-1])
        for extension in ("pc2", "mdd"):
            check_cache(extension, all_frames)
        for name in ("rigid", "morph"):
            check_glb(name, all_frames)
        check_vdb(all_frames)
        check_player(all_frames)
    check_script_beside_the_installed()
    print(f"Blender shows all {len(all_frames)} frames of obj, ply, stl, pc2, mdd, glb, vdb and the recording itself")


main()
