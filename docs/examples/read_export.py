"""Colors from a table of `sunbeam export`, without Sunbeam: needs numpy.

    sunbeam export blaze --format npz --output blaze.npz
    python3 read_export.py blaze.npz THETA_I PHI_I THETA_R PHI_R     (degrees)

prints the channels of diffracted power (with --energy conserve over the divisor) and the gain that makes relative radiance of it. With RESULTS.csv of `sunbeam reflectance
--average ensemble --coherence-length` (the table's) in place of angles, prints median and 95th percentile of relative differences.
"""

import json
import sys

import numpy as np


def direction(theta, phi):
    theta, phi = np.radians(theta), np.radians(phi)
    return np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])


def place(axis, value):
    """Where a value lies among an axis's samples, as an index and a share of the way to the next."""
    at = np.clip((value - axis["first"]) / axis["step"], 0, axis["count"] - 1)
    return (index := int(min(at, axis["count"] - 2))), at - index


def color(table, axes, uvw):
    """All channels: square roots are linear in u and v; their squares cubic through four slices of w."""
    (i, s), (j, t) = place(axes["u"], uvw[0]), place(axes["v"], uvw[1])
    slice_, rest = place(axes["w"], uvw[2])
    first = int(np.clip(slice_ - 1, 0, axes["w"]["count"] - 4))
    corners = table[first : first + 4, j : j + 2, i : i + 2].astype(float)
    roots = np.sign(corners) * np.sqrt(np.abs(corners))
    roots = np.einsum("j,i,njic->nc", [1 - t, t], [1 - s, s], roots)
    at = slice_ + rest - first
    weights = [np.prod([(at - m) / (n - m) for m in range(4) if m != n]) for n in range(4)]
    return weights @ (np.abs(roots) * roots)


def gain(wi, wr):
    """Relative radiance per power: Schlick's reflectance, Kirchhoff's factor, V-cavities."""
    c, cosines = 0.5 * np.linalg.norm(wi + wr), wi[2] + wr[2]
    k = 2 * c * c
    mask = min(1, 2 * cosines * min(wi[2], wr[2]) / k)
    return (1 + 24 * (1 - c) ** 5) * k * k / (cosines**2 * wr[2]) * mask


def divisor(archive, wi):
    """Divisor of each channel by the direction of light, linear between samples; 1 without (--energy scalar)."""
    if "divisor" not in archive:
        return 1.0
    values = archive["divisor"]
    at = (np.array(wi[:2]) + 1) / 2 * (values.shape[1] - 1)
    i, j = np.minimum(at.astype(int), values.shape[1] - 2)
    s, t = at - (i, j)
    return np.einsum("j,i,cji->c", [1 - t, t], [1 - s, s], values[:, j : j + 2, i : i + 2])


if __name__ == "__main__":
    if len(sys.argv) not in (3, 6):
        sys.exit(__doc__)
    with np.load(sys.argv[1]) as archive:
        table, metadata = archive["C"], json.loads(archive["metadata.json"])
        conserved = {name: archive[name] for name in archive.files if name == "divisor"}
    axes = {axis["name"]: axis for axis in metadata["axes"]}
    if len(sys.argv) == 6:
        wi, wr = direction(*map(float, sys.argv[2:4])), direction(*map(float, sys.argv[4:6]))
        print(*color(table, axes, -(wi + wr)) / divisor(conserved, wi), gain(wi, wr))
    else:
        rows = np.genfromtxt(sys.argv[2], delimiter=",", skip_header=1)
        xyz = np.array([color(table, axes, -direction(*row[:2]) - direction(*row[2:4])) for row in rows])
        exact = rows[:, 4:7] * metadata["power_scale"]
        # As the table's own errors: where there is light.
        lit = rows[:, 5] > 1e-9
        errors = np.abs(xyz - exact)[lit].max(1) / exact[lit].max(1)
        print("median %.2g, 95th percentile %.2g" % tuple(np.quantile(errors, [0.5, 0.95])))
