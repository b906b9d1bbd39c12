package sunbeam.precompute.patch.builtin;

import sunbeam.precompute.optics.HeightMap;

/**
 * A sawtooth that rises towards +x. Lit from the normal it sends light towards -x: order m has the power
 * sinc^2(k w H / (2 pi) - m), w = -2 near the normal.
 *
 * @param grid period and samples
 * @param depth height H of the step in metres; samples lie mid-interval, so the relief is depth (1 - 1 / columns)
 */
public record BlazedGrating(GratingGrid grid, double depth) {
    public BlazedGrating {
        Parameters.requirePositive("depth", depth);
    }

    /** The thesis's grating: 2.5 um period, 250 nm. */
    static BlazedGrating standard() {
        return new BlazedGrating(GratingGrid.ofPeriod(2.5e-6), 250e-9);
    }

    /** One period. */
    public HeightMap generate() {
        return grid.sample(place -> depth * place);
    }
}
