package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * Levels of a table of colors, each averaged over a wider footprint in (u, v). The ensemble average under a Gaussian window is a sum of
 * Gaussians in frequency; its mean with Gaussian weights is the same sum with wider ones, which a shorter window gives. So a coarse level
 * is evaluated at its few texels and never averaged from a fine one (docs/color-tables.md). Level 0 is for points, as in maps and lists.
 *
 * <p>A shorter window's Gaussians are wider by a fixed width in frequency, so in (u, v) by a width proportional to the wavelength: {@link
 * #sigma()} refers to {@link #MIDDLE_WAVELENGTH}.
 *
 * <p>With relief finer than a pixel (Toksvig 2005; Olano and Baker 2010) all levels are also averages over its slopes: a slope shifts (u,
 * v) by slope times w, at all wavelengths alike. Such a table starts as coarse as that blur, and scenes of such a surface need no finer
 * one.
 *
 * @param area the window seen at a point, and its average
 * @param levels finest first, that of the area itself; if the others use linear filters, an additional one for points comes before it
 * @param numbers format of the coefficients
 * @param tolerance promised relative error of X, Y, Z
 * @param slopeDeviation standard deviation of the relief's slopes along either axis; 0 for none
 */
public record ColorTable(
        GaussianArea area, List<Level> levels, NumberFormat numbers, double tolerance, double slopeDeviation) {
    /** Wavelength of the eye's greatest sensitivity, meters. */
    public static final double MIDDLE_WAVELENGTH = 550e-9;

    // Ratio of the Gaussians' widths from level to level.
    private static final double RATIO = Math.sqrt(2);
    // Widest level, in (u, v): beyond, a fifth of the hemisphere would have one color.
    private static final double WIDEST = 0.06;

    // Smallest |w| at which a table of relief is exact; closer to grazing light and view it is too wide.
    private static final double SHALLOWEST = 0.5;

    /** The largest |w|. */
    public static final double DEEPEST = 2;

    // Smallest tolerance for linear filters in wider footprints, unless orders are isolated: on their flanks these err
    // by a tenth.
    private static final double LINES_TOLERANCE = 5e-3;

    // Texel step of linear filters, in steps of cubic ones: just before errors of means grow (docs/color-tables.md).
    private static final double LINES_STEP = 1.5;

    // Factor of the step if orders are isolated, where splines ring in the dark: the 95th percentile of blaze at 1e-2
    // is 2 %, else 4 %.
    private static final double LONE_STEP = 0.85;

    // Factor of the slices at such tolerances: where an order vanishes, the rest is small beside the error of slices.
    // Cheap with few texels.
    private static final double MORE_SLICES = 1.5;

    // Limit for 16-bit floats: a color errs by twice as much as its root, at most 1e-3, and less for a sum of
    // coefficients.
    private static final double HALF_TOLERANCE = 1e-3;

    /**
     * One level.
     *
     * @param scale factor of its power: the mean of a Gaussian of height 1 is lower the wider it is
     * @param design step and slices
     * @param interpolation filter between texels
     * @param includeFaintTails whether light at a millionth of a neighboring order counts
     */
    public record Level(
            GaussianArea area,
            double scale,
            TableDesign design,
            Interpolation interpolation,
            boolean includeFaintTails) {}

    public ColorTable {
        levels = List.copyOf(levels);
    }

    /**
     * True if relief blurs more than the coarsest level of a table without it, which footprints see less of. So no table of relief is finer
     * than a quarter of that level, and its powers need a few hundred MB at most.
     *
     * @param slopeDeviation of its slopes
     */
    public static boolean isBlurredByRelief(double slopeDeviation) {
        return DEEPEST * slopeDeviation > WIDEST;
    }

    public static ColorTable within(double tolerance, GaussianArea area, double relief, boolean ordersIsolated) {
        return within(tolerance, area, relief, ordersIsolated, 0);
    }

    /**
     * Returns a table that keeps a tolerance.
     *
     * @param area seen at a point; one level for a coherent average, which is no sum of Gaussians
     * @param relief see {@link TableDesign#depth}, meters
     * @param ordersIsolated whether orders stand alone in the dark, as a grating's do; false with slopes
     * @param slopeDeviation of relief finer than a pixel, for an ensemble average; 0 for none
     */
    public static ColorTable within(
            double tolerance, GaussianArea area, double relief, boolean ordersIsolated, double slopeDeviation) {
        boolean coherent = area.average() == Average.COHERENT;
        boolean coarse = tolerance >= LINES_TOLERANCE && !coherent;
        boolean lines = coarse && !ordersIsolated;
        List<Level> levels = new ArrayList<>();
        double ofPoints = sigma(area.window());
        boolean sloping = slopeDeviation > 0;
        double finest = Math.max(ofPoints, SHALLOWEST * slopeDeviation) / ofPoints;
        for (double widening = finest; widening == finest || ofPoints * widening <= WIDEST; widening *= RATIO) {
            GaussianArea wider = area.with(new CoherenceWindow(area.window().sigmaMetres() / widening));
            TableDesign bright = TableDesign.within(tolerance, wider, relief);
            TableDesign design = coarse ? withMoreSlices(bright) : bright;
            if (coarse && ordersIsolated) {
                design = new TableDesign(LONE_STEP * design.step(), design.slices());
            }
            double scale = sloping ? 1 : 1 / (widening * widening);
            boolean ofFinest = !sloping && widening == finest;
            if (!lines || ofFinest) {
                levels.add(new Level(wider, scale, design, Interpolation.CUBIC, ofFinest || ordersIsolated));
            }
            if (lines) {
                TableDesign wide = new TableDesign(LINES_STEP * design.step(), design.slices());
                levels.add(new Level(wider, scale, wide, Interpolation.SHIFTED_LINES, ofFinest));
            }
            if (coherent) {
                break;
            }
        }
        NumberFormat numbers = tolerance < HALF_TOLERANCE ? NumberFormat.FLOAT : NumberFormat.HALF;
        return new ColorTable(area, levels, numbers, tolerance, slopeDeviation);
    }

    private static TableDesign withMoreSlices(TableDesign design) {
        return new TableDesign(design.step(), 1 + (int) Math.ceil(MORE_SLICES * (design.slices() - 1)));
    }

    /** Returns the standard deviation in (u, v) of a sharp order in the finest level. */
    public double sigma() {
        return sigma(area.window());
    }

    /** Returns the same of the first level for pixels, where relief adds least; the variance doubles from level to level. */
    public double finestSigma() {
        return sigma(levels.get(pointLevelCount()).area().window());
    }

    /**
     * Returns the variance in (u, v) that slopes and a level's average add to a sharp order in {@link #area()}, at all wavelengths.
     *
     * @param depth |w|
     */
    public double slopeVariance(int level, double depth) {
        double finest = Math.pow(finestSigma(), 2);
        double relief = Math.pow(slopeDeviation * depth, 2);
        return Math.max(relief, finest - Math.pow(sigma(), 2)) + (Math.pow(2, level) - 1) * finest;
    }

    /** Returns the area under the shortest window of any level. */
    public GaussianArea widest() {
        int coarsest = levels.size() - 1;
        return slopeDeviation == 0
                ? levels.get(coarsest).area()
                : area.with(widened(slopeVariance(coarsest, DEEPEST), MIDDLE_WAVELENGTH));
    }

    /** Returns the window whose orders at a wavelength are wider than those of {@link #area()} by a variance in (u, v). */
    public CoherenceWindow widened(double variance, double wavelength) {
        double frequency = area.window().sigmaFrequency();
        // Power is the square of an amplitude.
        double wider = Math.sqrt(frequency * frequency + 2 * variance / (wavelength * wavelength));
        return new CoherenceWindow(area.window().sigmaMetres() * frequency / wider);
    }

    private static double sigma(CoherenceWindow window) {
        // Power is the square of an amplitude.
        return MIDDLE_WAVELENGTH * window.sigmaFrequency() / Math.sqrt(2);
    }

    /** Returns the number of levels for points only: 1 or 0. */
    public int pointLevelCount() {
        return levels.size() > 1 && levels.get(1).area().equals(area) ? 1 : 0;
    }

    /** Returns the number of slices, the same in all levels. */
    public int slices() {
        return levels.get(0).design().slices();
    }
}
