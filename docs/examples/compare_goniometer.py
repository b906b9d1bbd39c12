"""Compares a goniometer's table with what `sunbeam reflectance` computed for the same rows:

    python3 compare_goniometer.py measured.csv computed.csv [compared.png]

Both have theta_i,phi_i,theta_r,phi_r in degrees, and wavelength,brdf, or X,Y,Z (of rho; with a column gain, X, Y, Z times it).
The measured values may be in any unit: one factor is fitted. Needs numpy, for the plot matplotlib.
"""
import sys
import numpy as np

def read(path):
    table = np.atleast_1d(np.genfromtxt(path, delimiter=",", names=True))
    names = table.dtype.names
    if "brdf" in names:
        return table, table["brdf"][:, None]
    gain = table["gain"] if "gain" in names else 1
    return table, np.stack([table[name] * gain for name in "XYZ"], axis=1)

def fitted_factor(computed, measured):
    """Median of measured / computed, weighted by lightness: cube roots, so that neither a mirror's peak nor noise decides."""
    lit = computed > 0
    ratio, weight = measured[lit] / computed[lit], np.cbrt(computed[lit])
    order = np.argsort(ratio)
    return ratio[order][np.searchsorted(np.cumsum(weight[order]), weight.sum() / 2)]

def lab(xyz):
    t = np.maximum(xyz, 0) / [0.95047, 1, 1.08883]  # D65
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)

def ciede2000(one, other):
    """Of rows of L*, a*, b* (G. Sharma, W. Wu, E. Dalal, 2005)."""
    mean_c = (np.hypot(*one.T[1:]) + np.hypot(*other.T[1:])) / 2
    g = 1 + 0.5 * (1 - np.sqrt(mean_c ** 7 / (mean_c ** 7 + 25.0 ** 7)))
    c1, c2 = np.hypot(g * one[:, 1], one[:, 2]), np.hypot(g * other[:, 1], other[:, 2])
    h1, h2 = (np.degrees(np.arctan2(x[:, 2], g * x[:, 1])) % 360 for x in (one, other))
    turn = np.where(c1 * c2 == 0, 0, (h2 - h1 + 180) % 360 - 180)
    h = np.where(c1 * c2 == 0, h1 + h2, h1 + turn / 2)
    l, c = (one[:, 0] + other[:, 0]) / 2, (c1 + c2) / 2
    cos = lambda degrees: np.cos(np.radians(degrees))
    t = 1 - 0.17 * cos(h - 30) + 0.24 * cos(2 * h) + 0.32 * cos(3 * h + 6) - 0.20 * cos(4 * h - 63)
    dl = (other[:, 0] - one[:, 0]) / (1 + 0.015 * (l - 50) ** 2 / np.sqrt(20 + (l - 50) ** 2))
    dc = (c2 - c1) / (1 + 0.045 * c)
    dh = 2 * np.sqrt(c1 * c2) * np.sin(np.radians(turn / 2)) / (1 + 0.015 * c * t)
    blue = np.exp(-(((h % 360) - 275) / 25) ** 2)
    rotation = -2 * np.sqrt(c ** 7 / (c ** 7 + 25.0 ** 7)) * np.sin(np.radians(60 * blue))
    return np.sqrt(dl ** 2 + dc ** 2 + dh ** 2 + rotation * dc * dh)

if len(sys.argv) < 3:
    sys.exit(__doc__)
(table, measured), (_, computed) = read(sys.argv[1]), read(sys.argv[2])
level = 1 if measured.shape[1] == 3 else 0  # Y, or the BRDF
factor = fitted_factor(computed[:, level], measured[:, level])
computed = factor * computed
size = np.linalg.norm(measured, axis=1)
errors = (np.linalg.norm(computed - measured, axis=1)[size > 0] / size[size > 0])
print(f"factor {factor:.4g}, measured over computed, of {len(measured)} rows")
print(f"relative error: median {np.median(errors):.3g}, 95th percentile {np.quantile(errors, 0.95):.3g}")
if level == 1:
    white = np.quantile(measured[:, 1], 0.95)
    differences = ciede2000(lab(measured / white), lab(computed / white))
    print(f"CIEDE2000: median {np.median(differences):.3g}, 95th percentile {np.quantile(differences, 0.95):.3g}")
if len(sys.argv) > 3:
    import matplotlib.pyplot as plot
    angle = table["theta_r"] * np.where(np.cos(np.radians(table["phi_r"])) < -1e-9, -1, 1)
    for name, values in ("measured", measured), ("computed", computed):
        plot.semilogy(angle, values[:, level], ".", label=name)
    plot.xlabel("angle to the viewer / degrees (negative towards -x)")
    plot.ylabel("Y" if level == 1 else "BRDF")
    plot.legend()
    plot.savefig(sys.argv[3], dpi=150)
