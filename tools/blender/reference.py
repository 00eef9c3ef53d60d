"""Draws what `fulcrum workprecision picture --describe FOLDER` has written, by Blender's path tracer.

    blender -b --factory-startup --python reference.py -- DESCRIBED REFERENCES [SAMPLES]

For each DESCRIBED/NAME.json and NAME.bin: REFERENCES/NAME.png, the radiance of the scene as engine/render/radiance_png.h
reads it, and NAME.json, which says of what. tools/references does all of it.

Fulcrum's (x, y, z) is Blender's (x, -z, y). A light of intensity I is a sun of strength pi I, as wide as a disc
of its diameter a metre away. Intensity is irradiance / pi at one metre, and a lamp of P watts has P / 4 pi of radiant
intensity, so that one that a model brings is a lamp of 4 pi^2 I watts; it is a point, and throws the shadow that Fulcrum
leaves out. The material is that of glTF 2.0, appendix B: a matt layer below a reflecting one, or a metal.
Surfaces have one side: their backs are not seen, but keep light off.
"""
import json
import math
import os
import struct
import sys
import tempfile
import zlib

import bpy
import numpy as np
from mathutils import Matrix, Vector

WIDTH, HEIGHT = 640, 360
KEPT_BITS = 11  # of the 16: what is below is noise, which no file gets smaller with
TURN = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def turned(v):
    return (TURN @ Vector((*v, 1.0))).to_3d()


def mesh_of(entry, data):
    def floats(name, per):
        first, count = entry[name]
        return np.frombuffer(data, "<f4", count * per, first).reshape(count, per)

    positions, normals = floats("positions", 3), floats("normals", 3)
    first, count = entry["indices"]
    indices = np.frombuffer(data, "<u4", count, first).astype(np.int32)
    mesh = bpy.data.meshes.new("mesh")
    mesh.vertices.add(len(positions))
    mesh.vertices.foreach_set("co", positions.ravel())
    mesh.loops.add(count)
    mesh.loops.foreach_set("vertex_index", indices)
    mesh.polygons.add(count // 3)
    mesh.polygons.foreach_set("loop_start", np.arange(0, count, 3, dtype=np.int32))
    mesh.polygons.foreach_set("loop_total", np.full(count // 3, 3, dtype=np.int32))
    mesh.polygons.foreach_set("use_smooth", np.ones(count // 3, dtype=bool))
    colours = mesh.color_attributes.new("colours", "FLOAT_COLOR", "POINT")
    rgba = np.ones((len(positions), 4), dtype=np.float32)
    if entry["colours"][1]:
        rgba[:, :3] = floats("colours", 3)
    colours.data.foreach_set("color", rgba.ravel())
    if "uv" in entry:
        corners = floats("uv", 4)[indices]
        for which in (0, 1):  # Blender's v grows upwards
            places = np.stack((corners[:, 2 * which], 1 - corners[:, 2 * which + 1]), axis=1)
            mesh.uv_layers.new(name=f"uv{which}").data.foreach_set("uv", places.ravel())
    mesh.update()
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.pi
    mesh.normals_split_custom_set_from_vertices(normals.tolist())
    return mesh


def image_of(number, entry, data):
    width, height = entry["width"], entry["height"]
    rows = np.frombuffer(data, np.uint8, width * height * 4, entry["first"]).reshape(height, width, 4)
    image = bpy.data.images.new(f"picture {number}", width, height, alpha=True)
    image.colorspace_settings.name = "sRGB" if entry["srgb"] else "Non-Color"
    image.pixels.foreach_set((rows[::-1].astype(np.float32) / 255).ravel())
    image.update()
    return image


def material_of(entry, images):
    material = bpy.data.materials.new(entry["name"])
    material.use_nodes = True
    material.cycles.use_transparent_shadow = False  # light is kept off by whatever it meets
    nodes, link = material.node_tree.nodes, material.node_tree.links.new
    nodes.clear()

    def node(kind, **inputs):
        made = nodes.new("ShaderNode" + kind)
        for name, value in inputs.items():
            socket = made.inputs[name.replace("_", " ")] if not name.startswith("at") else made.inputs[int(name[2:])]
            if isinstance(value, bpy.types.NodeSocket):
                link(value, socket)
            else:
                socket.default_value = value
        return made

    def math_node(operation, *values):
        made = node("Math", **{f"at{i}": value for i, value in enumerate(values)})
        made.operation = operation
        return made.outputs[0]

    def picture(layer):
        """Where a picture's layer has its colours."""
        at = node("UVMap")
        at.uv_map = f"uv{layer['uv_set']}"
        split = node("SeparateXYZ", Vector=at.outputs["UV"])
        u, v = split.outputs["X"], math_node("SUBTRACT", 1.0, split.outputs["Y"])

        def along(row):
            return math_node("ADD", math_node("ADD", math_node("MULTIPLY", row[0], u),
                                              math_node("MULTIPLY", row[1], v)), row[2])

        place = node("CombineXYZ", X=along(layer["u"]), Y=math_node("SUBTRACT", 1.0, along(layer["v"])))
        made = node("TexImage", Vector=place.outputs["Vector"])
        made.image = images[layer["picture"]]
        made.extension = "REPEAT" if layer["repeats"] else "EXTEND"
        return made.outputs["Color"]

    pictures = entry.get("pictures", {})
    roughness, metallic = entry["roughness"], entry["metallic"]
    if "finish" in pictures:
        finish = node("SeparateRGB", Image=picture(pictures["finish"]))
        roughness = math_node("MULTIPLY", finish.outputs["G"], roughness)
        roughness = math_node("MAXIMUM", roughness, 0.045)
        metallic = math_node("MULTIPLY", finish.outputs["B"], metallic)
    else:
        roughness = max(roughness, 0.045)  # as surface.glsl has it
    relief = {}
    if "relief" in pictures:
        bent = node("NormalMap", Strength=pictures["relief"]["scale"], Color=picture(pictures["relief"]))
        bent.uv_map = f"uv{pictures['relief']['uv_set']}"
        relief = {"Normal": bent.outputs["Normal"]}
    attribute = node("Attribute")
    attribute.attribute_name = "colours"
    tinted = node("MixRGB", Fac=1.0, Color1=attribute.outputs["Color"], Color2=(*entry["base_colour"], 1.0))
    tinted.blend_type = "MULTIPLY"
    base = tinted.outputs["Color"]
    if "colour" in pictures:
        painted = node("MixRGB", Fac=1.0, Color1=base, Color2=picture(pictures["colour"]))
        painted.blend_type = "MULTIPLY"
        base = painted.outputs["Color"]

    def reflecting(**inputs):
        made = node("BsdfPrincipled", Roughness=roughness, Specular=0.5, **inputs, **relief)
        made.distribution = "GGX"
        return made.outputs["BSDF"]

    def spread(distance):
        """What is below the coat where light spreads there."""
        # Of Cycles, a radius is 4 pi of Burley's d: so it draws a half lit floor, to 1 %, of whatever colour.
        made = node("SubsurfaceScattering", Color=base, Scale=4 * math.pi, Radius=distance, **relief)
        made.falloff = "BURLEY"
        return made.outputs["BSSRDF"]

    def matt():
        coat = reflecting(Base_Color=(0, 0, 0, 1))  # 0.04 where it is looked at straight
        distance = entry.get("scatter_distance")
        below = node("MixShader", at0=node("Fresnel", IOR=1.5, **relief).outputs["Fac"],
                     at1=spread(distance) if distance else node("BsdfDiffuse", Color=base, **relief).outputs["BSDF"])
        return node("AddShader", at0=below.outputs["Shader"], at1=coat).outputs["Shader"]

    def metal():
        return reflecting(Base_Color=base, Metallic=1.0)

    if metallic in (0, 1):
        surface = metal() if metallic else matt()
    else:
        surface = node("MixShader", at0=metallic, at1=matt(), at2=metal()).outputs["Shader"]
    # A camera sees through what it sees from behind.
    behind = node("Math", at0=node("LightPath").outputs["Is Camera Ray"], at1=node("NewGeometry").outputs["Backfacing"])
    behind.operation = "MULTIPLY"
    shown = node("MixShader", at0=behind.outputs[0], at1=surface,
                 at2=node("BsdfTransparent").outputs["BSDF"])
    node("OutputMaterial", Surface=shown.outputs["Shader"])
    return material


def add_world(entry, data):
    first, width, height = entry["first"], entry["width"], entry["height"]
    rows = np.frombuffer(data, "<f4", width * height * 3, first).reshape(height, width, 3)
    # Blender's picture begins at its bottom, and has +x in its middle, where ours has +z.
    rows = np.roll(rows[::-1], width // 4, axis=1)
    rgba = np.ones((height, width, 4), dtype=np.float32)
    rgba[:, :, :3] = rows
    image = bpy.data.images.new("around", width, height, float_buffer=True)
    image.colorspace_settings.name = "Linear"
    image.pixels.foreach_set(rgba.ravel())
    image.update()
    world = bpy.data.worlds.new("around")
    bpy.context.scene.world = world
    world.use_nodes = True
    tree = world.node_tree
    picture = tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = image
    tree.links.new(picture.outputs["Color"], tree.nodes["Background"].inputs["Color"])


def add_light(entry):
    spot = entry["kind"] == "spot"
    light = bpy.data.lights.new("key", "SPOT" if spot else "SUN")
    light.color = entry["colour"]
    light.use_shadow = True
    radius = entry["diameter"] / 2
    if spot:
        half = entry["cone_rad"] / 2
        light.spot_size = entry["cone_rad"]
        light.spot_blend = (math.cos(0.8 * half) - math.cos(half)) / (1 - math.cos(half))
        light.energy = 4 * math.pi * math.pi * entry["intensity"] * (1 + radius * radius)
        light.shadow_soft_size = radius
    else:
        light.energy = math.pi * entry["intensity"]
        light.angle = 2 * math.atan(radius)
    lamp = bpy.data.objects.new("key", light)
    towards = turned(entry["direction"]).normalized()
    lamp.matrix_world = towards.to_track_quat("-Z", "Y").to_matrix().to_4x4()
    lamp.location = turned(entry["position"])
    bpy.context.collection.objects.link(lamp)


def add_model_light(entry):
    """One of KHR_lights_punctual."""
    towards = turned(entry["direction"])
    if entry["kind"] == "directional":
        light = bpy.data.lights.new("model's", "SUN")
        light.energy, light.angle = math.pi * entry["intensity"], 0.0
    else:
        light = bpy.data.lights.new("model's", "POINT")
        light.energy, light.shadow_soft_size = 4 * math.pi * math.pi * entry["intensity"], 0.0
        fade(light, entry, towards.normalized())
    light.color = entry["colour"]
    lamp = bpy.data.objects.new("model's", light)
    lamp.matrix_world = towards.to_track_quat("-Z", "Y").to_matrix().to_4x4()
    lamp.location = turned(entry["position"])
    bpy.context.collection.objects.link(lamp)


def fade(light, entry, towards):
    """By the extension's formulas: a spot from its inner to its outer cone, and all towards the range."""
    light.use_nodes = True
    nodes, link = light.node_tree.nodes, light.node_tree.links.new

    def calculated(operation, *values):
        made = nodes.new("ShaderNodeMath")
        made.operation = operation
        for socket, value in zip(made.inputs, values):
            if isinstance(value, bpy.types.NodeSocket):
                link(value, socket)
            else:
                socket.default_value = value
        return made.outputs[0]

    part = calculated("ADD", 1.0, 0.0)
    if entry["kind"] == "spot":
        cosine = nodes.new("ShaderNodeVectorMath")
        cosine.operation = "DOT_PRODUCT"
        link(nodes.new("ShaderNodeNewGeometry").outputs["Incoming"], cosine.inputs[0])  # from the lamp to what it lights
        cosine.inputs[1].default_value = towards
        inner, outer = math.cos(entry["inner_cone_rad"]), math.cos(entry["outer_cone_rad"])
        within = calculated("DIVIDE", calculated("SUBTRACT", cosine.outputs["Value"], outer), max(inner - outer, 0.001))
        within = calculated("MINIMUM", calculated("MAXIMUM", within, 0.0), 1.0)
        part = calculated("MULTIPLY", within, within)
    if entry["range"] is not None:
        away = calculated("DIVIDE", nodes.new("ShaderNodeLightPath").outputs["Ray Length"], entry["range"])
        part = calculated("MULTIPLY", part, calculated("MAXIMUM", calculated("SUBTRACT", 1.0, calculated("POWER", away, 4.0)), 0.0))
    link(part, nodes["Emission"].inputs["Strength"])


def add_camera(entry):
    eye, target = Vector(entry["eye"]), Vector(entry["target"])
    back = (eye - target).normalized()
    up = Vector((0, 0, -1)) if abs(back.y) > 0.9999 else Vector((0, 1, 0))
    right = up.cross(back).normalized()
    pose = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    pose.translation = eye
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = entry["vertical_fov_rad"]
    camera.clip_start, camera.clip_end = min(0.005, 0.05 * (eye - target).length), 1000.0
    holder = bpy.data.objects.new("camera", camera)
    holder.matrix_world = TURN @ pose
    bpy.context.collection.objects.link(holder)
    bpy.context.scene.camera = holder


def build(scene, data):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    meshes = [mesh_of(entry, data) for entry in scene["meshes"]]
    images = [image_of(number, entry, data) for number, entry in enumerate(scene.get("pictures", []))]
    materials = [material_of(entry, images) for entry in scene["materials"]]
    for entry in scene["instances"]:
        thing = bpy.data.objects.new(entry["name"], meshes[entry["mesh"]])
        thing.matrix_world = TURN @ Matrix([entry["X_WM"][i::4] for i in range(4)])
        bpy.context.collection.objects.link(thing)
        if not thing.data.materials:
            thing.data.materials.append(None)
        thing.material_slots[0].link = "OBJECT"
        thing.material_slots[0].material = materials[entry["material"]]
    add_world(scene["around"], data)
    # What is seen of it belongs to the reference; a background does not.
    bpy.context.scene.render.film_transparent = not scene["around"]["seen"]
    if scene["key_light"]:
        add_light(scene["key_light"])
    for entry in scene.get("lights", []):
        add_model_light(entry)
    add_camera(scene["camera"])


def draw(samples, seed):
    """(HEIGHT x WIDTH x 4) rows from the top: linear, times alpha."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = WIDTH, HEIGHT, 100
    cycles = scene.cycles
    cycles.device, cycles.seed = "CPU", seed
    cycles.samples, cycles.use_adaptive_sampling = samples, True
    cycles.adaptive_threshold, cycles.adaptive_min_samples = 0.004, min(128, samples)
    cycles.use_denoising = False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    with tempfile.TemporaryDirectory() as box:
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_depth = "32"
        scene.render.image_settings.color_mode = "RGBA"
        scene.render.filepath = os.path.join(box, "drawn.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        pixels = np.empty(WIDTH * HEIGHT * 4, dtype=np.float32)
        image.pixels.foreach_get(pixels)
    return pixels.reshape(HEIGHT, WIDTH, 4)[::-1]


def encoded(pixels):
    """As engine/render/radiance_png.h has it, the last bits rounded away."""
    colour = np.maximum(pixels[:, :, :3].astype(np.float64), 0)
    values = np.sqrt(colour / (1 + colour.max(axis=2, keepdims=True)))
    step = 1 << (16 - KEPT_BITS)
    kept = np.minimum(np.round(values * 65535 / step), (1 << KEPT_BITS) - 1) * step
    alpha = np.round(np.clip(pixels[:, :, 3:], 0, 1) * 255) * 257
    return np.concatenate((kept, alpha), axis=2).astype(">u2")


def write_png(path, values):
    """PNG (ISO/IEC 15948), each row by the filter that leaves the least."""
    height, width, channels = values.shape
    rows = np.frombuffer(values.tobytes(), np.uint8).reshape(height, -1).astype(np.int16)
    size = 2 * channels
    left = np.zeros_like(rows)
    left[:, size:] = rows[:, :-size]
    above = np.zeros_like(rows)
    above[1:] = rows[:-1]
    corner = np.zeros_like(rows)
    corner[:, size:] = above[:, :-size]
    guess = left + above - corner
    far = [abs(guess - each) for each in (left, above, corner)]
    paeth = np.where((far[0] <= far[1]) & (far[0] <= far[2]), left, np.where(far[1] <= far[2], above, corner))
    tried = [(rows - each) & 255 for each in (np.zeros_like(rows), left, above, (left + above) >> 1, paeth)]
    cost = np.array([np.minimum(each, 256 - each).sum(axis=1) for each in tried])
    lines = b"".join(bytes([best]) + tried[best][row].astype(np.uint8).tobytes()
                     for row, best in enumerate(cost.argmin(axis=0)))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 6, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def main(described, references, samples=2048, seed=0):
    for name in sorted(os.listdir(described)):
        stem, ending = os.path.splitext(name)
        if ending != ".json":
            continue
        with open(os.path.join(described, name), encoding="utf-8") as file:
            scene = json.load(file)
        with open(os.path.join(described, stem + ".bin"), "rb") as file:
            build(scene, file.read())
        write_png(os.path.join(references, stem + ".png"), encoded(draw(int(samples), int(seed))))
        said = {**scene["shot"], "samples": int(samples), "drawn_by": "Cycles, Blender " + bpy.app.version_string}
        with open(os.path.join(references, name), "w", encoding="utf-8") as file:
            json.dump(said, file, indent=1)
            file.write("\n")
        print("drawn:", stem, flush=True)


main(*sys.argv[sys.argv.index("--") + 1:])
