package sunbeam.precompute.patch.builtin;

import sunbeam.precompute.optics.HeightMap;

/**
 * Heights amplitude * sin(2 pi x / period). Order m has the power J_m(k w amplitude)^2.
 *
 * @param grid period and samples
 * @param amplitude half of the relief in metres
 */
public record SinusoidalGrating(GratingGrid grid, double amplitude) {
    public SinusoidalGrating {
        Parameters.requirePositive("amplitude", amplitude);
    }

    /** 2.5 um period as the blazed grating's, 100 nm amplitude. */
    static SinusoidalGrating standard() {
        return new SinusoidalGrating(GratingGrid.ofPeriod(2.5e-6), 100e-9);
    }

    /** One period. */
    public HeightMap generate() {
        return grid.sample(place -> amplitude * StrictMath.sin(2 * StrictMath.PI * place));
    }
}
