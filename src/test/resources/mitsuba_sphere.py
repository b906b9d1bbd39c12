"""Draws mitsuba-sphere.png, the photograph of CompareTest: a sphere in sunlight by Mitsuba 3's path tracer, with alpha, 16 bits, sRGB's curve.

    sunbeam export elaphe-like --coherence-length 8um --size 100MB --tolerance 0.01 --format npz --output elaphe.npz
    PYTHONPATH=docs/examples python3 src/test/resources/mitsuba_sphere.py elaphe.npz src/test/resources/mitsuba-sphere.png

White is 1 / 17 of a mirror's light, so that few pixels are clipped.
"""

import sys

import mitsuba as mi
import numpy as np

import mitsuba_bsdf

table, output = sys.argv[1:]
look = mi.ScalarTransform4f().look_at(origin=[0, -8, 5.6], target=[0, 0, 0], up=[0, 0, 1])
film = {"type": "hdrfilm", "width": 64, "height": 48, "pixel_format": "rgba", "rfilter": {"type": "box"}}
scene = mi.load_dict({
    "type": "scene",
    "integrator": {"type": "path", "max_depth": 3},
    "sensor": {"type": "perspective", "fov": 13, "fov_axis": "y", "to_world": look, "film": film,
               "sampler": {"type": "independent", "sample_count": 4096}},
    "sphere": {"type": "sphere", "bsdf": {"type": "sunbeam", "filename": table}},
    "sun": {"type": "directional", "direction": [-0.3, 0.5, -0.8], "irradiance": 1.0},
})
image = np.array(mi.render(scene))
# From BRDF times cosine to rho, which a mirror along the normal has of 1.
image[..., :3] *= 17 / scene.shapes()[0].bsdf().scale
bitmap = mi.Bitmap(image.astype(np.float32), mi.Bitmap.PixelFormat.RGBA)
bitmap.convert(mi.Bitmap.PixelFormat.RGBA, mi.Struct.Type.UInt16, True).write(output)
