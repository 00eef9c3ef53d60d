# Fulcrum for Blender: marks the objects of an exercise and exports them as one glTF binary (.glb) that Fulcrum reads.
#
# To install: Edit > Preferences > Add-ons > Install..., choose this file, and tick "Import-Export: Fulcrum". Its panel is
# in the sidebar of the 3D view (N), in the tab Fulcrum; the export is there and in File > Export > Fulcrum (.glb).
#
# The marks are custom properties of the objects, which glTF carries as the extras of nodes. Nothing else is stored.
#   fulcrum_role      "scene" is touched, "tool" is held in the hand, "decor" is seen only
#   fulcrum_material  with the role scene alone, and only if wanted: what a blow on it sounds and feels like
import importlib.util
import json
import os
import struct
import tempfile
import textwrap

import bmesh
import bpy
from bpy_extras.io_utils import ExportHelper
from mathutils import Matrix, Vector

bl_info = {
    "name": "Fulcrum",
    "description": "Marks the objects of a haptic exercise and exports them for Fulcrum",
    "author": "the Fulcrum authors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Fulcrum; File > Export > Fulcrum (.glb)",
    "category": "Import-Export",
}

ROLE, MATERIAL, NONE = "fulcrum_role", "fulcrum_material", "none"
ROLES = {"scene": "Touched with the tool", "tool": "Held in the hand", "decor": "Seen only"}
MATERIALS = ("enamel", "rubber", "steel", "wood")  # The names of the files in Fulcrum's content/materials.
LEAST_M, MOST_M = 0.001, 5.0  # What is smaller or larger across was hardly meant for a hand.


def set_mark(objects, key, value):
    """Menus and scripts mark by this. NONE takes a mark away, and a material goes with the role that it belongs to."""
    for obj in objects:
        if value == NONE:
            obj.pop(key, None)
        else:
            obj[key] = value
        if obj.get(ROLE) != "scene":
            obj.pop(MATERIAL, None)


def markable(objects):
    """Those that can have a surface, of which an instance of a collection is one, and that this file may change."""
    surfaces = ("MESH", "CURVE", "SURFACE", "FONT", "META")
    return [o for o in objects if not o.library and (o.type in surfaces or o.instance_type == "COLLECTION")]


def pieces(depsgraph):
    """Each mesh that is seen, as modifiers leave it, with the object whose mark counts for it.

    Text and curves come as meshes here, and each instance by itself. What an instance of a collection shows has its mark;
    what a modifier or particles scatter has its own, or without one that of the object which scatters it.
    """
    for instance in depsgraph.object_instances:
        if instance.object.type != "MESH" or not instance.show_self:
            continue
        owners = [instance.object.original]
        if instance.is_instance and instance.parent:
            owners.insert(0 if instance.parent.type == "EMPTY" else 1, instance.parent.original)
        if instance.object.data.polygons or instance.object.mode == "EDIT":
            yield instance, next((owner for owner in owners if ROLE in owner), owners[0])


def metres_per_unit(scene):
    units = scene.unit_settings
    return 1.0 if units.system == "NONE" else units.scale_length  # Without units Blender ignores the scale, too.


def survey(context):
    """How many pieces have each role, sentences that forbid an export, and sentences that do not."""
    owners = [owner for _, owner in pieces(context.evaluated_depsgraph_get())]
    counts = {role: sum(owner.get(ROLE) == role for owner in owners) for role in ROLES}
    shown = dict.fromkeys(owners)  # Each once, in order.
    problems, notes = [], []
    for obj in (o for o in shown if ROLE in o):
        for key, known in ((ROLE, tuple(ROLES)), (MATERIAL, MATERIALS)):
            if key in obj and obj[key] not in known:
                problems.append("'%s' has the %s '%s', which is none of %s: choose one in the tab Fulcrum." % (
                    obj.name, key[len("fulcrum_"):], obj[key], ", ".join(known)))
        if MATERIAL in obj and obj[ROLE] != "scene":
            notes.append("'%s' has a material, which only the role scene takes: it is left out." % obj.name)
    if not any(ROLE in o for o in shown):
        problems.append("No visible object has a role: select what is touched, and then what is held, and choose its role "
                        "in the sidebar of the 3D view, in the tab Fulcrum.")
    elif not problems:
        for role, verb in (("scene", "touch"), ("tool", "hold")):
            if not counts[role]:
                problems.append("No visible object has the role %s, so that there is nothing to %s." % (role, verb))

    bare = [o for o in shown if ROLE not in o]
    counts["without a role"] = len(bare)
    absent = [o for o in context.scene.objects if ROLE in o and o not in shown]
    for words, objects in (
            ("Without a role, and left out", bare),
            ("The role is with the mesh, where it belongs to the object", [o for o in bare if o.data and ROLE in o.data]),
            ("With a role, but hidden and left out", [o for o in absent if not o.visible_get()]),
            ("With a role, but without a surface and left out", [o for o in absent if o.visible_get()])):
        if objects:
            names = ["'%s'" % o.name for o in objects]
            more = [] if len(names) < 5 else ["%d more" % (len(names) - 3)]
            notes.append("%s: %s." % (words, ", ".join(names[:3] + more if more else names)))
    scale = metres_per_unit(context.scene)
    if abs(scale - 1) > 1e-6:
        notes.append("The scene's unit scale is %.6g: one Blender unit becomes %.6g m, so that the file has the lengths "
                     "which Blender shows." % (scale, scale))
    return counts, problems, notes


def rigid_copy(instance, owner, scale):
    """An object in metres that stands where the piece is seen, with its marks, and with neither scale nor shear.

    Those go into the mesh: the nodes of glTF have no shear, and Blender's exporter knows no unit scale.
    """
    # Without further arguments it copies what is seen; preserving all layers would go back to before the modifiers, of
    # which what they scatter knows nothing.
    mesh = bpy.data.meshes.new_from_object(instance.object)
    for index, slot in enumerate(instance.object.original.material_slots):
        if slot.link == "OBJECT" and index < len(mesh.materials):
            mesh.materials[index] = slot.material  # It is the object's own, of which the new mesh knows nothing.
    world = Matrix.Scale(scale, 4) @ instance.matrix_world
    position, orientation, _ = world.decompose()
    pose = Matrix.Translation(position) @ orientation.to_matrix().to_4x4()
    rest = pose.inverted() @ world
    mesh.transform(rest)
    if rest.determinant() < 0:
        mesh.flip_normals()  # A mirror turns a surface inside out.
    copy = bpy.data.objects.new(instance.object.name, mesh)
    copy.matrix_world = pose
    set_mark([copy], ROLE, owner[ROLE])
    set_mark([copy], MATERIAL, owner.get(MATERIAL, NONE))
    return copy


def look_at(copies):
    """Sentences about the copies, a list of (object, name), and how far scene and tool reach."""
    notes, sizes = [], {}
    for role in ("scene", "tool"):
        corners = []
        for copy, name in (each for each in copies if each[0][ROLE] == role):
            corners += [copy.matrix_world @ Vector(corner) for corner in copy.bound_box]
            solid = bmesh.new()
            solid.from_mesh(copy.data)
            bmesh.ops.remove_doubles(solid, verts=solid.verts, dist=1e-7)
            edges = sum(len(edge.link_faces) % 2 for edge in solid.edges)
            solid.free()
            if edges:
                notes.append("'%s' is not closed (%d open edges), so that it can be seen and hardly be touched: close it, "
                             "give it thickness, or give it the role decor." % (name, edges))
        sizes[role] = max(max(c[axis] for c in corners) - min(c[axis] for c in corners) for axis in range(3))
        if not LEAST_M <= sizes[role] <= MOST_M:
            notes.append("The %s is %.3g m across, which was hardly meant: if it was made in another unit, scale it, or "
                         "set the scene's unit scale." % (role, sizes[role]))
    return notes, sizes


def write(window, copies, file):
    """Lets Blender's exporter write the copies, in a scene of their own so that nothing else gets into the file."""
    options = dict(
        filepath=file, export_format="GLB", use_active_scene=True, use_visible=True, export_extras=True, export_yup=True,
        export_current_frame=True, export_animations=False, export_skins=False, export_morph=False,
        export_cameras=False, export_lights=False, export_colors=True, export_vertex_color="ACTIVE")
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()  # Versions of Blender differ in them.
    before, view_layer = window.scene, window.view_layer
    scene = bpy.data.scenes.new("Fulcrum")
    scene.camera = before.camera
    try:
        # Without the cameras views through them would leave them. They are not exported, nor what hangs on them unseen.
        for obj in [copy for copy, _ in copies] + [obj for obj in before.objects if obj.type == "CAMERA"]:
            scene.collection.objects.link(obj)
        window.scene = scene
        bpy.ops.export_scene.gltf(**{key: value for key, value in options.items() if key in known})
    finally:
        window.scene, window.view_layer = before, view_layer
        bpy.data.scenes.remove(scene)

    # Two objects in Blender cannot have one name, so that the nodes get the names of what was copied here: in the JSON
    # behind a header of 12 bytes and one of 8, before the rest.
    names = {copy.name: name for copy, name in copies}
    with open(file, "rb") as source:
        data = source.read()
    end = 20 + int.from_bytes(data[12:16], "little")
    tree = json.loads(data[20:end])
    if sum("mesh" in node for node in tree.get("nodes", [])) != len(copies):
        raise RuntimeError("it left out an object")
    for node in tree["nodes"]:
        node["name"] = tree["meshes"][node["mesh"]]["name"] = names[node["name"]]
    text = json.dumps(tree, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(file, "wb") as target:
        target.write(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(data) - end, len(text), b"JSON"))
        target.write(text + data[end:])


def export(context, target):
    """Writes what is marked, and gives sentences about it. A file that is there stays until all has gone well."""
    scale = metres_per_unit(context.scene)
    copies = []
    try:
        for instance, owner in pieces(context.evaluated_depsgraph_get()):
            if ROLE in owner:
                copy = rigid_copy(instance, owner, scale)
                copies.append((copy, instance.object.name))
        notes, sizes = look_at(copies)
        with tempfile.TemporaryDirectory(prefix=".fulcrum-", dir=os.path.dirname(target)) as folder:
            file = os.path.join(folder, "export.glb")
            write(context.window, copies, file)
            os.replace(file, target)
    finally:
        bpy.data.batch_remove([copy.data for copy, _ in copies] + [copy for copy, _ in copies])
    return notes, "%d objects are in %s: the scene is %.3g m across, the tool %.3g m." % (
        len(copies), os.path.basename(target), sizes["scene"], sizes["tool"])


class ExportFulcrum(bpy.types.Operator, ExportHelper):
    """Export the visible objects that have a role, for Fulcrum"""

    bl_idname = "export_scene.fulcrum"
    bl_label = "Export for Fulcrum"
    filename_ext = ".glb"
    filter_glob: bpy.props.StringProperty(default="*.glb", options={"HIDDEN"})

    def refuse(self, *problems):
        for problem in problems:
            self.report({"ERROR"}, problem)
        return {"CANCELLED"}

    def invoke(self, context, event):
        problems = survey(context)[1]  # Nobody should choose a file in vain.
        return self.refuse(*problems) if problems else ExportHelper.invoke(self, context, event)

    def execute(self, context):
        target = os.path.realpath(bpy.path.ensure_ext(bpy.path.abspath(self.filepath), ".glb"))
        if os.path.exists(target) and not os.access(target, os.W_OK):
            return self.refuse("'%s' is write-protected: choose another name." % target)
        if not hasattr(bpy.types, "EXPORT_SCENE_OT_gltf") or not importlib.util.find_spec("numpy"):
            return self.refuse("Blender's own glTF exporter is missing: tick 'Import-Export: glTF 2.0 format' in Edit > "
                               "Preferences > Add-ons. In Debian it needs the package python3-numpy, too.")
        active = context.view_layer.objects.active
        mode = active.mode if active else "OBJECT"
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")  # What is being edited gets into the object.
        try:
            _, problems, notes = survey(context)
            if problems:
                return self.refuse(*problems)
            more, done = export(context, target)
        except OSError as error:
            return self.refuse("'%s' cannot be written: %s." % (target, error.strerror or error))
        except RuntimeError as error:  # The reason is the last line but for that which says where.
            lines = [line for line in str(error).splitlines() if line and not line.startswith("Location:")]
            return self.refuse("Blender's own glTF exporter failed: %s." % lines[-1].rstrip("."))
        finally:
            if mode != "OBJECT":
                bpy.ops.object.mode_set(mode=mode)
        for note in notes + more:
            self.report({"WARNING"}, note)
        self.report({"INFO"}, done)
        return {"FINISHED"}


class MarkRole(bpy.types.Operator):
    """Say what the selected objects are in the exercise"""

    bl_idname = "object.fulcrum_role"
    bl_label = "Role"
    bl_options = {"REGISTER", "UNDO"}
    role: bpy.props.EnumProperty(
        name="Role",
        items=[(role, role.capitalize(), text) for role, text in ROLES.items()] + [(NONE, "None", "Not exported")])

    def execute(self, context):
        set_mark(markable(context.selected_objects), ROLE, self.role)
        return {"FINISHED"}


class MarkMaterial(bpy.types.Operator):
    """Say what a blow on the selected objects sounds and feels like, where they have the role scene"""

    bl_idname = "object.fulcrum_material"
    bl_label = "Material"
    bl_options = {"REGISTER", "UNDO"}
    material: bpy.props.EnumProperty(
        name="Material",
        items=[(name, name.capitalize(), "A blow is as on " + name) for name in MATERIALS] + [(NONE, "None", "Not said")])

    def execute(self, context):
        touched = [o for o in markable(context.selected_objects) if o.get(ROLE) == "scene"]
        if not touched:
            self.report({"ERROR"}, "Only what is touched has a material: give it the role scene first.")
            return {"CANCELLED"}
        set_mark(touched, MATERIAL, self.material)
        return {"FINISHED"}


class FulcrumPanel(bpy.types.Panel):
    bl_idname = "VIEW3D_PT_fulcrum"
    bl_label = "Fulcrum"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Fulcrum"

    def draw(self, context):
        objects = markable(context.selected_objects)
        menus = self.layout.column(align=True)
        menus.enabled = bool(objects)
        for name, key in (("role", ROLE), ("material", MATERIAL)):
            values = {str(obj.get(key, NONE)) for obj in objects}
            now = "" if not values else values.pop() if len(values) == 1 else "several"
            menus.operator_menu_enum("object." + key, name, text=name.capitalize() + ": " + now)
        counts, problems, notes = survey(context)
        box = self.layout.box().column(align=True)
        for key, count in counts.items():
            box.label(text="%s: %d" % (key.capitalize(), count))
        letters = max(16, int(context.region.width / context.preferences.system.ui_scale) // 9)
        for icon, sentences in (("ERROR", problems), ("INFO", notes)):
            for sentence in sentences:  # A label has one line, so that a sentence is several.
                column = self.layout.column(align=True)
                for number, line in enumerate(textwrap.wrap(sentence, letters)):
                    column.label(text=line, icon="BLANK1" if number else icon)
        self.layout.operator("export_scene.fulcrum", icon="EXPORT")


def menu(self, _context):
    self.layout.operator("export_scene.fulcrum", text="Fulcrum (.glb)")


CLASSES = (MarkRole, MarkMaterial, ExportFulcrum, FulcrumPanel)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.TOPBAR_MT_file_export.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu)
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)


if __name__ == "__main__":  # blender --python fulcrum_blender.py
    register()
