"""Fits the rule of docs/theory.md to the table of coupled_waves.py and draws it."""

import csv

import numpy as np

RANGES = ((0, 30), (30, 60), (60, 75))
# Steeper ones have no rule: nearly all light goes elsewhere.
STEEPEST = 1.2


def rule(table, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    with open(table) as stream:
        rows = list(csv.DictReader(stream))
    column = lambda name: np.array([float(row[name]) for row in rows])
    slope = 2 * column("depth_nm") * 1e-3 / column("period_um")
    ratio = column("period_um") * 1e3 / column("wavelength_nm")
    theta = column("theta_deg")
    error = column("misplaced")
    strong = column("strong_error")
    print(f"{len(rows)} gratings; most energy in one polarisation {column('energy').max():.3f} (1 for a mirror)")
    figure, axes = plt.subplots(1, 4, figsize=(18, 5), sharey=False)
    colors = {"blazed": "#0072B2", "sinusoidal": "#D55E00", "lamellar": "#009E73"}
    markers = {"dielectric": "o", "metal": "^"}
    everything = np.full(len(rows), np.nan)
    for axis, (low, high) in zip(axes, RANGES):
        chosen = (theta >= low) & (theta < high)
        fitted = chosen & (slope < STEEPEST)
        matrix = np.column_stack([np.ones(fitted.sum()), np.log(slope[fitted])])
        (a, b), *_ = np.linalg.lstsq(matrix, np.log(error[fitted]), rcond=None)
        rest = np.log(error[fitted]) - matrix @ (a, b)
        q = np.exp(np.quantile(rest, [0.1, 0.9]))
        everything[fitted] = np.exp(rest)
        both = [np.median(column(f"misplaced_{p}")[fitted]) for p in "sp"]
        print(f"{low} to {high} degrees, {fitted.sum()} gratings: {np.exp(a):.3f} slope^{b:.3f},"
              f" 80 % within {q[0]:.2f} to {q[1]:.2f} of it; brightness of strong orders"
              f" {np.median(strong[fitted] / error[fitted]):.2f} of it; medians: unpolarised {np.median(error[fitted]):.3f},"
              f" s {both[0]:.3f}, p {both[1]:.3f}")
        for profile, color in colors.items():
            for material, marker in markers.items():
                these = chosen & np.array([r["profile"] == profile and r["material"] == material for r in rows])
                axis.loglog(slope[these], error[these], marker, color=color, ms=3.5, alpha=0.7, mew=0,
                            label=f"{profile}, {material}")
        line = np.array([0.02, STEEPEST])
        axis.loglog(line, np.exp(a) * line**b, "k-", lw=2)
        for factor in q:
            axis.loglog(line, factor * np.exp(a) * line**b, "k--", lw=1)
        axis.set(title=f"light {low} to {high}° from the normal", xlabel="mean slope", ylim=(3e-3, 5), xlim=(0.02, 4))
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("light drawn elsewhere / light reflected")
    axes[0].legend(fontsize=7)
    known = np.isfinite(everything)
    axes[3].loglog(ratio[known], everything[known], "o", color="#555555", ms=3, alpha=0.5, mew=0)
    edges = np.geomspace(0.8, 13, 7)
    for low, high in zip(edges, edges[1:]):
        inside = known & (ratio >= low) & (ratio < high)
        print(f"period / wavelength {low:.2f} to {high:.2f}: error / rule {np.median(everything[inside]):.2f} (median of"
              f" {inside.sum()})")
        axes[3].loglog([low, high], 2 * [np.median(everything[inside])], "k-", lw=2)
    axes[3].set(title="what the rule leaves", xlabel="period / wavelength", ylabel="error / rule")
    axes[3].grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture, dpi=80)
