"""Builds a small haptic scene in Blender and exports it, so that the tests read what Blender really writes. blender.gltf
was exported by Blender 3.4.1 of Debian 12. The tests do not need Blender.

    blender --background --factory-startup --python-exit-code 1 \\
        --python tests/scene/files/make_with_blender.py -- tests/scene/files/blender.gltf

In Blender, +Z is up. The glTF exporter rotates the axes, so that the plate's normal is its local +Z here, and its
mid-line its local +Y. Lengths are in metres.
"""
import math
import sys

import bpy

REACH_M = 0.1
START_Y_M = -0.05


def add(name, parent, location, mesh=None, scale=(1, 1, 1), **properties):
    item = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(item)
    item.parent = parent
    item.location = location
    item.scale = scale
    for key, value in properties.items():
        item[key] = value
    return item


def at(direction_deg, height_m=0.0):
    angle = math.radians(direction_deg)
    return (-REACH_M * math.sin(angle), START_Y_M + REACH_M * math.cos(angle), height_m)


def tetrahedron():
    mesh = bpy.data.meshes.new("Tetrahedron")
    mesh.from_pydata([(1, 0, 0), (-1, 1, 0), (-1, -1, 0), (0, 0, 2)], [],
                     [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    return mesh


bpy.ops.wm.read_factory_settings(use_empty=True)
mesh = tetrahedron()
desk = add("Desk", None, (1.0, 2.0, 0.7), unrelated="not haptic", numbers=[1.0, 2.0])
rig = add("Rig", desk, (0.2, 0.0, 0.0))
rig.rotation_euler = (0.0, 0.0, math.radians(30))
# The scales are not uniform, as in the scene of a designer who does not apply them.
add("Plate", rig, (0, 0, 0), mesh, (0.075, 0.075, 0.002), haptic_role="plate", haptic_radius_m=0.075,
    haptic_max_speed_deg_s=400)
add("Brass", rig, at(0), mesh, (0.005, 0.005, 0.02), haptic_role="real", haptic_name="cylinder")
add("Bottle", rig, at(10), mesh, (0.005, 0.005, 0.03), haptic_role="virtual", haptic_served_by="cylinder",
    haptic_radius_m=0.005)
add("Mirrored", rig, at(-8, 0.01), mesh, (-0.005, 0.005, 0.03), haptic={"role": "virtual", "served_by": "cylinder"})

bpy.ops.export_scene.gltf(filepath=sys.argv[-1], export_format="GLTF_EMBEDDED", export_extras=True)
