package sunbeam.precompute.plan;

import sunbeam.precompute.resample.InterpolationDesign;

/**
 * Shares of the tolerance t for each source of error. The promise: the relative error of power, and of X, Y, Z, is at most t in the median
 * and 3 t at the 95th percentile. Directions with a power below {@link #DARKEST_POWER} of the mirror's do not count. The shares of one
 * output add up to less than 1, in the worst case.
 *
 * <p>An amplitude a with error e has a power with relative error 2 e / |a|. So errors that do not depend on the direction, of the expansion
 * or of omitted bins, may be t / 2 times the darkest amplitude, 1.6e-5 t in all. Interpolation errs relative to what it interpolates: a
 * bright order's skirt is a Gaussian, and a design's error is the largest difference relative to the Gaussian <i>there</i>, down to the
 * darkest amplitude, 4.6 deviations from the middle.
 *
 * <p>On a rough patch, which scatters light everywhere, no skirt stands alone, and a color sums dozens of wavelengths over dozens of orders
 * with independent errors. Then errors count relative to the dark directions' amplitude, and interpolation and the trapezoid rule may err
 * several times as much. These factors are measured, not derived; directions on the skirt of one bright order above a rough ground keep the
 * promise, too.
 *
 * @param tolerance relative error, {@link #FINEST}..{@link #COARSEST}
 * @param roughness roughness of the patch
 */
public record ErrorBudget(double tolerance, Roughness roughness) {
    /** Smallest power within the promise, relative to the mirror's. */
    public static final double DARKEST_POWER = 1e-9;

    /** Smallest amplitude within the promise, relative to the mirror's. */
    public static final double DARKEST_AMPLITUDE = Math.sqrt(DARKEST_POWER);

    /** Finest tolerance that float32 tables and shaders can keep; method {@code reference} is more accurate. */
    public static final double FINEST = 1e-5;

    /**
     * Finest tolerance whose 95th percentile is certain. Below it the median keeps the tolerance, but float32 leaves errors of up to {@link
     * #FLOAT32_PERCENTILE} at the 95th percentile (docs/accuracy-and-speed.md).
     */
    static final double FINEST_CERTAIN = 2e-5;

    /** Measured 95th percentile of the power's relative error in float32. */
    public static final double FLOAT32_PERCENTILE = 4.2e-5;

    public static final double COARSEST = 1;
    public static final double STANDARD = 1e-3;

    // Shares of the tolerance for the expansion, for omitted bins and interpolation, and for the rule over wavelengths.
    private static final double EXPANSION_SHARE = 0.4;
    private static final double WINDOW_SHARE = 0.3;
    private static final double WAVELENGTHS_SHARE = 0.2;

    // Length of skirts (of the specular spot or of a grating's orders) that show above a rough patch's light, in
    // standard deviations.
    private static final double ROUGH_SKIRT = 3.5;
    // Factor of the errors of interpolation and of the rule over wavelengths on rough patches, where they average out;
    // measured.
    private static final double ROUGH_AVERAGING = 8;
    // Factor of the expansion's error on rough patches: one direction in ten is darker than Roughness.dark, and there 3
    // t is promised.
    private static final double AT_DARK_DIRECTIONS = 2;

    // Relative errors of a panel of size 1 deviation, and of a step of 1 deviation: see panelDeviations and cutSpacing.
    private static final double PANEL_ERROR = 105 * Math.pow(24, 4) / (9 * Math.pow(40320, 3)) / Math.sqrt(2 * Math.PI);
    private static final double CUT_ERROR = 3.0 / 160 * 3 / Math.sqrt(2 * Math.PI);
    // Largest panel in deviations; for larger ones the bound in panelDeviations is far from the error.
    private static final double LARGEST_PANEL = 3.5;

    public ErrorBudget(double tolerance) {
        this(tolerance, Roughness.NONE);
    }

    /**
     * Returns the allowed root-mean-square error of the expansion over the surface. If the window covers the whole patch, it limits the
     * error of any amplitude, which is a mean of the expansion's errors with factors of magnitude 1.
     */
    public double expansion() {
        // The error spreads like a rough patch's light, but evenly over bright and dark directions.
        double reference = roughness.isRough() ? AT_DARK_DIRECTIONS * roughness.contrast() : DARKEST_AMPLITUDE;
        return 0.5 * EXPANSION_SHARE * tolerance * reference;
    }

    /** Returns the allowed relative error of a bin's power over the phases, for the basis of the ensemble average. */
    public double powerBasis() {
        return EXPANSION_SHARE * tolerance;
    }

    /** Returns the amplitude below which a bin's contribution to a frequency may be omitted. */
    public double leftOut() {
        return 0.5 * WINDOW_SHARE * tolerance * DARKEST_AMPLITUDE;
    }

    /** Returns the radius of the neighborhood that counts, in bins; omitted bins are at least half a bin farther from the frequency. */
    public int neighborhoodRadius(double sigmaBins) {
        double reach = Math.sqrt(2 * Math.log(1 / leftOut()));
        return (int) Math.max(0, Math.ceil(sigmaBins * reach - 0.5));
    }

    /** Returns the interpolation of an average's grid; the ensemble's serves both averages. */
    public InterpolationDesign interpolation(Average average) {
        return InterpolationDesign.within(interpolated(average), skirt(average));
    }

    /** Returns the interpolation on a coarser grid, for less memory. */
    public InterpolationDesign compactInterpolation(Average average) {
        return InterpolationDesign.compact(interpolated(average), skirt(average));
    }

    /** Returns the allowed relative error of interpolation along one axis; a power has twice the relative error of its amplitude. */
    private double interpolated(Average average) {
        double amplitude = 0.25 * WINDOW_SHARE * tolerance;
        if (roughness.isRough()) {
            return ROUGH_AVERAGING * amplitude;
        }
        return average == Average.ENSEMBLE ? 2 * amplitude : amplitude;
    }

    /** Returns the skirt to design for, in standard deviations of the Gaussian. */
    private double skirt(Average average) {
        if (roughness.isRough()) {
            return ROUGH_SKIRT;
        }
        // A power's Gaussian is narrower by sqrt(2) and ends where the power is darkest.
        double darkest = average == Average.ENSEMBLE ? DARKEST_POWER : DARKEST_AMPLITUDE;
        return Math.sqrt(-2 * Math.log(darkest));
    }

    /**
     * Returns the panel of Gauss's rule with four nodes, in deviations of an order's power, where the band cuts the order. A panel of size
     * H errs by H^9 4!^4 / (9 8!^3) times the eighth derivative (Abramowitz and Stegun 25.4.30), which for exp(-x^2 / 2) is at most 105;
     * the integral is sqrt(2 pi).
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

    /** Returns the allowed relative error of the trapezoid rule over wavelengths, for a single order. */
    public double wavelengths() {
        return WAVELENGTHS_SHARE * tolerance * (roughness.isRough() ? ROUGH_AVERAGING : 1);
    }
}
