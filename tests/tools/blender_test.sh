#!/usr/bin/env bash
# blender_test.sh [FOLDER]: the add-on in FOLDER, or in tools/blender, in a Blender without a window and with a home of its
# own: what it writes, what it refuses and in which words, and that it leaves everything as it was. $FULCRUM is the program,
# for which what it writes is a scenario.
set -uo pipefail
here=$(dirname "$(readlink -f "$0")")
. "$here/../support/expect.sh"
command -v blender >/dev/null || { echo "skipped: no blender (Debian packages blender and python3-numpy)"; exit 77; }
addon=$(readlink -f "${1:-$here/../../tools/blender}")
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
export HOME=$work/home XDG_CONFIG_HOME=$work/home/config XDG_CACHE_HOME=$work/home/cache
mkdir -p "$HOME"
unset "${!BLENDER_@}"
cd "$work" || exit 1

# The menu has every material that there is.
materials=$(cd "$here/../../content/materials" && ls | sed 's/.yaml$//' | tr '\n' ' ')
for name in $materials; do grep -q "^MATERIALS = .*\"$name\"" "$addon/fulcrum_blender.py" || fail "the menu has no $name"; done

# --- small_scene.py
expect 0 'Info: 4 objects are in small.glb: the scene is 0.165 m across, the tool 0.12 m' \
  blender -b --factory-startup --python "$addon/small_scene.py" -- small.glb
expect 1 'usage: ' blender -b --factory-startup --python "$addon/small_scene.py"
expect 1 "'$work/none/small.glb' cannot be written: No such file or directory" \
  blender -b --factory-startup --python "$addon/small_scene.py" -- none/small.glb
[ -e "$addon/__pycache__" ] && fail "something is left beside the add-on"

# read_glb: nodes by name, each with its extras, materials, and the corners and triangles of its mesh in the world.
cat >read_glb.py <<'E2'
import json
import struct


def read_glb(file):
    with open(file, "rb") as source:
        data = source.read()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data)), "not a GLB of %d bytes" % len(data)
    end = 20 + struct.unpack_from("<I", data, 12)[0]
    tree, binary = json.loads(data[20:end]), data[end + 8:]
    assert end % 4 == 0 and data[16:20] == b"JSON" and data[end + 4:end + 8] == b"BIN\0"
    assert not {"cameras", "animations", "skins"} & set(tree) and "KHR_lights_punctual" not in str(tree)

    def numbers(index):
        accessor = tree["accessors"][index]
        view = tree["bufferViews"][accessor["bufferView"]]
        kind, size = {5121: ("B", 1), 5123: ("H", 2), 5125: ("I", 4), 5126: ("f", 4)}[accessor["componentType"]]
        each = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = struct.unpack_from("<%d%s" % (accessor["count"] * each, kind), binary, start)
        return [flat[i:i + each] for i in range(0, len(flat), each)]

    nodes = {}
    for index in tree["scenes"][tree["scene"]]["nodes"]:
        node = tree["nodes"][index]
        assert "scale" not in node and "matrix" not in node and "children" not in node, node
        x, y, z, w = node.get("rotation", (0, 0, 0, 1))
        t = node.get("translation", (0, 0, 0))
        rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
                (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
                (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
        node.update(points=[], triangles=[], colours=[], materials=[], origin=t)
        for primitive in tree["meshes"][node["mesh"]]["primitives"]:
            base = len(node["points"])
            for p in numbers(primitive["attributes"]["POSITION"]):
                node["points"].append(tuple(sum(r * c for r, c in zip(row, p)) + o for row, o in zip(rows, t)))
            corners = [base + i[0] for i in numbers(primitive["indices"])]
            node["triangles"] += [corners[i:i + 3] for i in range(0, len(corners), 3)]
            if "COLOR_0" in primitive["attributes"]:
                node["colours"] += numbers(primitive["attributes"]["COLOR_0"])
            if "material" in primitive:
                node["materials"].append(tree["materials"][primitive["material"]])
        node["low"], node["high"] = ([f(p[i] for p in node["points"]) for i in range(3)] for f in (min, max))
        nodes.setdefault(node["name"], []).append(node)
    return nodes


def volume(node):
    total = 0
    for a, b, c in ([node["points"][i] for i in triangle] for triangle in node["triangles"]):
        total += sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
    return total / 6


def closed(node):
    edges = {}
    for triangle in node["triangles"]:
        corners = [tuple(round(x, 7) for x in node["points"][i]) for i in triangle]
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edges[a, b] = edges.get((a, b), 0) + 1
    return all(count == 1 and edges.get((b, a)) == 1 for (a, b), count in edges.items())


def near(a, b, within=1e-6):
    return len(a) == len(b) and all(abs(x - y) <= within for x, y in zip(a, b))
E2
cat >small.py <<'E2'
from read_glb import closed, near, read_glb, volume
nodes = {name: each[0] for name, each in read_glb("small.glb").items()}
assert {name: node["extras"] for name, node in nodes.items()} == {
    "Plate": {"fulcrum_role": "scene", "fulcrum_material": "steel"},
    "Block": {"fulcrum_role": "scene", "fulcrum_material": "wood"},
    "Stick": {"fulcrum_role": "tool"}, "Table": {"fulcrum_role": "decor"}}, nodes
for name, node in nodes.items():
    assert closed(node) and volume(node) > 0, name + " is no solid"
assert near(nodes["Plate"]["low"], (-0.06, 0, -0.06)) and near(nodes["Plate"]["high"], (0.06, 0.05, 0.06))
# In Blender (0.03, -0.02, 0.08): z has become y, and y has become -z.
assert near(nodes["Stick"]["origin"], (0.03, 0.08, 0.02))
assert near(nodes["Stick"]["low"], (0.027, 0.08, 0.017)) and near(nodes["Stick"]["high"], (0.033, 0.2, 0.023))
pbr = nodes["Plate"]["materials"][0]["pbrMetallicRoughness"]
assert near(pbr["baseColorFactor"], (0.35, 0.37, 0.40, 1))
assert near((pbr["metallicFactor"], pbr["roughnessFactor"]), (0.9, 0.35))
E2
expect 0 '^$' python3 -B small.py

# --- what else there is in scenes
cat >checks.py <<'E2'
import math
import os
import sys
import traceback

import bmesh
import bpy
from mathutils import Matrix

sys.dont_write_bytecode = True
sys.path[:0] = [sys.argv[-1], os.getcwd()]
import fulcrum_blender as fulcrum
from read_glb import closed, near, read_glb, volume

ROLE = fulcrum.ROLE
fulcrum.register()


def cube(name, role=None, at=(0, 0, 0), size=0.02, mesh=None, collection=None):
    if not mesh:
        mesh = bpy.data.meshes.new(name)
        solid = bmesh.new()
        bmesh.ops.create_cube(solid, size=size)
        solid.to_mesh(mesh)
        solid.free()
    obj = bpy.data.objects.new(name, mesh)
    obj.location = at
    (collection or bpy.context.scene.collection).objects.link(obj)
    if role:
        obj["fulcrum_role"] = role
    return obj


def state():
    c = bpy.context
    return (c.window.scene, c.window.view_layer, c.view_layer.objects.active, c.mode, set(c.selected_objects),
            c.scene.frame_current, c.scene.camera, sorted(os.listdir(".")),
            [o.matrix_world.copy() for o in c.scene.objects], [(o.name, sorted(o.keys())) for o in bpy.data.objects],
            [len(getattr(bpy.data, kind)) for kind in ("meshes", "materials", "scenes", "collections", "images")])


def export(name="out.glb"):
    """The file's nodes; everything else is as before."""
    open(name, "a").close()
    bpy.context.view_layer.update()
    before = state()
    assert bpy.ops.export_scene.fulcrum(filepath=os.path.abspath(name)) == {"FINISHED"}
    assert state() == before, "changed: %s %s" % (before, state())
    return read_glb(name)


def refused(*sentences, name="kept.glb"):
    """Refuses, says the sentences, and leaves all as it was, the file too."""
    if name == "kept.glb" and not os.path.exists(name):
        with open(name, "w") as file:
            file.write("kept")
    bpy.context.view_layer.update()
    before = state()
    try:
        bpy.ops.export_scene.fulcrum(filepath=os.path.abspath(name))
    except RuntimeError as error:
        for sentence in sentences:
            assert sentence in str(error), "says not '%s' but %s" % (sentence, error)
    else:
        raise AssertionError("was not refused")
    assert state() == before, "changed: %s %s" % (before, state())
    assert not os.path.exists(name) or open(name).read() == "kept"


def notes(*sentences):
    said = fulcrum.survey(bpy.context)[2]
    assert len(said) == len(sentences) and all(s in t for s, t in zip(sentences, said)), said


def pair():
    return cube("Ground", "scene"), cube("Pin", "tool", (0, 0, 0.05), 0.01)


# --- each of these begins with an empty scene


def refusals():
    refused("No visible object has a role: select what is touched")
    ground = cube("Ground")
    refused("No visible object has a role")
    ground[ROLE] = "scene"
    refused("No visible object has the role tool, so that there is nothing to hold.")
    ground[ROLE] = "tool"
    refused("No visible object has the role scene, so that there is nothing to touch.")
    pin = cube("Pin", "Tool")
    refused("'Pin' has the role 'Tool', which is none of scene, tool, decor")
    for odd in (1, 1.5, [1.0, 2.0], {"a": 1}, ""):
        pin[ROLE] = odd
        refused("'Pin' has the role '")
    pin[ROLE] = "scene"
    pin["fulcrum_material"] = "gold"
    refused("'Pin' has the material 'gold', which is none of enamel, rubber, steel, wood")
    pin["fulcrum_material"] = "wood"
    assert export()["Pin"][0]["extras"] == {"fulcrum_role": "scene", "fulcrum_material": "wood"}


def files():
    pair()
    refused("cannot be written: No such file or directory", name="none/x.glb")
    os.makedirs("folder.glb", exist_ok=True)
    before = sorted(os.listdir("."))
    try:
        bpy.ops.export_scene.fulcrum(filepath=os.path.abspath("folder.glb"))
        raise AssertionError("a folder was replaced")
    except RuntimeError as error:
        assert "cannot be written: Is a directory" in str(error), error
    assert sorted(os.listdir(".")) == before
    if os.getuid():
        os.makedirs("closed", exist_ok=True)
        os.chmod("closed", 0o555)
        refused("cannot be written: Permission denied", name="closed/x.glb")
        with open("protected.glb", "w") as file:
            file.write("kept")
        os.chmod("protected.glb", 0o444)
        refused("is write-protected: choose another name", name="protected.glb")
    else:
        print("not tried: folders and files that may not be written to, which stop everyone but root")
    export("Übung 'eins' \"zwei\".glb")
    bpy.ops.export_scene.fulcrum(filepath=os.path.abspath("no_ending"))
    assert os.path.exists("no_ending.glb")
    os.symlink("no_ending.glb", "link.glb")
    export("link.glb")
    assert os.path.islink("link.glb") and not [f for f in os.listdir(".") if f.startswith(".fulcrum")]


def exporter_fails():
    pair()
    from io_scene_gltf2.blender.exp import gltf2_blender_export
    save = gltf2_blender_export.save

    def broken(context, settings):
        with open(settings["gltf_filepath"], "w") as file:
            file.write("half")
        raise ValueError("no reason")
    try:
        gltf2_blender_export.save = broken
        refused("Blender's own glTF exporter failed: ValueError: no reason.")
        gltf2_blender_export.save = lambda context, settings: {"FINISHED"}
        refused("cannot be written: No such file or directory")
    finally:
        gltf2_blender_export.save = save
    bpy.ops.preferences.addon_disable(module="io_scene_gltf2")
    refused("Blender's own glTF exporter is missing")
    bpy.ops.preferences.addon_enable(module="io_scene_gltf2")
    export()


def units():
    ground, pin = pair()
    ground.data.transform(Matrix.Scale(1000, 4))
    ground.location = (100, 200, 300)
    settings = bpy.context.scene.unit_settings
    settings.system, settings.scale_length = "METRIC", 0.001
    notes("The scene's unit scale is 0.001: one Blender unit becomes 0.001 m")
    node = export()["Ground"][0]
    assert near(node["low"], (0.09, 0.29, -0.21)) and near(node["high"], (0.11, 0.31, -0.19)), node
    assert near(node["origin"], (0.1, 0.3, -0.2))
    settings.system = "NONE"
    notes()
    assert near(export()["Ground"][0]["origin"], (100, 300, -200))
    settings.system, settings.scale_length = "IMPERIAL", 0.0254
    assert near(export()["Ground"][0]["origin"], (2.54, 7.62, -5.08), 1e-5)


def hidden_and_bare():
    pair()
    for name, hide in (("Eye", lambda o: o.hide_set(True)), ("Screen", lambda o: setattr(o, "hide_viewport", True))):
        hide(cube(name, "scene"))
    shelf = bpy.data.collections.new("Shelf")
    bpy.context.scene.collection.children.link(shelf)
    cube("Shelved", "tool", collection=shelf)
    bpy.context.view_layer.layer_collection.children["Shelf"].exclude = True
    bpy.data.objects.new("In no scene", None)[ROLE] = "scene"
    empty = bpy.data.objects.new("Empty", None)
    bpy.context.scene.collection.objects.link(empty)
    empty[ROLE] = "scene"
    for i in range(5):
        cube("Bare%d" % i).data[ROLE] = "scene"
    render = cube("Render", "decor")
    render.hide_render = True
    notes("Without a role, and left out: 'Bare0', 'Bare1', 'Bare2', 2 more.", "The role is with the mesh",
          "With a role, but hidden and left out: 'Eye', 'Screen', 'Shelved'.",
          "With a role, but without a surface and left out: 'Empty'.")
    assert set(export()) == {"Ground", "Pin", "Render"}
    assert fulcrum.survey(bpy.context)[0] == {"scene": 1, "tool": 1, "decor": 1, "without a role": 5}


def transforms():
    """Parents, shear, mirrors, one mesh in several objects, modifiers: each point is where Blender shows it."""
    _, pin = pair()
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.scale, parent.rotation_euler = (1, 3, 0.5), (0.3, 0.2, 0.1)
    mesh = pin.data
    for i, (scale, role) in enumerate((((1, 1, 1), "scene"), ((-1, 2, 1), "tool"), ((-2, -1, -1), "decor"))):
        child = cube("Child%d" % i, role, (0.1, 0.2 * i, 0.3), mesh=mesh)
        child.parent = parent
        child.scale, child.rotation_euler = scale, (0.5, 1.0 * i, 0.2)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera
    grown = cube("Grown", "scene", (0, 0, -0.5))
    grown.parent = camera
    grown.modifiers.new("a", "ARRAY").count = 3
    grown.modifiers.new("s", "SUBSURF")
    nodes = export()
    assert sorted(nodes) == ["Child0", "Child1", "Child2", "Ground", "Grown", "Pin"], sorted(nodes)
    assert all(len(each) == 1 for each in nodes.values())
    for name in ("Child0", "Child1", "Child2", "Grown"):
        obj = bpy.data.objects[name].evaluated_get(bpy.context.evaluated_depsgraph_get())
        wanted = [(p.x, p.z, -p.y) for p in (obj.matrix_world @ v.co for v in obj.data.vertices)]
        for some, others in ((nodes[name][0]["points"], wanted), (wanted, nodes[name][0]["points"])):
            assert all(min(math.dist(p, q) for q in others) < 1e-6 for p in some), name
        assert volume(nodes[name][0]) > 0, name + " is inside out"
    assert all(closed(nodes[name][0]) for name in ("Child0", "Child1", "Child2"))
    assert [nodes["Child%d" % i][0]["extras"][ROLE] for i in range(3)] == ["scene", "tool", "decor"]


def instances():
    pair()
    library = bpy.data.collections.new("Library")
    cube("Bolt", collection=library)
    cube("Nut", "decor", (0.1, 0, 0), collection=library)
    library.instance_offset = (0, 0, 0.5)
    for name, role in (("Marked", "scene"), ("Unmarked", None)):
        empty = bpy.data.objects.new(name, None)
        bpy.context.scene.collection.objects.link(empty)
        empty.instance_type, empty.instance_collection = "COLLECTION", library
        empty.location = (1 if role else 2, 0, 0)
        if role:
            empty[ROLE] = role
    nodes = export()
    assert [n["extras"][ROLE] for n in nodes["Bolt"]] == ["scene"] and near(nodes["Bolt"][0]["origin"], (1, -0.5, 0))
    assert sorted(n["extras"][ROLE] for n in nodes["Nut"]) == ["decor", "scene"]
    notes("Without a role, and left out: 'Unmarked'.")
    assert fulcrum.markable([bpy.data.objects["Marked"]])


def scattered():
    _, pin = pair()
    plate = cube("Plate", "scene", (0, 0, -1), 0.5)
    group = bpy.data.node_groups.new("Scatter", "GeometryNodeTree")
    group.inputs.new("NodeSocketGeometry", "Geometry")
    group.outputs.new("NodeSocketGeometry", "Geometry")
    nodes = {kind: group.nodes.new(kind) for kind in (
        "NodeGroupInput", "NodeGroupOutput", "GeometryNodeInstanceOnPoints", "GeometryNodeMeshUVSphere",
        "GeometryNodeJoinGeometry")}
    onto = nodes["GeometryNodeInstanceOnPoints"]
    nodes["GeometryNodeMeshUVSphere"].inputs["Radius"].default_value = 0.01
    join = nodes["GeometryNodeJoinGeometry"]
    for a, b in ((nodes["NodeGroupInput"].outputs[0], onto.inputs["Points"]),
                 (nodes["GeometryNodeMeshUVSphere"].outputs[0], onto.inputs["Instance"]),
                 (onto.outputs[0], join.inputs[0]), (nodes["NodeGroupInput"].outputs[0], join.inputs[0]),
                 (join.outputs[0], nodes["NodeGroupOutput"].inputs[0])):
        group.links.new(a, b)
    plate.modifiers.new("n", "NODES").node_group = group
    out = export()
    assert [n["extras"][ROLE] for n in out["Plate"]] == ["scene"] * 9, out.keys()
    assert sorted(round(n["high"][0] - n["low"][0], 3) for n in out["Plate"]) == [0.02] * 8 + [0.5]


def other_kinds():
    pair()
    bpy.ops.object.text_add(location=(0.2, 0, 0))
    text = bpy.context.object
    text.data.extrude, text[ROLE], text.scale = 0.1, "scene", (0.1, 0.1, 0.1)
    bpy.ops.curve.primitive_bezier_circle_add()
    ring = bpy.context.object
    ring.data.bevel_depth, ring[ROLE] = 0.1, "scene"
    bpy.ops.curve.primitive_bezier_circle_add()
    bpy.context.object[ROLE] = "scene"
    bpy.context.object.name = "Line"
    bpy.ops.surface.primitive_nurbs_surface_sphere_add(radius=0.1)
    bpy.context.object[ROLE] = "decor"
    bpy.ops.object.metaball_add(radius=0.1)
    bpy.context.object[ROLE] = "decor"
    bpy.ops.object.armature_add()
    notes("With a role, but without a surface and left out: 'Line'.")
    nodes = export()
    assert set(nodes) == {"Ground", "Pin", "Text", "BezierCircle", "SurfSphere", "Mball"}, set(nodes)
    assert all(len(each) == 1 for each in nodes.values())


def names():
    for i, name in enumerate(("Brett über \"alles\"", "Stift 'ß' \\ / 木", "ÄÖÜ" * 10)):
        cube(name, ("scene", "tool", "decor")[i])
    assert list(export()) == ["Brett über \"alles\"", "Stift 'ß' \\ / 木", "ÄÖÜ" * 10]


def modes():
    """What is being edited is exported as it stands, and goes on being edited; other modes likewise."""
    ground, pin = pair()
    bpy.context.view_layer.objects.active = ground
    ground.select_set(True)
    bpy.ops.object.mode_set(mode="EDIT")
    editing = bmesh.from_edit_mesh(ground.data)
    editing.verts.ensure_lookup_table()
    for vertex in editing.verts:
        vertex.co.x *= 3
        vertex.select = vertex.co.x > 0
    bmesh.update_edit_mesh(ground.data)
    nodes = export()
    assert near(nodes["Ground"][0]["high"], (0.03, 0.01, 0.01)), nodes["Ground"][0]["high"]
    assert sum(v.select for v in bmesh.from_edit_mesh(ground.data).verts) == 4
    del pin[ROLE]
    refused("No visible object has the role tool")
    pin[ROLE] = "tool"
    for mode in ("SCULPT", "VERTEX_PAINT", "WEIGHT_PAINT", "OBJECT"):
        bpy.ops.object.mode_set(mode=mode)
        export()
    second = bpy.context.scene.view_layers.new("Second")
    bpy.context.window.view_layer = second
    bpy.context.scene.frame_set(17)
    export()
    assert bpy.context.window.view_layer == second


def looks():
    ground, pin = pair()
    for obj, colour in ((ground, (1, 0, 0, 1)), (pin, (0, 1, 0, 1))):
        material = bpy.data.materials.new("Of " + obj.name)
        material.diffuse_color = colour
        obj.data.materials.append(material)
    twin = cube("Twin", "decor", (1, 0, 0), mesh=ground.data)
    twin.material_slots[0].link = "OBJECT"
    twin.material_slots[0].material = bpy.data.materials["Of Pin"]
    layer = pin.data.color_attributes.new("Paint", "BYTE_COLOR", "CORNER")
    for each in layer.data:
        each.color = (0, 0, 1, 1)
    pin.modifiers.new("a", "ARRAY")
    twin.modifiers.new("a", "ARRAY")
    nodes = export()
    assert {name: each[0]["materials"][0]["name"] for name, each in nodes.items()} == {
        "Ground": "Of Ground", "Pin": "Of Pin", "Twin": "Of Pin"}
    assert near(nodes["Ground"][0]["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"], (1, 0, 0, 1))
    assert nodes["Pin"][0]["colours"] and not nodes["Ground"][0]["colours"]
    assert len(set(nodes["Pin"][0]["colours"])) == 1 and nodes["Pin"][0]["colours"][0][0] == 0


def marking():
    ground, pin = cube("Ground"), cube("Pin")
    lamp = bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "POINT"))
    bpy.context.scene.collection.objects.link(lamp)
    for obj in (ground, pin, lamp):
        obj.select_set(True)
    bpy.ops.object.fulcrum_role(role="scene")
    assert ROLE not in lamp and ground[ROLE] == pin[ROLE] == "scene"
    bpy.ops.object.fulcrum_material(material="rubber")
    assert pin["fulcrum_material"] == "rubber"
    ground.select_set(False)
    bpy.ops.object.fulcrum_role(role="tool")
    assert dict(pin.items()) == {ROLE: "tool"} and ground["fulcrum_material"] == "rubber"
    try:
        bpy.ops.object.fulcrum_material(material="steel")
        raise AssertionError("a tool has a material")
    except RuntimeError as error:
        assert "give it the role scene first" in str(error)
    pin["fulcrum_material"] = "steel"
    notes("'Pin' has a material, which only the role scene takes: it is left out.")
    assert export()["Pin"][0]["extras"] == {ROLE: "tool"}
    bpy.ops.object.fulcrum_role(role="none")
    assert ROLE not in pin and not dict(pin.items())


def warnings():
    ground, pin = pair()
    bpy.context.view_layer.update()
    target = os.path.abspath("out.glb")
    assert fulcrum.export(bpy.context, target)[0] == []
    solid = bmesh.new()
    solid.from_mesh(ground.data)
    solid.faces.ensure_lookup_table()
    bmesh.ops.delete(solid, geom=[solid.faces[0]], context="FACES_ONLY")
    solid.to_mesh(ground.data)
    pin.scale = (1000, 1, 1)
    bpy.context.view_layer.update()
    said = fulcrum.export(bpy.context, target)[0]
    assert len(said) == 2 and "'Ground' is not closed (4 open edges)" in said[0], said
    assert "The tool is 10 m across, which was hardly meant" in said[1], said


wrong = 0
for check in (refusals, files, exporter_fails, units, hidden_and_bare, transforms, instances, scattered, other_kinds, names,
              modes, looks, marking, warnings):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    try:
        check()
    except Exception:
        wrong += 1
        print("FAILED: " + check.__name__)
        traceback.print_exc(file=sys.stdout)
fulcrum.unregister()
assert not hasattr(bpy.types, "VIEW3D_PT_fulcrum") and not hasattr(bpy.types, "EXPORT_SCENE_OT_fulcrum")
fulcrum.register()
print("checks done, %d wrong" % wrong)
sys.exit(1 if wrong else 0)
E2
expect 0 'checks done, 0 wrong' blender -b --factory-startup --python checks.py -- "$addon"

# --- as an add-on of a user who has none yet, and by --python
cat >install.py <<'E2'
import bpy, sys
bpy.ops.preferences.addon_install(filepath=sys.argv[-1])
bpy.ops.preferences.addon_enable(module="fulcrum_blender")
bpy.ops.wm.save_userpref()
E2
cat >there.py <<'E2'
import bpy
print("there:", hasattr(bpy.types, "EXPORT_SCENE_OT_fulcrum"), hasattr(bpy.types, "VIEW3D_PT_fulcrum"))
E2
expect 0 'fulcrum_blender' blender -b --python install.py -- "$addon/fulcrum_blender.py"
expect 0 'there: True True' blender -b --python there.py
expect 0 'there: False False' blender -b --factory-startup --python there.py
expect 0 'there: True True' blender -b --factory-startup --python "$addon/fulcrum_blender.py" --python there.py
find "$HOME" -name fulcrum_blender.py | grep -q . || fail "it was not installed in the home of the test"

# --- and it is felt
expect 0 'is made' "$FULCRUM" new mine --scene small.glb
expect 0 '^mine/scenario.yaml: good$' "$FULCRUM" check mine/scenario.yaml
expect 0 'Completed' "$FULCRUM" run mine/scenario.yaml --headless --hand expert --out ran
grep -q '"max_penetration_m": 0.0' ran/summary.json || fail "the stick is pushed into the plate"
grep -qE '"peak_force_N": (0\.[1-9]|[1-9])' ran/summary.json || fail "nothing was felt: $(grep peak_force_N ran/summary.json)"

[ $failures = 0 ] && echo "all good"
exit $((failures > 0))
