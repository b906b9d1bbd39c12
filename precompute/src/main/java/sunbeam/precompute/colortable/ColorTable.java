package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Color table with mip levels, each averaged over wider footprints in (u, v) than the one before. The ensemble average under a Gaussian
 * window is a sum of Gaussians in frequency; its mean over a Gaussian footprint is a sum of wider ones, those of a shorter window. So a
 * coarse level is evaluated at its own few texels under a shorter window, not averaged from a fine level (docs/color-tables.md). Level 0 is
 * for points, as in maps and lists.
 *
 * <p>Gaussians of one width in frequency have in (u, v) a width proportional to the wavelength; {@link #sigma()} is that at
 * {@link #MIDDLE_WAVELENGTH}.
 *
 * <p>If the surface has relief finer than a pixel (Toksvig 2005; Olano and Baker 2010), all levels are also averages over its slopes: a
 * slope shifts (u, v) by slope times w, at all wavelengths alike. The finest level is then as coarse as this blur.
 *
 * @param area window and average at a point, without a footprint
 * @param levels levels, finest first; without slopes the finest has the window of {@code area}, and with linear filters it comes twice:
 *     first for points with a cubic filter
 * @param tolerance promised relative error of X, Y, Z
 * @param slopeDeviation standard deviation of the relief's slopes along either axis; 0 for none
 */
public record ColorTable(
        GaussianArea area, List<Level> levels, NumberFormat numbers, double tolerance, double slopeDeviation) {
    /** Wavelength of the eye's greatest sensitivity, meters. */
    public static final double MIDDLE_WAVELENGTH = 550e-9;

    private static final double RATIO = Math.sqrt(2);
    // Standard deviation in (u, v): in a wider level a fifth of the hemisphere would have one color.
    private static final double WIDEST_SIGMA = 0.06;
    // Smallest |w| at which the finest level of a table with slopes is not too wide.
    private static final double SHALLOWEST = 0.5;
    // Standard deviation: tan 1 degree. Power spectra of smaller slopes take more than 1 GB.
    private static final double LEAST_SLOPES = 0.01745;
    /** Largest |w|: light and view along the normal. */
    public static final double DEEPEST = 2;
    // Least tolerance of linear filters for footprints; they err by a tenth on flanks of isolated orders.
    private static final double LINES_TOLERANCE = 5e-3;
    // Texel step of linear filters, relative to that of cubic ones: the largest before errors of means grow.
    private static final double LINES_STEP = 1.5;
    // The same for coarse levels of a standard deviation from WIDE_SIGMA on, in (u, v): wide lights are seen on flanks
    // of orders, where errors grow with the square of the step.
    private static final double WIDE_LINES_STEP = 1.05;
    private static final double WIDE_SIGMA = 0.025;
    // Factor of the step if orders are isolated, since splines ring in the dark between them: at tolerance 1e-2 the
    // 95th percentile of the errors of patch blaze is 2 % with it, 4 % without.
    private static final double ISOLATED_STEP = 0.85;
    // Factor of the number of slices from LINES_TOLERANCE on: at a |w| where an order has no power, the remaining power
    // is smaller than the error of interpolation between slices.
    private static final double SLICE_FACTOR = 1.5;
    // For 16-bit floats, which round a color's square root by at most 2^-11, so the color by 1e-3.
    private static final double HALF_TOLERANCE = 1e-3;

    /**
     * Mip level of a table. Its power is scaled, since averaging makes a Gaussian of height 1 lower as it makes it wider; faint tails of
     * orders go down to a millionth of a neighboring order's power.
     */
    public record Level(
            GaussianArea area,
            double scale,
            TableDesign design,
            Interpolation interpolation,
            boolean includeFaintTails) {}

    /** True if a table can average over slopes of this standard deviation; smaller ones, 0 included, widen footprints instead. */
    public static boolean averages(double slopeDeviation) {
        return slopeDeviation >= LEAST_SLOPES;
    }

    /**
     * Returns a table that keeps a tolerance. A coherent average, which is no sum of Gaussians, has one level and no slopes.
     *
     * @param relief effective relief in meters, see {@link TableDesign#depth}
     * @param ordersIsolated whether orders stand alone in the dark, as a grating's do; false with slopes
     */
    public static ColorTable within(
            double tolerance, GaussianArea area, double relief, boolean ordersIsolated, double slopeDeviation) {
        boolean coherent = area.average() == Average.COHERENT;
        double widestSigma = coherent ? 0 : WIDEST_SIGMA;
        boolean coarse = tolerance >= LINES_TOLERANCE && !coherent;
        boolean lines = coarse && !ordersIsolated;
        List<Level> levels = new ArrayList<>();
        double pointSigma = area.window().sigmaOfOrder(MIDDLE_WAVELENGTH);
        boolean hasSlopes = slopeDeviation > 0;
        double finest = Math.max(pointSigma, SHALLOWEST * slopeDeviation) / pointSigma;
        for (double widening = finest; widening == finest || pointSigma * widening <= widestSigma; widening *= RATIO) {
            GaussianArea wider = area.with(new CoherenceWindow(area.window().sigmaMeters() / widening));
            TableDesign design = TableDesign.within(tolerance, wider, relief);
            if (coarse) {
                design = new TableDesign(
                        (ordersIsolated ? ISOLATED_STEP : 1) * design.step(),
                        1 + (int) Math.ceil(SLICE_FACTOR * (design.slices() - 1)));
            }
            double scale = hasSlopes ? 1 : 1 / (widening * widening);
            boolean isFinest = !hasSlopes && widening == finest;
            if (!lines || isFinest) {
                levels.add(new Level(wider, scale, design, Interpolation.CUBIC, isFinest || ordersIsolated));
            }
            if (lines) {
                boolean isWide = widening > finest && pointSigma * widening >= WIDE_SIGMA;
                double factor = isWide ? WIDE_LINES_STEP : LINES_STEP;
                TableDesign linear = new TableDesign(factor * design.step(), design.slices());
                levels.add(new Level(wider, scale, linear, Interpolation.SHIFTED_LINES, isFinest));
            }
        }
        NumberFormat numbers = tolerance < HALF_TOLERANCE ? NumberFormat.FLOAT : NumberFormat.HALF;
        return new ColorTable(area, levels, numbers, tolerance, slopeDeviation);
    }

    /** Returns the standard deviation in (u, v) of a sharp order at a point, at {@link #MIDDLE_WAVELENGTH}. */
    public double sigma() {
        return area.window().sigmaOfOrder(MIDDLE_WAVELENGTH);
    }

    /** Returns {@link #sigma()} of the finest level for footprints; the variance doubles from level to level. */
    public double finestSigma() {
        return levels.get(pointLevelCount()).area().window().sigmaOfOrder(MIDDLE_WAVELENGTH);
    }

    /** Returns the variance in (u, v) that slopes and a level's average add to a sharp order in {@link #area()}, at |w| of 0..2. */
    public double slopeVariance(int level, double depth) {
        double finest = Math.pow(finestSigma(), 2);
        double relief = Math.pow(slopeDeviation * depth, 2);
        return Math.max(relief, finest - Math.pow(sigma(), 2)) + (Math.pow(2, level) - 1) * finest;
    }

    public GaussianArea widest() {
        int coarsest = levels.size() - 1;
        return slopeDeviation == 0
                ? levels.get(coarsest).area()
                : area.with(widened(slopeVariance(coarsest, DEEPEST), MIDDLE_WAVELENGTH));
    }

    /** Returns the window whose orders, at a wavelength in meters, have this much more variance in (u, v) than those of {@link #area()}. */
    public CoherenceWindow widened(double variance, double wavelength) {
        double frequency = area.window().sigmaFrequency();
        // Power is the square of an amplitude.
        double wider = Math.sqrt(frequency * frequency + 2 * variance / (wavelength * wavelength));
        return new CoherenceWindow(area.window().sigmaMeters() * frequency / wider);
    }

    /** Returns 1 if the first level is for points only, else 0. */
    public int pointLevelCount() {
        return levels.size() > 1 && levels.get(1).area().equals(area) ? 1 : 0;
    }

    public int slices() {
        return levels.get(0).design().slices();
    }
}
