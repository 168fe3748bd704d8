# SPDX-License-Identifier: GPL-3.0-or-later
"""The look of sheets: texture coordinates, materials and colours, as far as the files of their meshes have them."""

import os
import sys
import tempfile

import bpy
import numpy as np

from .playback import materials_of

TEXTURE, COLOUR, PLAIN = "texture", "colour", "sheet"  # UV map, attribute, and the material of faces without any


def set_look(mesh, look):
    """Sets texture coordinates, slots and colours of a mesh whose faces are new; does not change its materials."""
    if look["texture"] is not None:
        layer = mesh.uv_layers.get(TEXTURE) or mesh.uv_layers.new(name=TEXTURE, do_init=False)
        layer.data.foreach_set("uv", look["texture"].ravel().astype(np.float32))
    if look["slot"] is not None:
        mesh.polygons.foreach_set("material_index", look["slot"].astype(np.int32))
    if look["colour"] is not None:
        attribute = mesh.attributes.get(COLOUR) or mesh.attributes.new(COLOUR, "BYTE_COLOR", "CORNER")
        attribute.data.foreach_set("color_srgb", look["colour"].ravel().astype(np.float32))


def imported(definitions):
    """Returns a material for each definition (lines of .mtl), as Blender's importer of .obj makes it."""
    names = [f"{number:06}" for number in range(len(definitions))]
    before = set(bpy.data.objects)
    with tempfile.TemporaryDirectory() as folder:
        obj = os.path.join(folder, "materials.obj")
        with open(obj, "w", encoding="utf-8") as file:
            file.write("mtllib materials.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n")
            file.writelines(f"usemtl {name}\nf 1/1 2/1 3/1\n" for name in names)
        with open(os.path.join(folder, "materials.mtl"), "w", encoding="utf-8") as file:
            file.writelines(f"newmtl {name}\n{definition}\n" for name, definition in zip(names, definitions))
        bpy.ops.wm.obj_import(filepath=obj)
    carrier = (set(bpy.data.objects) - before).pop()
    mesh = carrier.data
    made = {material.name[: len(names[0])]: material for material in mesh.materials}  # Blender may append .001
    bpy.data.objects.remove(carrier)
    bpy.data.meshes.remove(mesh)
    return [made[name] for name in names]


def drop_lost_pictures(material):
    """Removes pictures that cannot be read from a material, which shows its colour instead; prints a warning."""
    nodes = material.node_tree.nodes
    for node in [node for node in nodes if node.type == "TEX_IMAGE" and node.image and 0 in node.image.size]:
        picture = node.image
        name = os.path.basename(picture.filepath)
        print(f"sherd: the picture {name} of the material {material.name} cannot be read", file=sys.stderr)
        nodes.remove(node)
        if picture.users == 0:
            bpy.data.images.remove(picture)


def plain_material(white):
    material = bpy.data.materials.new(PLAIN)
    material.use_nodes = True
    if white:
        base_colour(material).default_value = (1, 1, 1, 1)
    return material


def base_colour(material):
    return next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED").inputs["Base Color"]


def tint(material):
    """Multiplies the material's colour, or its picture, by the colour attribute of the mesh."""
    nodes, link = material.node_tree.nodes, material.node_tree.links.new
    base, product, colour = base_colour(material), nodes.new("ShaderNodeMixRGB"), nodes.new("ShaderNodeVertexColor")
    product.blend_type, product.inputs["Fac"].default_value, colour.layer_name = "MULTIPLY", 1, COLOUR
    product.inputs["Color1"].default_value = base.default_value
    if base.is_linked:
        link(base.links[0].from_socket, product.inputs["Color1"])
    link(colour.outputs["Color"], product.inputs["Color2"])
    link(product.outputs["Color"], base)
    place = next(node for node in nodes if node.type == "BSDF_PRINCIPLED").location
    product.location, colour.location = (place.x - 200, place.y), (place.x - 400, place.y - 200)


def add_materials(mesh, unbroken):
    """Fills the material slots in the order of look_of(). unbroken: the recording's group /rest."""
    known, coloured = materials_of(unbroken), "vertex_colour" in unbroken or "face_colour" in unbroken
    if not known and not coloured:
        return
    materials = imported([definition for _, definition in known]) if known else []
    for material, (name, _) in zip(materials, known):
        material.name = name
        drop_lost_pictures(material)
    if not known or -1 in unbroken["surface_material"][:]:
        materials.append(plain_material(coloured))
    for material in materials:
        if coloured:
            tint(material)
        mesh.materials.append(material)
