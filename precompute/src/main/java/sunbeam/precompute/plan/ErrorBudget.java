package sunbeam.precompute.plan;

import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.spectrum.InterpolationDesign;

/**
 * Shares of the tolerance t for each source of error. The promise holds for powers of {@link #DARKEST_POWER} or more: the relative error of
 * power, and of X, Y, Z, is at most t in the median and 3 t at the 95th percentile. The shares of one output add up to less than 1.
 *
 * <p>An amplitude a with error e has a power with relative error 2 e / |a|. So errors of the expansion or of omitted bins may be t / 2
 * times the darkest amplitude. Interpolation errs relative to what it interpolates: a bright order's skirt is a Gaussian, down to the
 * darkest amplitude, 4.6 deviations from the middle.
 *
 * <p>On a rough patch no skirt stands alone, and a color sums dozens of wavelengths over dozens of orders with independent errors,
 * which count relative to the dark directions' amplitude.
 */
public record ErrorBudget(double tolerance, Roughness roughness) {
    /** Smallest power within the promise, relative to the mirror's. */
    public static final double DARKEST_POWER = 1e-9;

    public static final double DARKEST_AMPLITUDE = Math.sqrt(DARKEST_POWER);
    /** Finest tolerance that float32 tables and shaders can keep; method {@code reference} is more accurate. */
    public static final double FINEST = 1e-5;
    /** Finest tolerance that the 95th percentile keeps, too (docs/accuracy-and-speed.md). */
    static final double FINEST_CERTAIN = 2e-5;
    /** Measured 95th percentile of the power's relative error in float32. */
    public static final double FLOAT32_PERCENTILE = 4.2e-5;

    public static final double COARSEST = 1;
    public static final double STANDARD = 1e-3;
    private static final double EXPANSION_SHARE = 0.4;
    private static final double WINDOW_SHARE = 0.3;
    private static final double WAVELENGTHS_SHARE = 0.2;
    // Skirts (of the specular spot or of orders) that show above a rough patch's light, in standard deviations.
    private static final double ROUGH_SKIRT = 3.5;
    // Errors of interpolation and of the rule over wavelengths average out on rough patches; measured.
    private static final double ROUGH_AVERAGING = 8;
    // One direction in ten is darker than Roughness.dark, where three tolerances are allowed.
    private static final double AT_DARK_DIRECTIONS = 2;
    private static final double PANEL_ERROR = 105 * Math.pow(24, 4) / (9 * Math.pow(40320, 3)) / Math.sqrt(2 * Math.PI);
    private static final double CUT_ERROR = 3.0 / 160 * 3 / Math.sqrt(2 * Math.PI);
    private static final double LARGEST_PANEL = 3.5;

    public ErrorBudget(double tolerance) {
        this(tolerance, Roughness.NONE);
    }

    /** Returns the allowed rms error of the expansion over the surface, which bounds any amplitude under a window as wide as the patch. */
    public double expansion() {
        double reference = roughness.isRough() ? AT_DARK_DIRECTIONS * roughness.contrast() : DARKEST_AMPLITUDE;
        return 0.5 * EXPANSION_SHARE * tolerance * reference;
    }

    /** Returns the allowed relative error of a bin's power over the phases, for the basis of the ensemble average. */
    public double powerBasis() {
        return EXPANSION_SHARE * tolerance;
    }

    /** Returns the radius of the bins to sum; omitted ones, at least half a bin farther, contribute less than may be left out. */
    public int neighborhoodRadius(double sigmaBins) {
        double leftOut = 0.5 * WINDOW_SHARE * tolerance * DARKEST_AMPLITUDE;
        double reach = CoherenceWindow.reach(leftOut);
        return (int) Math.max(0, Math.ceil(sigmaBins * reach - 0.5));
    }

    /** Returns the design for one average; the ensemble average's serves the coherent one too. */
    public InterpolationDesign interpolation(Average average) {
        return InterpolationDesign.within(interpolated(average), skirt(average));
    }

    public InterpolationDesign compactInterpolation(Average average) {
        return InterpolationDesign.compact(interpolated(average), skirt(average));
    }

    private double interpolated(Average average) {
        double amplitude = 0.25 * WINDOW_SHARE * tolerance;
        if (roughness.isRough()) {
            return ROUGH_AVERAGING * amplitude;
        }
        return average == Average.ENSEMBLE ? 2 * amplitude : amplitude;
    }

    /** Returns standard deviations of the Gaussian. */
    private double skirt(Average average) {
        if (roughness.isRough()) {
            return ROUGH_SKIRT;
        }
        // A power's Gaussian is narrower by sqrt(2) and ends where the power is darkest.
        return CoherenceWindow.reach(average == Average.ENSEMBLE ? DARKEST_POWER : DARKEST_AMPLITUDE);
    }

    /**
     * Returns the panel of Gauss's rule with four nodes, in deviations of an order's power, where the band cuts the order. A panel of size
     * H errs by H^9 4!^4 / (9 8!^3) times the eighth derivative (Abramowitz and Stegun 25.4.30), at most 105 for exp(-x^2 / 2), whose
     * integral is sqrt(2 pi).
     */
    public double panelDeviations() {
        return Math.min(LARGEST_PANEL, Math.pow(wavelengths() / PANEL_ERROR, 1.0 / 9));
    }

    /**
     * Returns the equal step with Gregory's corrections of four nodes, in deviations of an order's power, where the band cuts the order:
     * the first omitted term is 3 / 160 h^5 times the fourth derivative, at most 3 for exp(-x^2 / 2).
     */
    public double cutSpacing() {
        return Math.min(1, Math.pow(wavelengths() / CUT_ERROR, 0.2));
    }

    public double wavelengths() {
        return WAVELENGTHS_SHARE * tolerance * (roughness.isRough() ? ROUGH_AVERAGING : 1);
    }
}
