package sunbeam.app.terminal.options;

import picocli.CommandLine.Option;
import sunbeam.app.terminal.AngleConverter;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.optics.Direction;

/** Where the light comes from; to be used as a picocli mixin. */
public final class LightOptions {
    // Closer to the horizon no radiance is left to divide by.
    private static final double LARGEST_DEGREES = 89.9;

    @Option(
            names = "--theta-i",
            paramLabel = "ANGLE",
            defaultValue = "0",
            converter = AngleConverter.class,
            description = "Angle of the light to the normal in degrees, 0 to 89.9. Default: ${DEFAULT-VALUE}.")
    private double thetaRadians;

    @Option(
            names = "--phi-i",
            paramLabel = "ANGLE",
            defaultValue = "0",
            converter = AngleConverter.class,
            description = "Azimuth of the light in degrees, counter-clockwise from +x. Default: ${DEFAULT-VALUE}.")
    private double phiRadians;

    /** The unit vector towards the light. */
    public Direction direction() {
        double degrees = Math.toDegrees(thetaRadians);
        if (!(degrees >= 0 && degrees <= LARGEST_DEGREES)) {
            throw new UsageException("--theta-i " + degrees + " is out of range; give 0 to " + LARGEST_DEGREES);
        }
        return Direction.ofDegrees(degrees, Math.toDegrees(phiRadians));
    }

    /** The angles, for metadata. */
    public String describe() {
        return "theta %s, phi %s degrees".formatted(Math.toDegrees(thetaRadians), Math.toDegrees(phiRadians));
    }
}
