"""A material of Blender's Cycles from a folder of `sunbeam export --format osl`, and a test picture: needs bpy, or Blender itself.

    sunbeam export elaphe-like --format osl --output elaphe
    python3 blender_material.py elaphe spheres.png
    blender --background --python blender_material.py -- elaphe spheres.png

draws a sphere under a sun and one under a lamp that has an area, and prints how bright the sun's light is by the two ways in which
the shader has it: as a mirror whose direction is drawn, and as a color.

    sunbeam mesh snake --texture xenopeltis --output snake.glb
    python3 blender_material.py xenopeltis snake.png snake.glb

draws the snake closely, with the diffracted light added to the material of the file.
"""

import math
import os
import sys

import bpy
import numpy as np
from mathutils import Vector

# Where the package bpy has what it asks shaders with.
sys.path.append(os.path.join(bpy.utils.resource_path("LOCAL"), "python/lib/python%d.%d/site-packages" % sys.version_info[:2]))

SUN = (0.3, -0.5, 0.8)
# Wider than the real one: less noise.
SUN_DEGREES = 2
# Of one sample a pixel; 20 % at 64.
NOISE_PERCENT = 160


def add_shader(tree, folder, sun):
    """Adds the exported shader with the tangents of the mesh and the sun's direction in the world, if any."""
    nodes, links = tree.nodes, tree.links
    script = nodes.new("ShaderNodeScript")
    script.mode, script.filepath = "EXTERNAL", os.path.abspath(os.path.join(folder, "sunbeam.osl"))
    if "Table" not in script.inputs:
        sys.exit("Blender cannot compile " + script.filepath)
    script.inputs["Table"].default_value = os.path.abspath(os.path.join(folder, "sunbeam.exr"))
    tangent = nodes.new("ShaderNodeTangent")
    tangent.direction_type = "UV_MAP"
    links.new(tangent.outputs[0], script.inputs["Tangent"])
    if sun:
        script.inputs["Light"].default_value, script.inputs["Angle"].default_value = sun, SUN_DEGREES
    return script


def material(folder, sun=None, by_color=False):
    """Has the sun's light as a color without noise and shadows, or reflected."""
    made = bpy.data.materials.new("Sunbeam")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    script = add_shader(made.node_tree, folder, sun)
    surface = script.outputs["BSDF"]
    if by_color:
        emission = nodes.new("ShaderNodeEmission")
        links.new(script.outputs["Color"], emission.inputs["Color"])
        surface = emission.outputs[0]
    links.new(surface, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return made


def scene(width, height, samples, denoised):
    """An empty scene that compiles shaders."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    made = bpy.context.scene
    made.render.engine, made.cycles.device, made.cycles.shading_system = "CYCLES", "CPU", True
    made.cycles.samples, made.cycles.use_denoising, made.cycles.use_adaptive_sampling = samples, denoised, False
    made.render.resolution_x, made.render.resolution_y = width, height
    made.view_settings.view_transform = "Standard"
    return made


def camera(position, target, degrees):
    bpy.ops.object.camera_add(location=position)
    made = bpy.context.object
    made.rotation_euler = (Vector(target) - made.location).to_track_quat("-Z", "Y").to_euler()
    made.data.angle, made.data.clip_start = math.radians(degrees), 0.01
    bpy.context.scene.camera = made


def lamp(kind, direction, strength, **settings):
    distance = 5 / math.dist(direction, (0, 0, 0))
    bpy.ops.object.light_add(type=kind, location=[distance * x for x in direction])
    made = bpy.context.object
    made.rotation_euler = made.location.to_track_quat("Z", "Y").to_euler()
    made.data.energy = strength
    for name, value in settings.items():
        setattr(made.data, name, value)


def drawn(folder, lamps, side, samples, denoised=False, **settings):
    """Linear red, green, blue of a sphere, from the lowest row on."""
    made = scene(side, side, samples, denoised)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64)
    bpy.ops.object.shade_smooth()
    camera((0, -8, 5.6), (0, 0, 0), 13)
    bpy.data.objects["Sphere"].data.materials.append(material(folder, **settings))
    for kind, direction, strength, more in lamps:
        lamp(kind, direction, strength, **more)
    made.render.image_settings.file_format, made.render.image_settings.color_depth = "OPEN_EXR", "32"
    made.render.filepath = os.path.join(bpy.app.tempdir, "sunbeam.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(made.render.filepath)
    pixels = np.empty(4 * side * side, np.float32)
    image.pixels.foreach_get(pixels)
    os.remove(made.render.filepath)
    return pixels.reshape(side, side, 4)[..., :3]


def add_diffraction(made, folder, sun, strength):
    """Adds the sun's diffracted light to a material of a glTF file, on the normals of its normal map."""
    nodes, links = made.node_tree.nodes, made.node_tree.links
    script = add_shader(made.node_tree, folder, sun)
    script.inputs["Scale"].default_value, script.inputs["Candidates"].default_value = strength, 1
    links.new(nodes["Normal Map"].outputs[0], script.inputs["Normal"])
    emission, both = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeAddShader")
    links.new(script.outputs["Color"], emission.inputs["Color"])
    links.new(nodes["Principled BSDF"].outputs[0], both.inputs[0])
    links.new(emission.outputs[0], both.inputs[1])
    links.new(both.outputs[0], nodes["Material Output"].inputs["Surface"])


def draw_snake(folder, mesh, output):
    """The view of Sunbeam's scene close-up."""
    made, sun = scene(640, 400, 16, True), (0.883, -0.321, 0.342)
    bpy.ops.import_scene.gltf(filepath=mesh)
    add_diffraction(bpy.data.materials[0], folder, sun, 16)
    camera((0.02, -0.4, 0.36), (-0.01, -0.073, 0.02), 3.2)
    lamp("SUN", sun, 3, angle=math.radians(SUN_DEGREES))
    made.world = bpy.data.worlds.new("Sky")
    made.world.color = (0.15, 0.17, 0.2)
    made.render.filepath = os.path.abspath(output)
    bpy.ops.render.render(write_still=True)


def write(pixels, output):
    """Tone-mapped, by Blender itself."""
    rows, columns, _ = pixels.shape
    image = bpy.data.images.new("picture", columns, rows)
    pixels = np.concatenate([(1 - np.exp(-pixels)) ** (1 / 2.2), np.ones((rows, columns, 1))], 2)
    image.pixels.foreach_set(pixels.astype(np.float32).ravel())
    image.filepath_raw, image.file_format = os.path.abspath(output), "PNG"
    image.save()


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    if len(arguments) not in (2, 3, 4):
        sys.exit(__doc__)
    if len(arguments) == 3:
        sys.exit(draw_snake(arguments[0], arguments[2], arguments[1]))
    folder, output, side, samples = *arguments[:2], *map(int, arguments[2:] or (200, 64))
    color = drawn(folder, [], side, 16, sun=SUN, by_color=True)
    mirror = drawn(folder, [("SUN", SUN, 1, {"angle": math.radians(SUN_DEGREES)})], min(side, 48), samples, sun=SUN)
    area = drawn(folder, [("AREA", (2, -3, 5), 100, {"size": 2})], side, samples, denoised=True)
    percent = 100 * abs(mirror.mean() / color.mean() - 1)
    kind = "noise" if percent < NOISE_PERCENT / math.sqrt(samples) else "difference"
    print("the sun's light: drawn %.5g, as a color %.5g, %.0f %% %s at %d samples" % (mirror.mean(), color.mean(), percent, kind, samples))
    write(np.concatenate([image * 3 / np.quantile(image[image > 0], 0.98) for image in (color, area)], 1), output)
