"""How wrong scalar theory is: gratings by rigorous coupled-wave analysis against Sunbeam's model.

    python3 -m venv venv && venv/bin/pip install numpy==2.4.6 matplotlib==3.11.2 pySCATMECH==0.1.10
    venv/bin/python coupled_waves.py compute 1500 gratings.csv    minutes on one core; goes on where it ended
    venv/bin/python coupled_waves.py rule gratings.csv rule.png   fits the rule of docs/theory.md and draws it
    venv/bin/python coupled_waves.py check                        the coupled waves against pySCATMECH and themselves
    venv/bin/python coupled_waves.py sunbeam PROGRAM              the scalar formula against `PROGRAM reflectance`

The coupled waves here: Moharam and Gaylord's layers of Fourier modes, Li's factorization rules for the polarisation across
the grooves (J. Opt. Soc. Am. A 13, 1870, 1996), carried from the substrate upwards as admittances, which nothing in them
lets grow. pySCATMECH, whose recursion loses blazed profiles of many thin layers, checks them on lamellar and sinusoidal ones.
"""

import csv
import math
import os
import subprocess
import sys
import tempfile

import numpy as np

PROFILES = ("blazed", "sinusoidal", "lamellar")
MATERIALS = ("dielectric", "metal")
# Aluminium (A. D. Rakic, Appl. Opt. 34, 4755, 1995), rounded.
ALUMINIUM_NM = (400, 500, 600, 700)
ALUMINIUM = (0.49 + 4.86j, 0.77 + 6.08j, 1.20 + 7.26j, 1.83 + 8.31j)
LAYER_NM = 15.0
COLUMNS = (
    "profile,material,period_um,depth_nm,wavelength_nm,theta_deg,"
    "reflected,misplaced,misplaced_s,misplaced_p,strong_error,energy"
).split(",")


def index(material, wavelength_nm):
    if material == "dielectric":
        return 1.5 + 0j
    return complex(np.interp(wavelength_nm, ALUMINIUM_NM, ALUMINIUM))


def layers(profile, depth_nm):
    """Heights of the layers in nm and the part of the period that each fills, from the top."""
    if profile == "lamellar":
        return [(depth_nm, 0.25, 0.75)]
    count = max(12, math.ceil(depth_nm / LAYER_NM))
    result = []
    for layer in range(count):
        level = 1 - (layer + 0.5) / count
        if profile == "blazed":
            result.append((depth_nm / count, level, 1.0))
        else:
            half = math.acos(2 * level - 1) / (2 * math.pi)
            result.append((depth_nm / count, 0.5 - half, 0.5 + half))
    return result


def heights(profile, depth_nm, samples=4096):
    x = (np.arange(samples) + 0.5) / samples
    if profile == "blazed":
        return depth_nm * x
    if profile == "sinusoidal":
        return depth_nm / 2 * (1 - np.cos(2 * np.pi * x))
    return np.where(abs(x - 0.5) < 0.25, depth_nm, 0.0)


def toeplitz(inside, outside, start, end, orders):
    """Fourier matrix of a function that has one value in a part of the period and another elsewhere."""
    m = np.arange(-2 * orders, 2 * orders + 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        c = (np.exp(-2j * np.pi * m * start) - np.exp(-2j * np.pi * m * end)) / (2j * np.pi * m)
    c[2 * orders] = end - start
    c = (inside - outside) * c
    c[2 * orders] += outside
    i = np.arange(2 * orders + 1)
    return c[2 * orders + i[:, None] - i[None, :]]


def reflected(profile, period_um, depth_nm, wavelength_nm, theta_deg, n, across, orders=None):
    """Efficiencies of the reflected orders -orders..orders; across: electric field across the grooves (p)."""
    if orders is None:
        orders = math.ceil(2.2 * period_um * 1e3 / wavelength_nm) + (14 if across else 10)
    m = np.arange(-orders, orders + 1)
    kx = math.sin(math.radians(theta_deg)) + m * wavelength_nm / (period_um * 1e3)
    gamma_top = decay(kx, 1)
    gamma_below = decay(kx, n * n)
    unit = np.eye(len(m))
    admittance = np.diag(gamma_below / (n * n if across else 1))
    for thickness, start, end in reversed(layers(profile, depth_nm)):
        epsilon = toeplitz(n * n, 1, start, end, orders)
        if across:
            inverse = toeplitz(1 / (n * n), 1, start, end, orders)
            operator = np.linalg.solve(inverse, kx[:, None] * np.linalg.inv(epsilon) * kx[None, :] - unit)
        else:
            inverse = unit
            operator = np.diag(kx * kx) - epsilon
        squares, modes = np.linalg.eig(operator)
        q = np.sqrt(squares.astype(complex))
        q = np.where(q.real < 0, -q, q)
        q = np.where((abs(q.real) < 1e-12 * abs(q)) & (q.imag > 0), -q, q)
        flux = inverse @ (modes * q[None, :])
        through = np.exp(-q * 2 * math.pi * thickness / wavelength_nm)
        g = np.linalg.solve(flux, admittance @ modes)
        back = through[:, None] * np.linalg.solve(unit + g, unit - g) * through[None, :]
        admittance = flux @ (unit - back) @ np.linalg.inv(modes @ (unit + back))
    top = np.diag(gamma_top)
    incident = (m == 0).astype(complex)
    r = np.linalg.solve(top + admittance, (top - admittance) @ incident)
    return m, np.abs(r) ** 2 * np.where(abs(kx) < 1, (1j * gamma_top).real, 0) / math.cos(math.radians(theta_deg))


def decay(kx, epsilon):
    gamma = np.sqrt((kx * kx - epsilon).astype(complex))
    return np.where(abs(gamma.real) < 1e-12 * abs(gamma), -1j * abs(gamma.imag), np.where(gamma.real < 0, -gamma, gamma))


def scalar(profile, period_um, depth_nm, wavelength_nm, theta_deg, n, m):
    """Sunbeam's model: its BRDF integrated over one order, Schlick's reflectance, no mask."""
    sine, cosine_i = math.sin(math.radians(theta_deg)), math.cos(math.radians(theta_deg))
    s = sine + m * wavelength_nm / (period_um * 1e3)
    result = np.zeros(len(m))
    h = heights(profile, depth_nm)
    x = (np.arange(len(h)) + 0.5) / len(h)
    for i in np.flatnonzero(abs(s) < 1):
        cosine_r = math.sqrt(1 - s[i] ** 2)
        w = -(cosine_i + cosine_r)
        amplitude = np.mean(np.exp(1j * 2 * np.pi / wavelength_nm * w * h - 2j * np.pi * m[i] * x))
        dot = -sine * s[i] + cosine_i * cosine_r
        cosine_d = math.sqrt((1 + dot) / 2)
        r0 = abs((n - 1) / (n + 1)) ** 2
        fresnel = r0 + (1 - r0) * (1 - cosine_d) ** 5
        result[i] = fresnel * (1 + dot) ** 2 / (cosine_i * cosine_r * w * w) * abs(amplitude) ** 2
    return result


def case(number):
    """Drawn alike whatever was drawn before."""
    random = np.random.default_rng([12, number])
    return (
        PROFILES[number % 3],
        MATERIALS[number // 3 % 2],
        round(float(np.exp(random.uniform(math.log(0.6), math.log(5)))), 4),
        round(float(np.exp(random.uniform(math.log(50), math.log(1000)))), 2),
        round(float(random.uniform(400, 700)), 2),
        round(float(random.uniform(0, 75)), 2),
    )


def row(number):
    profile, material, period, depth, wavelength, theta = drawn = case(number)
    n = index(material, wavelength)
    m, s = reflected(profile, period, depth, wavelength, theta, n, False)
    wide, p = reflected(profile, period, depth, wavelength, theta, n, True)
    p = p[(len(p) - len(s)) // 2 :][: len(s)]
    model = scalar(profile, period, depth, wavelength, theta, n, m)
    exact = (s + p) / 2
    misplaced = [np.abs(model - truth).sum() / truth.sum() for truth in (exact, s, p)]
    strong = exact > 0.1 * exact.sum()
    error = np.median(np.abs(model - exact)[strong] / exact[strong])
    return drawn + (exact.sum(), *misplaced, error, max(s.sum(), p.sum()))


def compute(count, file):
    done = 0
    if os.path.exists(file):
        with open(file) as stream:
            done = sum(1 for _ in stream) - 1
    with open(file, "a", newline="") as stream:
        writer = csv.writer(stream)
        if done <= 0:
            writer.writerow(COLUMNS)
        for number in range(max(done, 0), count):
            writer.writerow([f"{v:.5g}" if isinstance(v, (float, np.floating)) else v for v in row(number)])
            stream.flush()


def check():
    from pySCATMECH.rcw import RCW_Model

    for profile, model in (("sinusoidal", "Sinusoidal_Relief_Grating"), ("lamellar", "Single_Line_Grating")):
        for material, period, depth, wavelength, theta in (
            ("dielectric", 1.1, 300, 550, 0),
            ("dielectric", 3.0, 800, 450, 40),
            ("metal", 0.7, 150, 600, 20),
            ("metal", 2.0, 400, 500, 60),
        ):
            n = index(material, wavelength)
            grating = {None: model, "period": period, "medium_i": "(1,0)", "medium_t": str((n.real, n.imag))}
            grating["material"] = grating["medium_t"]
            count = len(layers(profile, depth))
            if profile == "sinusoidal":
                grating |= {"amplitude": depth * 1e-3, "nlevels": count, "base": 0, "option": 0}
            else:
                half = period / 2
                grating |= {"space": "(1,0)", "height": depth * 1e-3, "topwidth": half, "bottomwidth": half, "nlevels": 1}
            orders = 30
            other = RCW_Model(
                {None: "RCW_Model", "order": orders, "type": 0, "rotation": 0, "lambda": wavelength * 1e-3, "thetai": theta, "grating": grating}
            )
            worst = 0.0
            for across in (False, True):
                m, r = reflected(profile, period, depth, wavelength, theta, n, across, orders)
                # Orders are counted the other way there.
                for i in np.flatnonzero(abs(m) < 4):
                    jones = other.DiffractionEfficiency(-int(m[i]))
                    theirs = float(jones[0][0]) + (-1 if across else 1) * float(jones[0][1])
                    worst = max(worst, abs(theirs - r[i]) / r.sum())
            print(f"{profile} {material} {period} um, {depth} nm, {wavelength} nm, {theta} deg:"
                  f" {worst:.1e} of the reflected light", file=sys.stderr)
    for drawn in (("blazed", 1.5, 400.0, 550.0, 30.0), ("sinusoidal", 1.0, 800.0, 500.0, 10.0)):
        for material in MATERIALS:
            n = index(material, drawn[3])
            for across in (False, True):
                base = math.ceil(2.2 * drawn[1] * 1e3 / drawn[3]) + (14 if across else 10)
                few = reflected(*drawn, n, across, base)[1]
                many = reflected(*drawn, n, across, base + 12)[1][12:-12]
                print(f"{drawn[0]} {material} {'p' if across else 's'}: more modes change"
                      f" {np.abs(few - many).sum() / many.sum():.1e} of the reflected light", file=sys.stderr)


def sunbeam(program):
    """The exact BRDF of `reference` at the orders' middles, as efficiencies, beside scalar()."""
    import zlib, struct, json

    sigma = 65e-6 / 4
    for profile, period, depth, wavelength, theta in (
        ("blazed", 2.0, 300.0, 550.0, 30.0),
        ("sinusoidal", 1.5, 500.0, 480.0, 60.0),
        ("lamellar", 3.0, 137.5, 650.0, 0.0),
    ):
        samples = 1024
        levels = np.round(heights(profile, depth, samples) / depth * 65535).astype(">u2")
        with tempfile.TemporaryDirectory() as folder:
            rows = b"".join(b"\0" + levels.tobytes() for _ in range(8))
            chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(
                ">I", zlib.crc32(kind + data))
            with open(f"{folder}/g.png", "wb") as png:
                png.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", samples, 8, 16, 0, 0, 0, 0))
                          + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
            with open(f"{folder}/g.json", "w") as descriptor:
                json.dump({"heights": "g.png", "width": f"{period} um", "maxHeight": f"{depth} nm"}, descriptor)
            m = np.arange(-3, 4)
            s = math.sin(math.radians(theta)) + m * wavelength / (period * 1e3)
            seen = abs(s) < 0.999
            with open(f"{folder}/d.csv", "w") as directions:
                directions.write("theta_i,phi_i,theta_r,phi_r,wavelength\n")
                for value in s[seen]:
                    directions.write(f"{theta},180,{math.degrees(math.asin(abs(value)))},{0 if value >= 0 else 180},"
                                     f"{wavelength}\n")
            subprocess.run([program, "reflectance", "--method", "reference", "--patch", f"{folder}/g.json",
                            "--directions", f"{folder}/d.csv", "--output", f"{folder}/o.csv"], check=True)
            with open(f"{folder}/o.csv") as stream:
                brdf = np.array([float(line["brdf"]) for line in csv.DictReader(stream)])
        theirs = brdf * (wavelength * 1e-9) ** 2 / (4 * math.pi * sigma**2)
        ours = scalar(profile, period, depth, wavelength, theta, 1.5 + 0j, m)[seen]
        print(profile, f"largest difference {np.max(abs(theirs - ours)) / ours.sum():.1e} of the reflected light")


if __name__ == "__main__":
    commands = {"compute": lambda count, file: compute(int(count), file), "check": check, "sunbeam": sunbeam}
    if len(sys.argv) < 2 or sys.argv[1] not in commands | {"rule": None}:
        sys.exit(__doc__)
    if sys.argv[1] == "rule":
        from coupled_waves_rule import rule

        commands["rule"] = rule
    commands[sys.argv[1]](*sys.argv[2:])
