"""Diffracted power from a table of `sunbeam precompute`, without Sunbeam: needs h5py and numpy.

    sunbeam precompute --patch elaphe-like --output table.h5
    python3 read_table.py table.h5 THETA_I PHI_I THETA_R PHI_R WAVELENGTH_NM    (degrees)

prints the power of one coherence area of 65 um, its window centered on the patch, as `sunbeam reflectance` does.
"""

import math
import sys

try:
    import h5py
    import numpy as np
except ImportError as missing:
    sys.exit(f"{missing}: this script needs h5py and numpy")

SIGMA = 65e-6 / 4  # standard deviation of the coherence window, metres


def direction(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return np.array([math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)])


def coefficients(table, zeta, count):
    """c_n(zeta); taylor has none in the file."""
    if "coefficients" not in table:
        return np.array([zeta**n / math.factorial(n) for n in range(count)])
    samples = table["coefficients"][:].astype(float)
    first = table.attrs["coefficients_first_phase_radians"]
    last = table.attrs["coefficients_last_phase_radians"]
    return np.array([np.interp(zeta, np.linspace(first, last, samples.shape[1]), row) for row in samples])


def power(table, u, v, w, wavelength):
    attributes = table.attrs
    terms = table["terms"]
    columns, rows = int(attributes["patch_columns"]), int(attributes["patch_rows"])
    width, height = columns * attributes["pitch_x_metres"], rows * attributes["pitch_y_metres"]
    bins_x = int(attributes["first_bin_x"]) + np.arange(terms.shape[3])
    bins_y = int(attributes["first_bin_y"]) + np.arange(terms.shape[2])

    # F_j = sum over n of (-i)^turns c_n terms_n
    zeta = 2 * math.pi * abs(w) * attributes["height_half_range_metres"] / wavelength
    turn = 1 if attributes["expansion"].decode() == "lowrank" else -1j
    field = np.zeros(terms.shape[2:], complex)
    for n, c in enumerate(coefficients(table, zeta, terms.shape[0])):
        field += turn**n * c * (terms[n, 0].astype(float) + 1j * terms[n, 1])

    # The window's maximum stands on the sample (columns // 2, rows // 2); rows run downwards, y upwards.
    phase_x = np.exp(-2j * math.pi * bins_x * (columns // 2) / columns)
    phase_y = np.exp(2j * math.pi * bins_y * (rows // 2) / rows)
    sigma_frequency = 1 / (2 * math.pi * SIGMA)
    weight_x = np.exp(-((u / wavelength - bins_x / width) ** 2) / (2 * sigma_frequency**2))
    weight_y = np.exp(-((v / wavelength - bins_y / height) ** 2) / (2 * sigma_frequency**2))
    return abs((phase_y * weight_y) @ field @ (phase_x * weight_x)) ** 2


if __name__ == "__main__":
    if len(sys.argv) != 7:
        sys.exit(__doc__)
    name, theta_i, phi_i, theta_r, phi_r, nanometres = sys.argv[1], *map(float, sys.argv[2:7])
    uvw = -direction(theta_i, phi_i) - direction(theta_r, phi_r)
    with h5py.File(name) as file:
        print(power(file, *uvw, nanometres * 1e-9))
