package sunbeam.app.scene;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.Setting;

/**
 * How a scene's diffraction is computed. On a mesh the standard is colors from tables, for a pixel sees more than a point, and the
 * ensemble average, for it sees many coherence areas.
 *
 * @param choices of {@link Methods#SETTINGS}; those that another method has, but this one does not look at, are kept for it
 */
public record SceneMethod(Choices choices) {
    /** What holds where a scene names no method. */
    public static final MethodType STANDARD = TableMethod.TYPE;

    /** The tolerance of tables where a scene names none: finer ones take longer to make, and no screen shows what they gain. */
    public static final double TABLE_TOLERANCE = 1e-2;

    /** Of values that nobody named: another method has its own. */
    private static final Origin NOBODY = new Origin() {
        @Override
        public Place place() {
            return Place.PROGRAM;
        }

        @Override
        public String name(Setting<?> setting) {
            return PROGRAM.name(setting);
        }

        @Override
        public String complaint(Setting<?> setting, String value, String problem) {
            return PROGRAM.complaint(setting, value, problem);
        }
    };

    /**
     * Checks that there is such a method for meshes.
     *
     * @throws sunbeam.precompute.setting.SettingException in the words of the place where a choice was made that cannot be
     */
    public SceneMethod {
        choices = choices.only(Methods.SETTINGS);
        if (!choices.has(Methods.METHOD)) {
            choices = choices.over(Choices.at(NOBODY).with(Methods.METHOD, STANDARD));
        }
        if (!draws(choices.get(Methods.METHOD))) {
            throw choices.complaint(
                    Methods.METHOD,
                    "is for maps and lists of directions; for a mesh use one of "
                            + Methods.ALL.stream()
                                    .filter(SceneMethod::draws)
                                    .map(MethodType::label)
                                    .collect(Collectors.joining(", ")));
        }
        choices = choices.over(standard(choices));
        create(choices);
    }

    /** Whether a method can draw meshes. */
    public static boolean draws(MethodType type) {
        return !type.equals(ReferenceMethod.TYPE);
    }

    /** What holds on a mesh unless chosen otherwise; it is written down with the scene. */
    private static Choices standard(Choices chosen) {
        MethodType type = chosen.get(Methods.METHOD);
        Choices standard = Choices.at(NOBODY).with(Methods.METHOD, type);
        if (type.has(TOLERANCE) && !Preset.isThesis(chosen)) {
            standard = standard.with(
                    TOLERANCE,
                    type.equals(TableMethod.TYPE)
                            ? TABLE_TOLERANCE
                            : TOLERANCE.standard().orElseThrow());
        }
        return type.has(AVERAGE)
                ? standard.with(AVERAGE, Preset.isThesis(chosen) ? Average.COHERENT : Average.ENSEMBLE)
                : standard;
    }

    private static Method create(Choices choices) {
        return Methods.of(choices.without(ignoredSettings(choices.get(Methods.METHOD))));
    }

    public Method method() {
        return create(choices);
    }

    /** The same as it sees a patch: no farther than a scan reaches. */
    public SceneMethod seeing(Patch patch) {
        return new SceneMethod(ScanLimit.of(choices, patch).choices());
    }

    public MethodType type() {
        return get(Methods.METHOD);
    }

    /** What holds of a setting. */
    public <T> T get(Setting<T> setting) {
        return choices.get(setting);
    }

    /** Whether the thesis's choices stand in for those that nobody made. */
    public boolean isThesis() {
        return Preset.isThesis(choices);
    }

    /** What was chosen of the light. */
    public Choices light() {
        return choices.only(LightSettings.ALL);
    }

    /** The Gaussian window and its average, of methods that have them. */
    public GaussianArea area() {
        return GaussianArea.of(choices);
    }

    /**
     * The same with what others choose above it. Another method gives up what only the old one had and the tolerance that nobody
     * named, and the thesis's preset the tolerance, and the average unless it was named.
     */
    public SceneMethod with(Choices others) {
        MethodType type = others.get(Methods.METHOD, type());
        List<Setting<?>> kept = new ArrayList<>(FullMethod.TYPE.settings());
        kept.addAll(type.settings());
        kept.addAll(LightSettings.ALL);
        kept.add(Methods.METHOD);
        if (Preset.isThesis(others) || (!type.equals(type()) && isNobodys(TOLERANCE))) {
            kept.removeAll(List.of(TOLERANCE));
        }
        if (Preset.isThesis(others) && isNobodys(AVERAGE)) {
            kept.removeAll(List.of(AVERAGE));
        }
        Choices own = choices.only(kept);
        // Who chooses the method hears of what it lacks, and where nobody did, who may.
        return new SceneMethod(
                others.has(Methods.METHOD) || isNobodys(Methods.METHOD)
                        ? others.over(own)
                        : own.without(others.chosen()).over(others));
    }

    @SuppressWarnings("ReferenceEquality") // the one object
    private boolean isNobodys(Setting<?> setting) {
        return choices.origin(setting) == NOBODY;
    }

    /**
     * What a scene's file may say although the method does not look at it. A method without tables has no plan; the others
     * say themselves what is not theirs, but for the place of a window that they may not have.
     */
    private static List<Setting<?>> ignoredSettings(MethodType type) {
        List<Setting<?>> ignored =
                new ArrayList<>(type.has(TOLERANCE) ? GaussianArea.SETTINGS : FullMethod.TYPE.settings());
        ignored.removeAll(type.settings());
        if (type.has(TOLERANCE)) {
            ignored.remove(AVERAGE);
        }
        return ignored;
    }
}
