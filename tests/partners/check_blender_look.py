# SPDX-License-Identifier: GPL-3.0-or-later
"""blender -b --factory-startup --python-exit-code 1 --python check_blender_look.py -- RUN.h5 BLENDER

Plays the recording of record_textured.py with the player in BLENDER (app/blender): the mesh must have the texture
coordinates, materials and colours of each frame, between frames those of the later one, and keep a user's changes."""

import os
import sys

import bpy
import h5py
import numpy as np

RECORDING, FOLDER = sys.argv[sys.argv.index("--") + 1 :]
sys.path.insert(0, FOLDER)
import sherd_recording  # noqa: E402

STEP = 6  # Blender's frames, 24 a second, between two recorded ones, 0.5 ms apart, by the choice of the slowdown


def values(items, name, width):
    found = np.empty(width * len(items), np.float32)
    items.foreach_get(name, found)
    return found.reshape(len(items), width)


def check_frame(mesh, rest, slots):
    texture = values(mesh.uv_layers["texture"].data, "uv", 2)
    assert np.abs(texture - rest["texture"][:].reshape(-1, 2)).max() < 1e-6, "texture coordinates"
    colour = values(mesh.attributes["colour"].data, "color_srgb", 4)
    expected = rest["vertex_colour"][:][rest["faces"][:]].reshape(-1, 4) / 255
    assert np.abs(colour - expected).max() < 1e-6, "colours"
    names = [*rest["surface_material_names"].asstr()[:], "sheet"]
    found = [slots[polygon.material_index] for polygon in mesh.polygons]
    assert found == [names[row] for row in rest["surface_material"][:]], "materials"
    assert not mesh.validate()


def principled(material):
    return next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED").inputs


def base(material):
    """Returns the colour, or the picture, that the colours of vertices multiply."""
    product = principled(material)["Base Color"].links[0].from_node
    colours = product.inputs["Color2"].links[0].from_node
    assert (product.blend_type, product.inputs["Fac"].default_value) == ("MULTIPLY", 1)
    assert (colours.type, colours.layer_name) == ("VERTEX_COLOR", "colour")
    links = product.inputs["Color1"].links
    return links[0].from_node.image if links else list(product.inputs["Color1"].default_value)[:3]


def check_materials(materials):
    assert [material.name for material in materials] == ["glaze", "clay", "lost", "sheet"]
    glaze, clay, lost, sheet = materials
    assert os.path.samefile(base(glaze).filepath, os.path.join(os.path.dirname(RECORDING), "glaze.png"))
    assert base(glaze).size[:] == (64, 64)
    assert np.allclose(base(clay), [0.7, 0.4, 0.2]) and np.allclose(base(lost), [0.1, 0.6, 0.1])
    assert base(sheet) == [1, 1, 1]
    # Since Blender 4.2 all materials may be transparent, by hashed dots.
    transparent = "BLEND" if bpy.app.version < (4, 2) else "HASHED"
    assert principled(clay)["Alpha"].default_value == 0.5 and clay.blend_method == transparent
    assert 0.4 < principled(clay)["Roughness"].default_value < 0.6, "Ns 225 is half way from rough to smooth"


def rendered(target):
    """Renders the first frame from above, by Blender's Cycles; returns the colours of pixels of the plates, by name."""
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale, camera.location = "ORTHO", 0.5, (0.125, 0, 1)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 3
    for item in (camera, sun):
        scene.collection.objects.link(item)
    for solid in target.children:
        solid.hide_render = True
    scene.camera, scene.render.engine, scene.cycles.samples = camera, "CYCLES", 4
    scene.cycles.use_denoising = False
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = 200, 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.join(bpy.app.tempdir, "look.png")
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(picture.pixels[:]).reshape(100, 200, 4)  # rows from the bottom up
    places = {"upper glaze": (-0.06, 0.05), "lower glaze": (-0.06, -0.05), "red": (0.33, -0.06), "green": (0.17, 0.06)}
    return {name: pixels[int(50 + 400 * y), int(100 + 400 * (x - 0.125)), :3] for name, (x, y) in places.items()}


def check_picture(target):
    seen = rendered(target)
    assert seen["upper glaze"].argmax() == 2 and seen["lower glaze"].argmin() == 2, seen
    assert seen["red"].argmax() == 0 and seen["green"].argmax() == 1, seen


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    sherd_recording.register()
    with h5py.File(RECORDING, "r") as file:
        frames = [file["frames"][name] for name in sorted(file["frames"])]
        rests = [frame["rest"] for frame in frames]
        assert bpy.ops.import_scene.sherd_recording(filepath=RECORDING, slow=STEP / 24 / 5e-4) == {"FINISHED"}
        target = next(item for item in bpy.data.objects if "sherd_recording" in item)
        assert len(bpy.data.objects) == 2, "more than the sheets and the floor"
        mesh, scene = target.data, bpy.context.scene
        check_materials(list(mesh.materials))
        check_picture(target)
        slots = [material.name for material in mesh.materials]
        mesh.materials[1] = bpy.data.materials.new("mine")
        mesh.materials.append(bpy.data.materials.new("more"))
        mesh.materials[0].node_tree.nodes.new("ShaderNodeValue").name = "my node"
        for number in [*range(len(frames)), 0]:
            scene.frame_set(STEP * number)
            check_frame(mesh, rests[number], slots)
        for number in range(1, len(frames)):
            scene.frame_set(STEP * number - STEP // 2)
            check_frame(mesh, rests[number], slots)
        assert [material.name for material in mesh.materials] == ["glaze", "mine", "lost", "sheet", "more"]
        assert "my node" in mesh.materials[0].node_tree.nodes
        assert frames[-1]["face/fragment"][:].max() > 0, "nothing broke"
    sherd_recording.unregister()
    print(f"Blender shows how the sheets look in {len(frames)} frames")


main()
