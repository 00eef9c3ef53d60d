# small_scene.py: makes a small exercise from nothing, marks it, and exports it for Fulcrum.
#
#   blender -b --factory-startup --python tools/blender/small_scene.py -- OUT.glb
#
# It is also an example of how a script marks objects: fulcrum_blender.set_mark is what the add-on's menus call. Lengths
# are in metres and z is up, as in Blender; the export turns that into glTF's y up.
import os
import sys
import traceback

import bmesh
import bpy
from mathutils import Matrix, Vector

sys.dont_write_bytecode = True  # Nothing is left beside the add-on.
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import fulcrum_blender  # noqa: E402


def turned(name, outline, segments=48):
    """A solid of revolution about z. outline: (radius, height) from bottom to top, the ends of which are closed."""
    solid = bmesh.new()
    rings = []
    for radius, height in outline:
        corners = 1 if radius == 0 else segments
        turns = [Matrix.Rotation(6.283185307179586 * i / segments, 3, "Z") for i in range(corners)]
        rings.append([solid.verts.new(turn @ Vector((radius, 0, height))) for turn in turns])
    for low, high in zip(rings, rings[1:]):
        for i in range(segments):
            a, b = low[i % len(low)], low[(i + 1) % len(low)]
            c, d = high[(i + 1) % len(high)], high[i % len(high)]
            solid.faces.new(dict.fromkeys((a, b, c, d)))  # Of a ring of one corner it takes that once.
    return placed(name, solid)


def box(name, size, centre):
    solid = bmesh.new()
    bmesh.ops.create_cube(solid, size=1.0, matrix=Matrix.Translation(centre) @ Matrix.Diagonal((*size, 1.0)))
    return placed(name, solid)


def placed(name, solid):
    mesh = bpy.data.meshes.new(name)
    solid.to_mesh(mesh)
    solid.free()
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def paint(obj, colour, metallic, roughness):
    material = bpy.data.materials.new(obj.name)
    material.use_nodes = True
    inputs = material.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (*colour, 1.0)
    inputs["Metallic"].default_value = metallic
    inputs["Roughness"].default_value = roughness
    obj.data.materials.append(material)


def ball(radius, steps, first, last):
    """Part of a half circle about (0, 0), from one angle above the equator to another, in quarter turns."""
    angles = [(first + (last - first) * i / steps) * 1.5707963267948966 for i in range(steps + 1)]
    points = [Matrix.Rotation(angle, 2) @ Vector((radius, 0)) for angle in angles]
    return [(0.0 if abs(x) < 1e-9 else x, y) for x, y in points]


def make():
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)

    # What is touched: a round plate with a post of 4 cm, in one solid, and a block beside it.
    plate = turned("Plate", [(0, 0), (0.06, 0), (0.06, 0.01), (0.009, 0.01), (0.009, 0.049), (0.008, 0.05), (0, 0.05)])
    block = box("Block", (0.03, 0.03, 0.02), (0.09, 0, 0.01))
    # What is held: a stick, round at both ends, whose tip is at its own origin.
    radius, length = 0.003, 0.12
    tip = [(r, h + radius) for r, h in ball(radius, 8, -1, 0)]
    end = [(r, h + length - radius) for r, h in ball(radius, 8, 0, 1)]
    stick = turned("Stick", tip + end, 24)
    stick.location = (0.03, -0.02, 0.08)
    # What is seen only: the top of a table, 1 mm below.
    table = box("Table", (0.6, 0.4, 0.02), (0, 0, -0.011))

    paint(plate, (0.35, 0.37, 0.40), 0.9, 0.35)
    paint(block, (0.70, 0.50, 0.30), 0.0, 0.60)
    paint(stick, (0.10, 0.25, 0.60), 0.0, 0.40)
    paint(table, (0.45, 0.30, 0.18), 0.0, 0.70)
    for obj in (plate, stick):
        for polygon in obj.data.polygons:
            polygon.use_smooth = True
        obj.data.use_auto_smooth = True  # Edges sharper than 30 degrees stay edges.

    fulcrum_blender.set_mark([plate, block], fulcrum_blender.ROLE, "scene")
    fulcrum_blender.set_mark([plate], fulcrum_blender.MATERIAL, "steel")
    fulcrum_blender.set_mark([block], fulcrum_blender.MATERIAL, "wood")
    fulcrum_blender.set_mark([stick], fulcrum_blender.ROLE, "tool")
    fulcrum_blender.set_mark([table], fulcrum_blender.ROLE, "decor")


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(arguments) != 1:
        sys.exit("usage: blender -b --factory-startup --python small_scene.py -- OUT.glb")
    fulcrum_blender.register()
    make()
    bpy.ops.export_scene.fulcrum(filepath=os.path.abspath(arguments[0]))


try:
    main()
except Exception:  # Blender would say it and still leave with 0.
    traceback.print_exc()
    sys.exit(1)
