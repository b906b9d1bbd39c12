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
 * Diffraction method of a scene. The defaults for a mesh are color tables, since a pixel covers more than a point, and the ensemble
 * average, since it covers many coherence areas.
 *
 * @param choices choices of {@link Methods#SETTINGS}; those that only other methods use are ignored but stored
 */
public record SceneMethod(Choices choices) {
    /** Method of scenes that name none. */
    public static final MethodType STANDARD = TableMethod.TYPE;

    /** Default tolerance of color tables: finer ones take longer and look the same on a screen. */
    public static final double TABLE_TOLERANCE = 1e-2;

    /** Source of default values, which another method replaces by its own. */
    private static final Origin DEFAULT = new Origin() {
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
     * Checks that the method can draw meshes.
     *
     * @throws sunbeam.precompute.setting.SettingException for a choice that cannot be used, naming its source
     */
    public SceneMethod {
        choices = choices.only(Methods.SETTINGS);
        if (!choices.has(Methods.METHOD)) {
            choices = choices.over(Choices.at(DEFAULT).with(Methods.METHOD, STANDARD));
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

    /** True if a method can draw meshes. */
    public static boolean draws(MethodType type) {
        return !type.equals(ReferenceMethod.TYPE);
    }

    /** Returns the defaults for a mesh, which are written to scene files. */
    private static Choices standard(Choices chosen) {
        MethodType type = chosen.get(Methods.METHOD);
        Choices standard = Choices.at(DEFAULT).with(Methods.METHOD, type);
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

    /** Returns this method with its coherence length limited to a patch's scan. */
    public SceneMethod seeing(Patch patch) {
        return new SceneMethod(ScanLimit.of(choices, patch).choices());
    }

    public MethodType type() {
        return get(Methods.METHOD);
    }

    public <T> T get(Setting<T> setting) {
        return choices.get(setting);
    }

    /** True if defaults are those of the thesis. */
    public boolean isThesis() {
        return Preset.isThesis(choices);
    }

    public Choices light() {
        return choices.only(LightSettings.ALL);
    }

    /** Returns Gaussian window and average of a method that has them. */
    public GaussianArea area() {
        return GaussianArea.of(choices);
    }

    /**
     * Returns this method with other choices in place of its own. A change of method drops settings that only the old method has and a
     * default tolerance; the thesis's preset drops the tolerance, and a default average.
     */
    public SceneMethod with(Choices others) {
        MethodType type = others.get(Methods.METHOD, type());
        List<Setting<?>> kept = new ArrayList<>(FullMethod.TYPE.settings());
        kept.addAll(type.settings());
        kept.addAll(LightSettings.ALL);
        kept.add(Methods.METHOD);
        if (Preset.isThesis(others) || (!type.equals(type()) && isDefault(TOLERANCE))) {
            kept.removeAll(List.of(TOLERANCE));
        }
        if (Preset.isThesis(others) && isDefault(AVERAGE)) {
            kept.removeAll(List.of(AVERAGE));
        }
        Choices own = choices.only(kept);
        // An explicitly chosen method must accept all chosen settings, else that is an error; a default method gives
        // way to them.
        return new SceneMethod(
                others.has(Methods.METHOD) || isDefault(Methods.METHOD)
                        ? others.over(own)
                        : own.without(others.chosen()).over(others));
    }

    @SuppressWarnings("ReferenceEquality") // the one object
    private boolean isDefault(Setting<?> setting) {
        return choices.origin(setting) == DEFAULT;
    }

    /**
     * Returns settings that a scene file may contain although the method ignores them: those of a plan for methods without one, else those
     * of a window.
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
