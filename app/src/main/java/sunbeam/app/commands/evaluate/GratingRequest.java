package sunbeam.app.commands.evaluate;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import sunbeam.app.terminal.Range;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.units.Lengths;

/**
 * Light, plane and grid of an evaluation.
 *
 * @param thetaI angle of the light to the normal, radians
 * @param phiI azimuth of the light against the grating's direction, radians
 * @param azimuth direction of the grating in the patch, radians; empty where the heights are to tell
 * @param angles of the viewer in degrees; empty for all that the first order takes
 * @param wavelengths in nm
 * @param all whether all of these wavelengths are looked at, however long it takes; else fewer of a large scan
 * @param period to look for, metres; empty where the heights are to tell
 */
public record GratingRequest(
        double thetaI,
        double phiI,
        OptionalDouble azimuth,
        Optional<Range> angles,
        Range wavelengths,
        boolean all,
        OptionalDouble period) {
    // A period's variance needs as many.
    private static final int FEWEST = 3;
    private static final int DIGITS = 3;
    // Angles that are taken where none are given, as many as the thesis takes.
    private static final int MOST_ANGLES = 1500;
    // 160 MB of doubles.
    private static final long MOST_DIRECTIONS = 20_000_000;
    // A ridge is 1.7 deviations wide at half its height; three samples must lie on its top.
    private static final double COARSEST_STEP = 0.6;

    /**
     * Checks of the ranges what can be checked without the patch.
     *
     * @throws UsageException for a value that cannot be used
     */
    public GratingRequest {
        double shortest = CieTable.MINIMUM_WAVELENGTH * 1e9;
        double longest = CieTable.MAXIMUM_WAVELENGTH * 1e9;
        if (wavelengths.minimum() < shortest - 1e-6 || wavelengths.maximum() > longest + 1e-6) {
            throw new UsageException(String.format(
                    Locale.ROOT, "--wavelengths %s leaves the visible band; give 380 to 780 nm", text(wavelengths)));
        }
        if (wavelengths.count() < FEWEST) {
            throw new UsageException(String.format(
                    Locale.ROOT,
                    "--wavelengths %s has %d of them; a period's variance needs 3 or more",
                    text(wavelengths),
                    wavelengths.count()));
        }
        checkAngles(angles, wavelengths, new GratingPlane(thetaI, phiI, 0));
    }

    private static void checkAngles(Optional<Range> given, Range wavelengths, GratingPlane plane) {
        if (given.isEmpty()) {
            return;
        }
        Range angles = given.get();
        double largest = Math.toDegrees(plane.largestThetaR());
        if (angles.minimum() < -largest - 1e-9 || angles.maximum() > largest + 1e-9) {
            throw new UsageException(String.format(
                    Locale.ROOT,
                    "--angles %s leaves the hemisphere; give %.6g to %.6g degrees",
                    text(angles),
                    -largest,
                    largest));
        }
        if (angles.count() < 3) {
            throw new UsageException(String.format(
                    Locale.ROOT, "--angles %s has %d of them; a peak needs 3 or more", text(angles), angles.count()));
        }
        if ((long) angles.count() * wavelengths.count() > MOST_DIRECTIONS) {
            throw new UsageException(String.format(
                    Locale.ROOT,
                    "--angles %s and --wavelengths %s make %d directions; take larger steps for %d or less",
                    text(angles),
                    text(wavelengths),
                    (long) angles.count() * wavelengths.count(),
                    MOST_DIRECTIONS));
        }
    }

    private static String text(Range range) {
        return String.format(
                Locale.ROOT, "%s:%s:%s", plain(range.minimum()), plain(range.maximum()), plain(range.step()));
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Long.toString((long) value)
                : Double.toString(value);
    }

    GratingPlane plane(double azimuthRadians) {
        return new GratingPlane(thetaI, phiI, azimuthRadians);
    }

    /**
     * Angles and wavelengths, checked against the window's resolution: all, or as many as are computed in time.
     *
     * @throws UsageException where the steps are too coarse to see a peak, or the first order is not to be seen
     */
    ResponseGrid grid(GratingPlane plane, FirstOrder order, DirectionBudget budget) {
        ResponseGrid grid = grid(plane, order, wavelengths, MOST_ANGLES);
        requireFineAngles(grid, budget.window());
        if (all) {
            return grid;
        }
        for (DirectionBudget.Rung rung : DirectionBudget.LADDER) {
            Range stepped = new Range(wavelengths.minimum(), wavelengths.maximum(), rung.stepNm());
            ResponseGrid thinner = grid(plane, order, stepped, rung.angles());
            if (!isFine(thinner, budget.window())) {
                return grid;
            }
            grid = thinner;
            if (budget.holds((long) grid.wavelengths().length * grid.angles().length)) {
                return grid;
            }
        }
        return grid;
    }

    private ResponseGrid grid(GratingPlane plane, FirstOrder order, Range range, int count) {
        double[] lambdas = seen(plane, order, range);
        return new ResponseGrid(plane, lambdas, angles(plane, order, lambdas, count));
    }

    /**
     * Wavelengths, metres: all, or where the order of a short period is above the horizon at less than half of them, those
     * at which it is.
     *
     * @throws UsageException where they are fewer than three
     */
    private double[] seen(GratingPlane plane, FirstOrder order, Range range) {
        double[] all = Arrays.stream(range.values()).map(nm -> nm * 1e-9).toArray();
        if (angles.isPresent() || order.angles(plane, all[0], all[all.length - 1]).length > 0) {
            return all;
        }
        double longest = order.longestWavelength(plane);
        double[] seen =
                Arrays.stream(all).filter(wavelength -> wavelength <= longest).toArray();
        if (seen.length < FEWEST) {
            throw new UsageException(String.format(
                    Locale.ROOT,
                    "no angle sees the first order of a period near %s at %d --wavelengths or more: with the light at --theta-i %s it is seen up to %s, and with no light beyond %s%s",
                    Lengths.rounded(order.middle(), DIGITS),
                    FEWEST,
                    Degrees.text(thetaI),
                    Lengths.rounded(longest, DIGITS),
                    Lengths.rounded(2 * order.middle(), DIGITS),
                    longest > all[0] ? "; give finer steps of --wavelengths below that" : ""));
        }
        return seen;
    }

    /** Which wavelengths are left out because no angle sees the order at them, in words; empty where all are taken. */
    Optional<String> unseen(GratingPlane plane, FirstOrder order) {
        double[] seen = seen(plane, order, wavelengths);
        return seen.length == wavelengths.count()
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "the first order of a period of about %s is seen up to %s with the light at --theta-i %s; the response takes the %d of %d wavelengths up to there",
                        Lengths.rounded(order.middle(), DIGITS),
                        Lengths.rounded(order.longestWavelength(plane), DIGITS),
                        Degrees.text(thetaI),
                        seen.length,
                        wavelengths.count()));
    }

    /** What is left out of a grid's wavelengths and angles, in words; empty for nothing. */
    Optional<String> leftOut(ResponseGrid grid) {
        int taken = grid.wavelengths().length;
        double last = grid.wavelengths()[taken - 1] * 1e9;
        // Those that no angle sees are told of elsewhere.
        long asked = Arrays.stream(wavelengths.values())
                .filter(nm -> nm <= last * (1 + 1e-9))
                .count();
        return taken == asked
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "the scan is large, so the response takes only %d wavelengths and %d angles; --wavelengths %s takes all, %.0f times as long",
                        taken,
                        grid.angles().length,
                        text(wavelengths),
                        (double) wavelengths.count()
                                * angles.map(Range::count).orElse(MOST_ANGLES)
                                / taken
                                / grid.angles().length));
    }

    private double[] angles(GratingPlane plane, FirstOrder order, double[] lambdas, int count) {
        if (angles.isPresent()) {
            return Arrays.stream(angles.get().values()).map(Math::toRadians).toArray();
        }
        double[] ends = order.angles(plane, lambdas[0], lambdas[lambdas.length - 1]);
        double[] values = new double[count];
        Arrays.setAll(values, i -> ends[0] + (ends[1] - ends[0]) * i / (count - 1));
        return values;
    }

    private static boolean isFine(ResponseGrid grid, CoherenceWindow window) {
        return coarsestStep(grid) <= COARSEST_STEP * window.sigmaFrequency();
    }

    /** Of u / lambda, cycles per metre. */
    private static double coarsestStep(ResponseGrid grid) {
        double shortest = grid.wavelengths()[0];
        double[] all = grid.angles();
        double coarsest = 0;
        for (int i = 1; i < all.length; i++) {
            coarsest = Math.max(
                    coarsest, Math.abs(grid.plane().u(all[i]) - grid.plane().u(all[i - 1])) / shortest);
        }
        return coarsest;
    }

    private static void requireFineAngles(ResponseGrid grid, CoherenceWindow window) {
        double coarsest = coarsestStep(grid);
        double[] all = grid.angles();
        double allowed = COARSEST_STEP * window.sigmaFrequency();
        if (coarsest > allowed) {
            double step = Math.toDegrees(all[1] - all[0]);
            throw new UsageException(String.format(
                    Locale.ROOT,
                    "--angles: steps of %.3g degrees are too coarse for peaks as sharp as this window's; give %.2g or less",
                    step,
                    0.99 * step * allowed / coarsest));
        }
    }
}
