package sunbeam.app.cli;

import java.util.List;
import java.util.Map;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Angles;

/** Options of the light's direction; a picocli mixin. */
public final class LightOptions extends SettingOptions {
    // Largest angle to the normal, radians: closer to the horizon the irradiance is too small to divide by.
    private static final double LARGEST_THETA = Math.toRadians(89.9);
    // Largest azimuth, a hundred turns, in radians: more is a mistake of the user.
    private static final double LARGEST_PHI = Math.toRadians(36_000);

    /** Angle between light and normal, radians. */
    public static final Setting<Double> THETA_I = new Setting<>(
                    "thetaI",
                    ValueKind.angle(0, LARGEST_THETA),
                    "Angle of the light to the normal in degrees, 0 to 89.9.")
            .withStandard(0.0);

    /** Azimuth of the light, radians, counterclockwise from +x. */
    public static final Setting<Double> PHI_I = new Setting<>(
                    "phiI",
                    ValueKind.angle(-LARGEST_PHI, LARGEST_PHI),
                    "Azimuth of the light in degrees, counter-clockwise from +x.")
            .withStandard(0.0);

    public LightOptions() {
        this(Map.of());
    }

    public LightOptions(Map<Setting<?>, String> helpTexts) {
        super(List.of(THETA_I, PHI_I), helpTexts);
    }

    public Direction direction() {
        return Direction.ofDegrees(
                Math.toDegrees(choices().get(THETA_I)), Math.toDegrees(choices().get(PHI_I)));
    }

    public String describe() {
        return "theta " + written(THETA_I) + ", phi " + written(PHI_I) + " degrees";
    }

    /** Returns an angle in degrees, as it was typed: a conversion to radians and back would change the last digits. */
    public double degrees(Setting<Double> angle) {
        return Double.parseDouble(written(angle));
    }

    /** Returns an angle in degrees, without the unit. */
    public String written(Setting<Double> angle) {
        return Angles.format(choices().get(angle)).replace(" deg", "");
    }
}
