package sunbeam.app.terminal.options;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import sunbeam.app.terminal.SettingOptions;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.setting.Kinds;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Angles;

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

    private static final int MOST_LIGHTS = 24;

    /** Radians, of several lights. */
    private static final Setting<List<Double>> SEVERAL_THETA_I = new Setting<>(
                    "thetaI",
                    Kinds.of(
                            "ANGLE[,ANGLE]",
                            ValueKind.Form.QUANTITY,
                            LightOptions::angles,
                            angles -> angles,
                            LightOptions::written,
                            THETA_I.kind().range()),
                    "Angle of the light to the normal in degrees, 0 to 89.9; several, as in 0,30,60, for a map each"
                            + " beside each other.")
            .withStandard(List.of(0.0));

    private final boolean several;

    public LightOptions() {
        this(false, Map.of());
    }

    private LightOptions(boolean several, Map<Setting<?>, String> told) {
        super(List.of(several ? SEVERAL_THETA_I : THETA_I, PHI_I), told);
        this.several = several;
    }

    /** Options of a command that takes several lights. */
    public static LightOptions several() {
        return new LightOptions(true, Map.of());
    }

    private static List<Double> angles(String text) {
        String[] parts = text.split(",", -1);
        if (parts.length > MOST_LIGHTS) {
            throw new IllegalArgumentException("has " + parts.length + " angles; give " + MOST_LIGHTS + " at most");
        }
        return Stream.of(parts)
                .map(part -> THETA_I.kind().check(THETA_I.kind().parse(part)))
                .toList();
    }

    private static String written(List<Double> angles) {
        return angles.stream().map(Angles::format).collect(Collectors.joining(","));
    }

    /**
     * Options of a command that chooses the azimuth where none is given.
     *
     * @param chosen what it chooses, for the help
     */
    public static LightOptions choosingAzimuth(String chosen) {
        return new LightOptions(false, Map.of(PHI_I, chosen));
    }

    /** The unit vector towards the only light, or the first of several. */
    public Direction direction() {
        return directions().get(0);
    }

    /** The unit vectors towards the lights, one unless there may be several. */
    public List<Direction> directions() {
        double phi = Math.toDegrees(choices().get(PHI_I));
        return thetas().stream()
                .map(theta -> Direction.ofDegrees(Math.toDegrees(theta), phi))
                .toList();
    }

    private List<Double> thetas() {
        return several ? choices().get(SEVERAL_THETA_I) : List.of(choices().get(THETA_I));
    }

    /** The angles, for metadata. */
    public String describe() {
        return "theta " + written(thetas()).replace(" deg", "").replace(",", ", ") + ", phi " + written(PHI_I)
                + " degrees";
    }

    /** In degrees, as it was typed. */
    public String written(Setting<Double> angle) {
        return Angles.format(choices().get(angle)).replace(" deg", "");
    }
}
