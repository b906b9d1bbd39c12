package sunbeam.app.terminal.options;

import java.util.List;
import java.util.Locale;
import sunbeam.app.terminal.SettingOptions;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.setting.Kinds;
import sunbeam.precompute.setting.Setting;

/** Where the light comes from; to be used as a picocli mixin. */
public final class LightOptions extends SettingOptions {
    // Closer to the horizon no radiance is left to divide by.
    private static final double LARGEST_THETA = Math.toRadians(89.9);
    private static final double LARGEST_PHI = Math.toRadians(36_000);

    /** Radians. */
    public static final Setting<Double> THETA_I = new Setting<>(
                    "thetaI", Kinds.angle(0, LARGEST_THETA), "Angle of the light to the normal in degrees, 0 to 89.9.")
            .withStandard(0.0);

    /** Radians. */
    public static final Setting<Double> PHI_I = new Setting<>(
                    "phiI",
                    Kinds.angle(-LARGEST_PHI, LARGEST_PHI),
                    "Azimuth of the light in degrees, counter-clockwise from +x.")
            .withStandard(0.0);

    public LightOptions() {
        super(List.of(THETA_I, PHI_I));
    }

    /** The unit vector towards the light. */
    public Direction direction() {
        return Direction.ofDegrees(degrees(THETA_I), degrees(PHI_I));
    }

    /** The angles, for metadata. */
    public String describe() {
        return String.format(Locale.ROOT, "theta %s, phi %s degrees", degrees(THETA_I), degrees(PHI_I));
    }

    private double degrees(Setting<Double> angle) {
        return Math.toDegrees(choices().get(angle));
    }
}
