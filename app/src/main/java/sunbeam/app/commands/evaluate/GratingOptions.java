package sunbeam.app.commands.evaluate;

import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.AngleConverter;
import sunbeam.app.terminal.LengthConverter;
import sunbeam.app.terminal.Range;
import sunbeam.app.terminal.RangeConverter;
import sunbeam.app.terminal.UsageException;

/** Light, plane and grid of an evaluation; to be used as a picocli mixin. */
public final class GratingOptions {
    private static final String AUTO = "auto";

    @Option(
            names = "--theta-i",
            paramLabel = "ANGLE",
            defaultValue = "75",
            converter = AngleConverter.class,
            description = "Angle of the light to the normal in degrees, 0 to 89.9. Default: ${DEFAULT-VALUE}, the"
                    + " thesis's.")
    private double thetaRadians;

    @Option(
            names = "--phi-i",
            paramLabel = "ANGLE",
            defaultValue = "0",
            converter = AngleConverter.class,
            description = "Azimuth of the light against the grating's direction in degrees. Default:"
                    + " ${DEFAULT-VALUE}, light in the plane; at other angles the orders lie on a cone, and theta_r"
                    + " is the angle whose sine is the viewer's component along the grating.")
    private double phiRadians;

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
            defaultValue = "380:780:1",
            converter = RangeConverter.class,
            description = "Wavelengths in nm, within 380..780. Default: ${DEFAULT-VALUE}.")
    private Range wavelengths;

    @Option(
            names = "--period",
            paramLabel = "LENGTH",
            converter = LengthConverter.class,
            description = "Look for the first order of this period, a fifth more or less, instead of the one that the"
                    + " heights' power spectrum shows.")
    private Double period;

    /**
     * What is asked for, checked as far as it can be without the patch.
     *
     * @throws UsageException for a value that cannot be used
     */
    GratingRequest request() {
        return new GratingRequest(
                thetaRadians,
                phiRadians,
                givenAzimuth(),
                Optional.ofNullable(angles),
                wavelengths,
                period == null ? OptionalDouble.empty() : OptionalDouble.of(period));
    }

    /** The azimuth in radians; empty for auto. */
    private OptionalDouble givenAzimuth() {
        if (azimuth.equals(AUTO)) {
            return OptionalDouble.empty();
        }
        try {
            return OptionalDouble.of(new AngleConverter().convert(azimuth));
        } catch (picocli.CommandLine.TypeConversionException failure) {
            throw new UsageException("--azimuth: " + failure.getMessage() + ", or auto");
        }
    }
}
