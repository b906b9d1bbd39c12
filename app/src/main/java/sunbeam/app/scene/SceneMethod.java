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
 * @param choices values of {@link Methods#SETTINGS}; those that only other methods use are stored but ignored
 */
public record SceneMethod(Choices choices) {
    /** Method of scenes that name none. */
    public static final MethodType STANDARD = TableMethod.TYPE;

    /** Default tolerance of color tables: finer ones take longer and look the same on a screen. */
    public static final double TABLE_TOLERANCE = 1e-2;

    /** Source of default values. A change of method replaces values from this source by its own defaults. */
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
     * Adds defaults, and checks that the method can draw meshes.
     *
     * @throws sunbeam.precompute.setting.SettingException for a choice that cannot be used; the message names its source
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

    /** Returns this method with its coherence length limited by the size of a patch's scan. */
    public SceneMethod seeing(Patch patch) {
        return new SceneMethod(ScanLimit.of(choices, patch).choices());
    }

    public MethodType type() {
        return get(Methods.METHOD);
    }

    public <T> T get(Setting<T> setting) {
        return choices.get(setting);
    }

    /** True if the preset, which sets defaults, is that of the thesis. */
    public boolean isThesis() {
        return Preset.isThesis(choices);
    }

    public Choices light() {
        return choices.only(LightSettings.ALL);
    }

    /** Returns the Gaussian window and average of a method that has these settings. */
    public GaussianArea area() {
        return GaussianArea.of(choices);
    }

    /**
     * Returns this method with other choices in place of its own. First it drops own values: settings that neither the new method nor
     * {@link FullMethod} has; a default tolerance if the method changes; any tolerance and a default average if the others choose the
     * thesis's preset.
     */
    public SceneMethod with(Choices others) {
        MethodType type = others.get(Methods.METHOD, type());
        List<Setting<?>> inheritable = new ArrayList<>(FullMethod.TYPE.settings());
        inheritable.addAll(type.settings());
        inheritable.addAll(LightSettings.ALL);
        inheritable.add(Methods.METHOD);
        if (Preset.isThesis(others) || (!type.equals(type()) && isDefault(TOLERANCE))) {
            inheritable.removeAll(List.of(TOLERANCE));
        }
        if (Preset.isThesis(others) && isDefault(AVERAGE)) {
            inheritable.removeAll(List.of(AVERAGE));
        }
        Choices own = choices.only(inheritable);
        // Both branches give the same values. They differ in the source that complaints about defaults name: that of
        // the others if they choose the method or it is a default, else that of this method.
        return new SceneMethod(
                others.has(Methods.METHOD) || isDefault(Methods.METHOD)
                        ? others.over(own)
                        : own.without(others.chosen()).over(others));
    }

    @SuppressWarnings("ReferenceEquality") // DEFAULT is a single object
    private boolean isDefault(Setting<?> setting) {
        return choices.origin(setting) == DEFAULT;
    }

    /**
     * Returns settings that a scene file may contain although the method ignores them. A method with a tolerance ignores the window's
     * settings; a method without one ignores the full method's.
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
