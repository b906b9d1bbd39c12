package sunbeam.precompute.plan;

import sunbeam.precompute.resample.InterpolationDesign;

/**
 * What each source of error may take of the one tolerance t that is promised: the relative error of power, and of X, Y, Z, is
 * at most t in the median and 3 t at the 95th percentile, over the directions whose power is at least {@link #DARKEST_POWER}
 * of the mirror's. The shares of one output add up to less than 1, worst case upon worst case.
 *
 * <p>An amplitude a that is wrong by e has a power that is wrong by 2 e / |a|, relative. So an error that does not depend on
 * the direction, of the expansion or of bins that are left out, may be t / 2 times the darkest amplitude, 1.6e-5 t, in all.
 * Interpolation errs by a share of what it interpolates: a skirt of a bright order is a Gaussian, and a design's error is the
 * largest difference relative to the Gaussian <i>there</i>, down to the darkest amplitude, 4.6 deviations from the middle.
 *
 * <p>On a rough patch, whose light goes everywhere, no dark skirt is seen beside it, and a color sums dozens of wavelengths
 * over dozens of orders, whose errors are independent there. What may then be left out is beside the dark directions'
 * amplitude, and interpolation and the trapezoid rule may err several times as much. These factors are measured, not derived:
 * directions on the skirt of one bright order above a rough ground see that order alone, and keep the promise, too.
 *
 * @param tolerance relative error, {@link #FINEST}..{@link #COARSEST}
 * @param roughness of the patch: where light goes everywhere, errors are beside more of it
 */
public record ErrorBudget(double tolerance, Roughness roughness) {
    /** Power, relative to the mirror's, from which on the promise holds. */
    public static final double DARKEST_POWER = 1e-9;

    /** Its amplitude: an error of an amplitude counts twice in the power, relative to this. */
    public static final double DARKEST_AMPLITUDE = Math.sqrt(DARKEST_POWER);

    /** The finest tolerance that can be asked for: what float32 tables and shaders reach; {@code reference} goes further. */
    public static final double FINEST = 1e-5;

    /**
     * Down to here the 95th percentile of the power's error stays below three times the tolerance. Below, the median keeps
     * the tolerance, but float32 leaves up to {@link #FLOAT32_PERCENTILE} (docs/accuracy-and-speed.md).
     */
    static final double FINEST_CERTAIN = 2e-5;

    /** The 95th percentile of the power's relative error that float32 leaves, as measured. */
    public static final double FLOAT32_PERCENTILE = 4.2e-5;

    public static final double COARSEST = 1;
    public static final double STANDARD = 1e-3;

    private static final double EXPANSION_SHARE = 0.4;
    private static final double WINDOW_SHARE = 0.3;
    private static final double WAVELENGTHS_SHARE = 0.2;

    // Deviations of the skirts that are seen: those of the specular spot, or of a grating's orders.
    private static final double ROUGH_SKIRT = 3.5;
    private static final double ROUGH_AVERAGING = 8;
    // One direction in ten is darker than the dark ones, where the promise is three times the tolerance.
    private static final double AT_DARK_DIRECTIONS = 2;

    private static final double PANEL_ERROR = 105 * Math.pow(24, 4) / (9 * Math.pow(40320, 3)) / Math.sqrt(2 * Math.PI);
    private static final double CUT_ERROR = 3.0 / 160 * 3 / Math.sqrt(2 * Math.PI);
    // Beyond, the bound says little.
    private static final double LARGEST_PANEL = 3.5;

    /** For a patch of which nothing is known. */
    public ErrorBudget(double tolerance) {
        this(tolerance, Roughness.NONE);
    }

    /**
     * Error of the expansion, root mean square over the surface. The error of any amplitude is a mean of the expansion's
     * errors with weights of magnitude 1 under the window, so this bounds it wherever the window sees the whole patch.
     */
    public double expansion() {
        // What is left out of a rough patch is spread as its light is, but evenly over bright and dark directions.
        double beside = roughness.isRough() ? AT_DARK_DIRECTIONS * roughness.contrast() : DARKEST_AMPLITUDE;
        return 0.5 * EXPANSION_SHARE * tolerance * beside;
    }

    /** Relative error of the powers of single bins over the phases, where the ensemble's powers have a basis of their own. */
    public double powerBasis() {
        return EXPANSION_SHARE * tolerance;
    }

    /** Amplitude below which what a bin lends to a frequency may be left out: beside the darkest amplitude that counts. */
    public double leftOut() {
        return 0.5 * WINDOW_SHARE * tolerance * DARKEST_AMPLITUDE;
    }

    /** Standard deviations of the window's spectrum beyond which a bin may be left out. */
    public double windowReach() {
        return Math.sqrt(2 * Math.log(1 / leftOut()));
    }

    /** Bins on each side of the nearest that matter: the first that is left out is half a bin farther away. */
    public int neighborhoodRadius(double sigmaBins) {
        return (int) Math.max(0, Math.ceil(sigmaBins * windowReach() - 0.5));
    }

    /** Relative error of an amplitude by interpolation along one axis, anywhere on a skirt; the power has it twice an axis. */
    public double interpolatedAmplitude() {
        return 0.25 * WINDOW_SHARE * tolerance;
    }

    /** Relative error of a power that is interpolated itself, along one axis. */
    public double interpolatedPower() {
        return 0.5 * WINDOW_SHARE * tolerance;
    }

    /** How the grid of an average is interpolated; that of the ensemble serves both. */
    public InterpolationDesign interpolation(Average average) {
        return InterpolationDesign.within(interpolated(average), skirt(average));
    }

    /** The same with a coarser grid, for less memory. */
    public InterpolationDesign compactInterpolation(Average average) {
        return InterpolationDesign.compact(interpolated(average), skirt(average));
    }

    private double interpolated(Average average) {
        if (roughness.isRough()) {
            return ROUGH_AVERAGING * interpolatedAmplitude();
        }
        return average == Average.ENSEMBLE ? interpolatedPower() : interpolatedAmplitude();
    }

    /** Deviations of the Gaussian down to where it counts. */
    private double skirt(Average average) {
        if (roughness.isRough()) {
            return ROUGH_SKIRT;
        }
        // A power's Gaussian is narrower by sqrt(2), and ends where the power is darkest.
        double darkest = average == Average.ENSEMBLE ? DARKEST_POWER : DARKEST_AMPLITUDE;
        return Math.sqrt(-2 * Math.log(darkest));
    }

    /**
     * Panels of Gauss's rule with four nodes, in deviations of an order's power, where the band cuts it. A panel of size H errs
     * by H^9 4!^4 / (9 8!^3) times the eighth derivative (Abramowitz and Stegun 25.4.30), which for exp(-x^2 / 2) is at most
     * 105, beside an integral of sqrt(2 pi).
     */
    public double panelDeviations() {
        return Math.min(LARGEST_PANEL, Math.pow(wavelengths() / PANEL_ERROR, 1.0 / 9));
    }

    /**
     * Equal steps with corrections of four nodes at the ends, in deviations of an order's power, where the band cuts it: the
     * first term that is left out is 3 / 160 h^5 times the fourth derivative (Gregory's rule), at most 3 for exp(-x^2 / 2).
     */
    public double cutSpacing() {
        return Math.min(1, Math.pow(wavelengths() / CUT_ERROR, 0.2));
    }

    /** Relative error of the trapezoid rule over wavelengths for a lone order. */
    public double wavelengths() {
        return WAVELENGTHS_SHARE * tolerance * (roughness.isRough() ? ROUGH_AVERAGING : 1);
    }
}
