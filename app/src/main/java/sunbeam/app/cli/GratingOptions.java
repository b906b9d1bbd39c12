package sunbeam.app.cli;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.evaluation.GratingPlane.ResponseMatrix.ResponseGrid;
import sunbeam.precompute.evaluation.Ridge.Peaks;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Angles;
import sunbeam.precompute.units.Lengths;

/** Options of light, plane, angles and wavelengths of an evaluation; a picocli mixin. */
public final class GratingOptions extends SettingOptions {
    private static final String AUTO = "auto";
    private static final int MOST_ANGLES = 1500;
    // Least number of angles in which a peak can be found.
    private static final int FEWEST = 3;
    // Limit of pairs of angle and wavelength: 160 MB of doubles.
    private static final long MOST_DIRECTIONS = 20_000_000;
    // Largest step between angles, in deviations of the window's spectrum: three samples lie on a ridge's top half.
    private static final double COARSEST_STEP = 0.6;
    private static final Setting<Double> THETA_I = LightOptions.THETA_I.withStandard(Math.toRadians(75));
    private static final Setting<Double> PHI_I = new Setting<>(
                    "phiI",
                    LightOptions.PHI_I.kind(),
                    "Azimuth of the light against the grating's direction in degrees; 0 is in the plane; at other angles"
                            + " the orders lie on a cone, and theta_r is the angle whose sine is the viewer's component"
                            + " along the grating.")
            .withStandard(0.0);
    private static final Setting<Double> PERIOD = new Setting<>(
            "period",
            MethodSettings.SPACING.kind(),
            "Look for the first order of this period, a fifth more or less, instead of the one that the heights' power"
                    + " spectrum shows.");
    private static final Setting<Peaks> PEAKS = new Setting<>(
                    "peaks",
                    ValueKind.word("HOW", Peaks.class),
                    "Angle of the first order at each wavelength: ridge (default) follows the strongest; maximum takes the"
                            + " largest value, as algorithm 4.1 of the thesis; maximum-by-count also labels C wavelengths in"
                            + " steps of 1 / C of their range, as it is written, not 1 / (C - 1).")
            .withStandard(Peaks.RIDGE);

    @Option(
            names = "--azimuth",
            paramLabel = "ANGLE",
            defaultValue = AUTO,
            description = "Direction of the grating in the patch (across its ridges), degrees counter-clockwise from"
                    + " +x: waves within 2 degrees of it count; auto (default): that of the strongest wave, -90 to 90.")
    private String azimuth;

    @Option(
            names = "--angles",
            paramLabel = "MIN:MAX:STEP",
            description = "Angles theta_r of the viewer in degrees, positive on the light's side, so that the mirror"
                    + " is at -theta_i. Default: 1500 angles over the range of the first order.")
    private Range angles;

    @Option(
            names = "--wavelengths",
            paramLabel = "MIN:MAX:STEP",
            defaultValue = "380:780:2",
            description = "Wavelengths in nm, within 380..780; of one alone the plot is the response over the angle."
                    + " Default: ${DEFAULT-VALUE}.")
    private Range wavelengths;

    public GratingOptions() {
        super(List.of(THETA_I, PHI_I, PERIOD, PEAKS));
    }

    void check() {
        azimuth();
        period();
        wavelengths.requireWithin(
                "--wavelengths", 1e9 * CieTable.MINIMUM_WAVELENGTH, 1e9 * CieTable.MAXIMUM_WAVELENGTH, "nm");
        double largest = Math.toDegrees(plane(0).largestThetaR());
        if (angles != null) {
            angles.requireWithin("--angles", -largest, largest, "degrees");
            UsageException.throwIf(
                    angles.count() < FEWEST,
                    "--angles has " + angles.count() + " values; give " + FEWEST + " or more, MIN:MAX:STEP");
        }
        int columns = angles == null ? MOST_ANGLES : angles.count();
        UsageException.throwIf(
                (long) columns * wavelengths.count() > MOST_DIRECTIONS,
                Text.format(
                        "%d --angles and %d --wavelengths are too many; take larger steps for %d directions or less",
                        columns, wavelengths.count(), MOST_DIRECTIONS));
    }

    /** Returns the direction across the grating's lines, radians from +x; empty to derive it from the heights. */
    OptionalDouble azimuth() {
        try {
            return azimuth.equals(AUTO) ? OptionalDouble.empty() : OptionalDouble.of(Angles.parse(azimuth));
        } catch (IllegalArgumentException failure) {
            throw new UsageException("--azimuth: " + failure.getMessage() + ", or auto");
        }
    }

    Optional<Double> period() {
        return choices().find(PERIOD);
    }

    Peaks peaks() {
        return choices().get(PEAKS);
    }

    GratingPlane plane(double azimuthRadians) {
        return new GratingPlane(choices().get(THETA_I), choices().get(PHI_I), azimuthRadians);
    }

    /** Returns the grid of angles and wavelengths. Refuses steps too coarse to resolve a peak, and angles that do not see the order. */
    ResponseGrid grid(GratingPlane plane, GratingPlane.FirstOrder order, CoherenceWindow window) {
        double[] meters =
                Arrays.stream(wavelengths.values()).map(nm -> nm * 1e-9).toArray();
        ResponseGrid grid = new ResponseGrid(plane, meters, angles(plane, order, meters));
        double allowed = COARSEST_STEP * window.sigmaFrequency();
        double coarsest = grid.coarsestStep();
        double step = Math.toDegrees(grid.angles()[1] - grid.angles()[0]);
        UsageException.throwIf(
                coarsest > allowed,
                Text.format(
                        "--angles: steps of %.3g degrees are too coarse for peaks as sharp as this window's; give %.2g or less",
                        step, 0.95 * step * allowed / coarsest));
        return grid;
    }

    private double[] angles(GratingPlane plane, GratingPlane.FirstOrder order, double[] meters) {
        if (angles != null) {
            return Arrays.stream(angles.values()).map(Math::toRadians).toArray();
        }
        return order.angles(plane, meters[0], meters[meters.length - 1], MOST_ANGLES)
                .orElseThrow(() -> new UsageException(Text.format(
                        "no angle sees the first order of a period near %s at these --wavelengths and this --theta-i; no light shows it beyond %s",
                        Lengths.rounded(order.middle(), 3), Lengths.rounded(2 * order.middle(), 3))));
    }
}
