"""A Mitsuba 3 BSDF of a table of `sunbeam export`: mitsuba with variant llvm_ad_rgb (LLVM 17 or newer) or cuda_ad_rgb, and numpy.

    sunbeam export elaphe-like --format npz --output elaphe.npz
    python3 mitsuba_bsdf.py elaphe.npz                  checks it: chi-square test, white furnace, comparison with read_export.py
    python3 mitsuba_bsdf.py disc.npz disc.png           draws a disc under a square lamp and a sphere under the sun

In a scene: set the variant, import mitsuba_bsdf, then {"type": "sunbeam", "filename": "elaphe.npz"}. `scale` multiplies it: at 1 a flat
mirror reflects Schlick's share for an index of 1.5, 4 % along the normal. Colors are linear Rec. 709, clipped where they are negative.
The tangent is dp_du, which Mitsuba's meshes have constant in each triangle: colors of a coarse one look checkered (24 % off at the 95th
percentile where its sphere is 5 %); take its own shapes, or small triangles. All is dark below the surface and beyond the table's largest angle.

Directions are drawn from the table: over (u, v), the mean of Y over the slices of w that the given direction can meet (one in ten by
cosine), so that each order, the specular one too, is drawn as often as it has power. The density is exact.
"""

import json
import sys

import drjit as dr
import mitsuba as mi
import numpy as np

if mi.variant() is None:
    mi.set_variant("llvm_ad_rgb")

REC709 = np.array([[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]])
REFLECTANCE, WAVELENGTH = 0.04, 550e-9
COSINE_SHARE = 0.1
COSINES = np.linspace(0, 1, 9)


class Sunbeam(mi.BSDF):
    def __init__(self, props):
        super().__init__(props)
        with np.load(props["filename"]) as archive:
            table, metadata = archive["C"].astype(np.float32), json.loads(archive["metadata.json"])
        self.xyz = "X, Y, Z" in metadata["quantity"]
        axes = {axis["name"]: axis for axis in metadata["axes"]}
        self.first = [float(axes[name]["first"]) for name in "uvw"]
        self.step = [float(axes[name]["step"]) for name in "uvw"]
        self.count = [axes[name]["count"] for name in "uvw"]
        self.extent = [self.step[i] * (self.count[i] - 1) for i in range(2)]
        self.least_cosine = np.cos(np.radians(metadata["largest_angle_deg"]))
        # BRDF of docs/theory.md; a table of colors has no wavelength, so this takes the middle one.
        sigma = metadata["coherence_length_asked_m"] / 4
        self.scale = props.get("scale", 1.0) * REFLECTANCE * 4 * np.pi * sigma**2 / WAVELENGTH**2
        self.roots = mi.Float((np.sign(table) * np.sqrt(np.abs(table))).ravel())
        self.directions = self.tabulated(table)
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.Anisotropic
        self.m_components = [flags]
        self.m_flags = flags

    def tabulated(self, table):
        """Over (u, v), by the cosine of the given direction: the mean over all w that it meets."""
        power = np.maximum(0, table[..., 1] if self.xyz else table @ [0.2126, 0.7152, 0.0722])
        depth = -(self.first[2] + self.step[2] * np.arange(self.count[2]))
        u, v = [self.first[i] + self.step[i] * np.arange(self.count[i]) for i in range(2)]
        means = np.empty((len(COSINES), len(v), len(u)), np.float32)
        for mean, cosine in zip(means, COSINES):
            met = (depth > cosine - abs(self.step[2])) & (depth < cosine + 1 + abs(self.step[2]))
            reached = np.hypot(*np.meshgrid(u, v)) < 1 + np.sqrt(1 - cosine**2)
            mean[:] = reached * power[met if met.any() else slice(0, 1)].mean(0) + 1e-20
        return mi.MarginalContinuous2D1(means, [COSINES.tolist()])

    def color(self, uvw):
        """Linear Rec. 709: square roots are linear in u and v; their squares cubic through four slices of w."""
        place = [dr.clip((uvw[i] - self.first[i]) / self.step[i], 0, self.count[i] - 1) for i in range(3)]
        i, j = [mi.UInt32(dr.minimum(place[axis], self.count[axis] - 2)) for axis in range(2)]
        s, t = place[0] - i, place[1] - j
        first = mi.UInt32(dr.clip(dr.floor(place[2]) - 1, 0, self.count[2] - 4))
        at, columns, rows = place[2] - first, self.count[0], self.count[1]
        total = mi.Color3f(0)
        for n in range(4):
            base = ((first + n) * rows + j) * columns + i
            a, b, c, d = [dr.gather(mi.Color3f, self.roots, base + more) for more in (0, 1, columns, columns + 1)]
            root = dr.lerp(dr.lerp(a, b, s), dr.lerp(c, d, s), t)
            others = [m for m in range(4) if m != n]
            weight = dr.prod([(at - m) / (n - m) for m in others])
            total += weight * root * dr.abs(root)
        if self.xyz:
            total = dr.maximum(total, 0)
            total = mi.Color3f([sum(float(row[c]) * total[c] for c in range(3)) for row in REC709])
        return dr.maximum(total, 0)

    def eval(self, ctx, si, wo, active=True):
        """BRDF times the cosine of wo."""
        wi = si.wi
        half, cosines = 0.5 * dr.norm(wi + wo), wi.z + wo.z
        active &= dr.minimum(wi.z, wo.z) > max(self.least_cosine, 1e-6)
        k = 2 * half * half
        mask = dr.minimum(1, 2 * cosines * dr.minimum(wi.z, wo.z) / k)
        gain = (1 + 24 * dr.maximum(1 - half, 0) ** 5) * k * k / (cosines * cosines * wi.z) * mask
        return dr.select(active, self.scale * gain * self.color(-(wi + wo)), 0)

    def pdf(self, ctx, si, wo, active=True):
        uv = [-(si.wi[i] + wo[i]) for i in range(2)]
        place = mi.Point2f([(uv[i] - self.first[i]) / self.extent[i] for i in range(2)])
        inside = dr.all((place >= 0) & (place <= 1))
        density = self.directions.eval(dr.clip(place, 0, 1), [si.wi.z]) * wo.z / (self.extent[0] * self.extent[1])
        density = (1 - COSINE_SHARE) * dr.select(inside, density, 0) + COSINE_SHARE * wo.z / np.pi
        return dr.select(active & (si.wi.z > 0) & (wo.z > 0), density, 0)

    def sample(self, ctx, si, sample1, sample2, active=True):
        place, _ = self.directions.sample(sample2, [si.wi.z])
        x, y = [-(self.first[i] + self.extent[i] * place[i]) - si.wi[i] for i in range(2)]
        by_table = mi.Vector3f(x, y, dr.safe_sqrt(1 - x * x - y * y))
        wo = dr.select(sample1 < COSINE_SHARE, mi.warp.square_to_cosine_hemisphere(sample2), by_table)
        bs = dr.zeros(mi.BSDFSample3f)
        bs.wo, bs.eta, bs.sampled_type, bs.sampled_component = wo, 1.0, mi.UInt32(+self.m_flags), mi.UInt32(0)
        bs.pdf = self.pdf(ctx, si, wo, active)
        return bs, dr.select(bs.pdf > 0, self.eval(ctx, si, wo, active) / bs.pdf, 0)

    def eval_pdf(self, ctx, si, wo, active=True):
        return self.eval(ctx, si, wo, active), self.pdf(ctx, si, wo, active)

    def to_string(self):
        return "Sunbeam[u, v, w = %s]" % self.count


mi.register_bsdf("sunbeam", Sunbeam)


def furnace(bsdf, si, count):
    """What white light from everywhere becomes: means and their noise, of drawn directions and of others."""
    rng = mi.PCG32(size=count)
    square = mi.Point2f(rng.next_float32(), rng.next_float32())
    _, drawn = bsdf.sample(mi.BSDFContext(), si, rng.next_float32(), square)
    wo = mi.warp.square_to_cosine_hemisphere(square)
    plain = bsdf.eval(mi.BSDFContext(), si, wo) / mi.warp.square_to_cosine_hemisphere_pdf(wo)
    return [(np.mean(weights, 1), np.std(weights, 1) / np.sqrt(count)) for weights in (np.array(drawn), np.array(plain))]


def difference(filename, bsdf, si, count):
    """Median of what read_export.py says otherwise of the brightest channel, in directions that are drawn."""
    from read_export import color, gain

    with np.load(filename) as archive:
        table, metadata = archive["C"], json.loads(archive["metadata.json"])
    axes, wi = {axis["name"]: axis for axis in metadata["axes"]}, np.array(si.wi)[:, 0]
    rng = mi.PCG32(size=count)
    bs, _ = bsdf.sample(mi.BSDFContext(), si, rng.next_float32(), mi.Point2f(rng.next_float32(), rng.next_float32()))
    values, errors = np.array(bsdf.eval(mi.BSDFContext(), si, bs.wo)).T / bsdf.scale, []
    for wo, value in zip(np.array(bs.wo).T, values):
        exact = color(table, axes, -(wi + wo))
        exact = np.maximum(0, REC709 @ exact if bsdf.xyz else exact) * (gain(wo, wi) if wo[2] > 0 else 0)
        if exact.max() > 0:
            errors.append(np.abs(value - exact).max() / exact.max())
    return np.median(errors)


def functions(bsdf, wi):
    """Drawn directions and their density for the chi-square test. Mitsuba's BSDFAdapter leaves out directions of weight 0, which have a
    density, too: beside the sharp orders of a grating they are many."""

    def surface(count):
        si = dr.zeros(mi.SurfaceInteraction3f, count)
        si.wi = wi
        return si

    def sample(numbers):
        bs, _ = bsdf.sample(mi.BSDFContext(), surface(dr.width(numbers)), numbers[0], mi.Point2f(numbers[1], numbers[2]))
        return bs.wo, dr.select(bs.pdf > 0, mi.Float(1), 0)

    return sample, lambda wo: bsdf.pdf(mi.BSDFContext(), surface(dr.width(wo)), wo)


def check(filename, count=1000000):
    from mitsuba.chi2 import ChiSquareTest, SphericalDomain

    bsdf, failed = mi.load_dict({"type": "sunbeam", "filename": filename}), False
    for theta in 5, 40, 70:
        wi = (np.array([0.8, 0.6, 1]) * [*[np.sin(np.radians(theta))] * 2, np.cos(np.radians(theta))]).tolist()
        sample, pdf = functions(bsdf, wi)
        test = ChiSquareTest(SphericalDomain(), sample, pdf, sample_dim=3, sample_count=count, res=201, ires=24)
        fits = test.run(significance_level=0.01, test_count=3, quiet=True)
        si = dr.zeros(mi.SurfaceInteraction3f, count)
        si.wi = wi
        (drawn, noise), (plain, more) = furnace(bsdf, si, count)
        error = difference(filename, bsdf, si, 300)
        print("%d degrees: chi-square p %.3f; white furnace %s, by cosine %s; beside read_export.py %.1g"
              % (theta, test.p_value, drawn.round(4), plain.round(4), error))
        failed |= not fits or drawn.max() > 1 or np.any(np.abs(drawn - plain) > 5 * np.hypot(noise, more)) or not error < 1e-3
    return failed


def drawn(filename, shape, lamps, samples=256):
    """Linear Rec. 709 of a sphere, or of a disk, whose tangents are radial, seen obliquely from above."""
    look = mi.ScalarTransform4f().look_at(origin=[0, -8, 5.6], target=[0, 0, 0], up=[0, 0, 1])
    sensor = {"type": "perspective", "fov": 13, "fov_axis": "y", "to_world": look, "sampler": {"type": "independent", "sample_count": samples},
              "film": {"type": "hdrfilm", "width": 320, "height": 320, "rfilter": {"type": "box"}}}
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": 3}, "sensor": sensor,
             "shape": {"type": shape, "bsdf": {"type": "sunbeam", "filename": filename}}}
    return np.array(mi.render(mi.load_dict(scene | lamps)))


def picture(filename, output):
    sun = {"sun": {"type": "directional", "direction": [-0.3, 0.5, -0.8], "irradiance": 1.0}}
    to_world = mi.ScalarTransform4f().look_at(origin=[0.8, 3, 4.5], target=[0, 0, 0], up=[0, 1, 0]).scale(0.3)
    lamp = {"lamp": {"type": "rectangle", "to_world": to_world, "emitter": {"type": "area", "radiance": 1.0}}}
    images = drawn(filename, "disk", lamp), drawn(filename, "sphere", sun)
    both = np.concatenate([1 - np.exp(-image * 3 / np.quantile(image[image > 0], 0.98)) for image in images], 1)
    mi.util.write_bitmap(output, mi.TensorXf(both.astype(np.float32)))


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit("FAILED" if len(sys.argv) == 2 and check(sys.argv[1]) else picture(*sys.argv[1:]) if len(sys.argv) == 3 else 0)
