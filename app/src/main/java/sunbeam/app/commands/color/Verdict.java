package sunbeam.app.commands.color;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.units.Lengths;

/**
 * What a surface's color comes to, in one sentence.
 *
 * @param sentence for people
 * @param colored whether the surface has a color of its own: without order it has none
 */
record Verdict(String sentence, boolean colored) {
    private static final int VIOLET = 400;
    private static final int RED = 700;

    /**
     * Of a surface under one light.
     *
     * @param coherenceLength of the light, metres
     * @param allGloss whether the mirror's light reaches all angles that are looked at
     */
    static Verdict of(Patch patch, SurfaceOrder order, Direction light, double coherenceLength, boolean allGloss) {
        if (patch.isMirror()) {
            return without(order.sentence());
        }
        if (allGloss) {
            return without("No color can be told: light that is coherent over only "
                    + Lengths.rounded(coherenceLength, 3)
                    + ", as far as the scan or the light reaches, blurs every order"
                    + " into the gloss");
        }
        if (!order.found()) {
            return without(order.sentence());
        }
        if (order.grating().isEmpty()) {
            return with(
                    "Order found, but no period that the scan tells: the angles of its colors are those of this scan");
        }
        SurfaceOrder.Grating grating = order.grating().get();
        if (!grating.isKnown()) {
            return with("Order found, but its period is uncertain (" + period(grating)
                    + "): so are the angles of its colors");
        }
        return firstOrder(grating, 1, light)
                .or(() -> firstOrder(grating, -1, light))
                .map(colors -> with("First-order colors: " + colors + ", by lines " + period(grating)
                        + String.format(
                                Locale.ROOT,
                                " apart across azimuth %.0f degrees",
                                Math.rint(grating.azimuthDegrees()) + 0.0)))
                .orElseGet(() -> without(
                        "No order of visible light: lines " + period(grating) + " apart are too fine for this light"));
    }

    private static Verdict with(String sentence) {
        return new Verdict(sentence, true);
    }

    private static Verdict without(String sentence) {
        return new Verdict(sentence, false);
    }

    /** Between which angles the order's colors lie, whatever period of the interval is the true one. */
    private static Optional<String> firstOrder(SurfaceOrder.Grating grating, int order, Direction light) {
        int[] visible = IntStream.rangeClosed(VIOLET, RED)
                .filter(nanometres -> Math.abs(grating.angleDegrees(grating.period(), order, nanometres * 1e-9, light))
                        <= StripColors.LARGEST_VIEW_DEGREES)
                .toArray();
        if (visible.length == 0) {
            return Optional.empty();
        }
        int first = visible[0];
        int last = visible[visible.length - 1];
        boolean rising = order > 0;
        return Optional.of(String.format(
                Locale.ROOT,
                "%s at %.0f to %s at %.0f degrees",
                name(first),
                end(grating, order, first, light, !rising),
                name(last),
                end(grating, order, last, light, rising)));
    }

    /** The largest or the smallest angle at which the interval's periods send a wavelength, degrees. */
    private static double end(
            SurfaceOrder.Grating grating, int order, int nanometres, Direction light, boolean largest) {
        DoubleStream angles = DoubleStream.of(grating.low(), grating.period(), grating.high())
                .map(period -> grating.angleDegrees(period, order, nanometres * 1e-9, light))
                .filter(angle -> !Double.isNaN(angle));
        return (largest ? angles.max() : angles.min()).orElseThrow() + 0.0;
    }

    private static String name(int nanometres) {
        if (nanometres < 450) {
            return "violet";
        }
        if (nanometres < 495) {
            return "blue";
        }
        if (nanometres < 570) {
            return "green";
        }
        return nanometres < 590 ? "yellow" : nanometres < 620 ? "orange" : "red";
    }

    private static String period(SurfaceOrder.Grating grating) {
        return sunbeam.precompute.analysis.Verdict.length(grating.period(), grating.low(), grating.high());
    }
}
