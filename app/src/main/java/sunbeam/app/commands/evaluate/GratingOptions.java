package sunbeam.app.commands.evaluate;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.Range;
import sunbeam.app.terminal.RangeConverter;
import sunbeam.app.terminal.SettingOptions;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.LightOptions;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.units.Angles;

/** Light, plane and grid of an evaluation; to be used as a picocli mixin. */
public final class GratingOptions extends SettingOptions {
    private static final String AUTO = "auto";
    private static final Range ALL_WAVELENGTHS = new Range(380, 780, 1);

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

    @Option(
            names = "--azimuth",
            paramLabel = "ANGLE",
            defaultValue = AUTO,
            description = "Direction of the grating in the patch (across its ridges), degrees counter-clockwise from"
                    + " +x; auto (default): that of the strongest peak in the heights' power spectrum, -90 to 90.")
    private String azimuth;

    @Option(
            names = "--angles",
            paramLabel = "MIN:MAX:STEP",
            converter = RangeConverter.class,
            description = "Angles theta_r of the viewer in degrees, positive on the light's side, so that the mirror"
                    + " is at -theta_i. Default: 1500 over all that the first order takes.")
    private Range angles;

    @Option(
            names = "--wavelengths",
            paramLabel = "MIN:MAX:STEP",
            converter = RangeConverter.class,
            description = "Wavelengths in nm, within 380..780. Default: 380:780:1; of scans so large that this takes"
                    + " minutes, larger steps and fewer angles, which a line says.")
    private Range wavelengths;

    public GratingOptions() {
        super(List.of(THETA_I, PHI_I, PERIOD));
    }

    /**
     * What is asked for, checked as far as it can be without the patch.
     *
     * @throws UsageException for a value that cannot be used
     */
    GratingRequest request() {
        Choices light = choices();
        return new GratingRequest(
                light.get(THETA_I),
                light.get(PHI_I),
                givenAzimuth(),
                Optional.ofNullable(angles),
                wavelengths == null ? ALL_WAVELENGTHS : wavelengths,
                wavelengths != null,
                light.find(PERIOD).map(OptionalDouble::of).orElseGet(OptionalDouble::empty));
    }

    /** The azimuth in radians; empty for auto. */
    private OptionalDouble givenAzimuth() {
        if (azimuth.equals(AUTO)) {
            return OptionalDouble.empty();
        }
        try {
            return OptionalDouble.of(Angles.parse(azimuth));
        } catch (IllegalArgumentException failure) {
            throw new UsageException("--azimuth: " + failure.getMessage() + ", or auto");
        }
    }
}
