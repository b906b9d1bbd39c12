package sunbeam.precompute.colortable;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;

/**
 * How a table of colors is divided: levels of the same colors, each averaged over wider surroundings of (u, v), for pixels that see more than a
 * point. The ensemble average under a Gaussian window is a sum of Gaussians in frequency; its mean with Gaussian weights around a place is the
 * same sum with wider ones, which is what a shorter window gives. So a coarse level is evaluated as such, at its few texels, and never
 * averaged from the many of a fine one (docs/color-tables.md). Level 0 is for points, as maps and lists look them up.
 *
 * <p>A shorter window's Gaussians are wider by a certain width in frequency, so in (u, v) by a width that grows with the
 * wavelength: {@link #sigma()} is that at {@link #MIDDLE_WAVELENGTH}.
 *
 * <p>Of a surface with relief finer than a pixel (Toksvig 2005; Olano and Baker 2010) all levels are averages over its slopes, too: a slope
 * moves (u, v) by itself times w, at all wavelengths alike. Such a table is as coarse as that blur, and a scene of such a surface needs no finer
 * one.
 *
 * @param area the window that is seen at a point, and its average
 * @param levels the finest first, which is that of the area itself; where others are interpolated along lines, one for points alone before it
 * @param numbers of their coefficients
 * @param tolerance relative error of X, Y, Z that is promised of what is looked up
 * @param slopeDeviation standard deviation, along either axis, of the slopes of relief that all levels are averages over; 0 for none
 */
public record ColorTable(
        GaussianArea area, List<Level> levels, NumberFormat numbers, double tolerance, double slopeDeviation) {
    /** Where an eye sees most, metres. */
    public static final double MIDDLE_WAVELENGTH = 550e-9;

    // A level's Gaussians are so many times as wide as those of the level before it.
    private static final double RATIO = Math.sqrt(2);
    // Beyond, a level is a color for a fifth of the hemisphere. In (u, v).
    private static final double WIDEST = 0.06;

    // A table of relief is right down to this |w|, and wider than the relief below: where both directions graze.
    private static final double SHALLOWEST = 0.5;

    /** The largest |w|. */
    public static final double DEEPEST = 2;

    // From this tolerance on pixels that see more than a point look between texels along straight lines, unless orders
    // stand
    // alone: on their flanks lines err by a tenth.
    private static final double LINES_TOLERANCE = 5e-3;

    // Their texels' distance, beside that of splines: errors of means just begin to grow (docs/color-tables.md).
    private static final double LINES_STEP = 1.5;

    // Where orders stand alone splines ring in the dark beside them; at 1e-2 that is 4 % at the 95th percentile of
    // blaze, in these
    // steps 2 %.
    private static final double LONE_STEP = 0.85;

    // At such tolerances so many times the slices that bright directions need: where an order vanishes, what is left is
    // small
    // beside what slices lose of it. Cheap where texels are few.
    private static final double MORE_SLICES = 1.5;

    // A color errs by twice as much as its root: by no more than 1e-3, and less, since several coefficients make it.
    private static final double HALF_TOLERANCE = 1e-3;

    /**
     * One level.
     *
     * @param area its window
     * @param scale what its power counts: the mean of a Gaussian of height 1 is lower as much as it is wider
     * @param design its step and slices
     * @param interpolation between its texels
     * @param includeFaintTails whether light counts that is a millionth of the order beside it
     */
    public record Level(
            GaussianArea area,
            double scale,
            TableDesign design,
            Interpolation interpolation,
            boolean includeFaintTails) {}

    /** Copies. */
    public ColorTable {
        levels = List.copyOf(levels);
    }

    /**
     * Whether relief blurs more than the coarsest level of a table without it does: footprints see less in those levels. So no table of
     * relief is finer than a quarter of that level, whose powers take some hundred MB at most.
     *
     * @param slopeDeviation of its slopes
     */
    public static boolean isOfRelief(double slopeDeviation) {
        return DEEPEST * slopeDeviation > WIDEST;
    }

    /** As {@link #within(double, GaussianArea, double, boolean, double)}, without relief finer than a pixel. */
    public static ColorTable within(double tolerance, GaussianArea area, double relief, boolean ordersIsolated) {
        return within(tolerance, area, relief, ordersIsolated, 0);
    }

    /**
     * A table that keeps a tolerance.
     *
     * @param area what is seen at a point; of a coherent average, which is no sum of Gaussians, there is one level
     * @param relief what {@link TableDesign#depth} says, metres
     * @param ordersIsolated whether orders stand alone in the dark, as a grating's do, on whose flanks lines err by a tenth; with slopes none does
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

    /** Standard deviation in (u, v) of what the finest level shows of a sharp order. */
    public double sigma() {
        return sigma(area.window());
    }

    /** As much of the first level for pixels, where relief adds least: levels after it have a variance twice as large each. */
    public double finestSigma() {
        return sigma(levels.get(ofPoints()).area().window());
    }

    /**
     * The variance in (u, v) by which slopes and a level's average widen what {@link #area()} shows of a sharp order, at all wavelengths.
     *
     * @param depth |w|
     */
    public double slopeVariance(int level, double depth) {
        double finest = Math.pow(finestSigma(), 2);
        double relief = Math.pow(slopeDeviation * depth, 2);
        return Math.max(relief, finest - Math.pow(sigma(), 2)) + (Math.pow(2, level) - 1) * finest;
    }

    /** The area under the shortest window that any level is evaluated with. */
    public GaussianArea widest() {
        int coarsest = levels.size() - 1;
        return slopeDeviation == 0
                ? levels.get(coarsest).area()
                : area.with(widened(slopeVariance(coarsest, DEEPEST), MIDDLE_WAVELENGTH));
    }

    /** The window that shows orders of a wavelength wider than that of {@link #area()} by a variance in (u, v). */
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

    /** Levels for pixels that see points alone: 1 or 0. */
    public int ofPoints() {
        return levels.size() > 1 && levels.get(1).area().equals(area) ? 1 : 0;
    }

    /** Slices, of which all levels have as many. */
    public int slices() {
        return levels.get(0).design().slices();
    }
}
