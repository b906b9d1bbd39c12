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
 * @param area the window that is seen at a point, and its average
 * @param levels the finest first, which is that of the area itself; where others are interpolated along lines, one for points alone before it
 * @param numbers of their coefficients
 * @param tolerance relative error of X, Y, Z that is promised of what is looked up
 */
public record ColorTable(GaussianArea area, List<Level> levels, NumberFormat numbers, double tolerance) {
    /** Where an eye sees most, metres. */
    public static final double MIDDLE_WAVELENGTH = 550e-9;

    // A level's Gaussians are so many times as wide as those of the level before it.
    private static final double RATIO = Math.sqrt(2);
    // Beyond, a level is a color for a fifth of the hemisphere. In (u, v).
    private static final double WIDEST = 0.06;

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
     * @param wings whether light counts that is a millionth of the order beside it
     */
    public record Level(
            GaussianArea area, double scale, TableDesign design, Interpolation interpolation, boolean wings) {}

    /** Copies. */
    public ColorTable {
        levels = List.copyOf(levels);
    }

    /**
     * A table that keeps a tolerance.
     *
     * @param area what is seen at a point; of a coherent average, which is no sum of Gaussians, there is one level
     * @param relief what {@link TableDesign#depth} says, metres
     * @param lone whether orders stand alone (see {@link LinearTrial})
     */
    public static ColorTable within(double tolerance, GaussianArea area, double relief, boolean lone) {
        boolean coherent = area.average() == Average.COHERENT;
        boolean coarse = tolerance >= LINES_TOLERANCE && !coherent;
        boolean lines = coarse && !lone;
        List<Level> levels = new ArrayList<>();
        double finest = sigma(area.window());
        for (double widening = 1; widening == 1 || finest * widening <= WIDEST; widening *= RATIO) {
            GaussianArea wider = area.with(new CoherenceWindow(area.window().sigmaMetres() / widening));
            TableDesign bright = TableDesign.within(tolerance, wider, relief);
            TableDesign design = coarse ? withMoreSlices(bright) : bright;
            if (coarse && lone) {
                design = new TableDesign(LONE_STEP * design.step(), design.slices());
            }
            if (levels.isEmpty() || !lines) {
                levels.add(new Level(
                        wider, 1 / (widening * widening), design, Interpolation.CUBIC, levels.isEmpty() || lone));
            }
            if (lines) {
                TableDesign wide = new TableDesign(LINES_STEP * design.step(), design.slices());
                levels.add(new Level(
                        wider, 1 / (widening * widening), wide, Interpolation.SHIFTED_LINES, levels.size() == 1));
            }
            if (coherent) {
                break;
            }
        }
        NumberFormat numbers = tolerance < HALF_TOLERANCE ? NumberFormat.FLOAT : NumberFormat.HALF;
        return new ColorTable(area, levels, numbers, tolerance);
    }

    private static TableDesign withMoreSlices(TableDesign design) {
        return new TableDesign(design.step(), 1 + (int) Math.ceil(MORE_SLICES * (design.slices() - 1)));
    }

    /** Standard deviation in (u, v) of what the finest level shows of a sharp order. */
    public double sigma() {
        return sigma(area.window());
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
