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
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * Diffraction method of a scene. The defaults for a mesh are color tables, since a pixel covers more than a point, and the ensemble
 * average, since it covers many coherence areas.
 *
 * @param chosen chosen values of {@link Methods#SETTINGS}; those that only other methods use are stored but ignored
 */
public record SceneMethod(Choices chosen) {
    /** Method of scenes that name none. */
    public static final MethodType STANDARD = TableMethod.TYPE;

    /** Default tolerance of color tables: finer ones take longer and look the same on a screen. */
    public static final double TABLE_TOLERANCE = 1e-2;

    /**
     * Checks that the method can draw meshes.
     *
     * @throws sunbeam.precompute.setting.SettingException for a choice that cannot be used; the message names its source
     */
    public SceneMethod {
        chosen = chosen.only(Methods.SETTINGS);
        if (!draws(chosen.get(Methods.METHOD, STANDARD))) {
            throw chosen.complaint(
                    Methods.METHOD,
                    "is for maps and lists of directions; for a mesh use one of "
                            + Methods.ALL.stream()
                                    .filter(SceneMethod::draws)
                                    .map(MethodType::label)
                                    .collect(Collectors.joining(", ")));
        }
        create(withStandards(chosen));
    }

    /** True if a method can draw meshes. */
    public static boolean draws(MethodType type) {
        return !type.equals(ReferenceMethod.TYPE);
    }

    /** Returns the chosen values over the method's defaults. */
    public Choices choices() {
        return withStandards(chosen);
    }

    private static Choices withStandards(Choices chosen) {
        MethodType type = chosen.get(Methods.METHOD, STANDARD);
        boolean isThesis = Preset.isThesis(chosen);
        Choices standard = Choices.none().with(Methods.METHOD, type);
        if (type.has(TOLERANCE) && !isThesis) {
            double tolerance = TOLERANCE.standard().orElseThrow();
            standard = standard.with(TOLERANCE, type.equals(TableMethod.TYPE) ? TABLE_TOLERANCE : tolerance);
        }
        if (type.has(AVERAGE)) {
            standard = standard.with(AVERAGE, isThesis ? Average.COHERENT : Average.ENSEMBLE);
        }
        return chosen.over(standard);
    }

    private static Method create(Choices choices) {
        return Methods.of(choices.without(ignoredSettings(choices.get(Methods.METHOD))));
    }

    public Method method() {
        return create(choices());
    }

    /** Returns this method with its coherence length limited by the size of a patch's scan. */
    public SceneMethod seeing(Patch patch) {
        return new SceneMethod(ScanLimit.of(choices(), patch).choices());
    }

    public MethodType type() {
        return chosen.get(Methods.METHOD, STANDARD);
    }

    public <T> T get(Setting<T> setting) {
        return choices().get(setting);
    }

    /** True if the preset, which sets defaults, is that of the thesis. */
    public boolean isThesis() {
        return Preset.isThesis(chosen);
    }

    public Choices light() {
        return chosen.only(LightSettings.ALL);
    }

    /** Returns the Gaussian window and average of a method that has these settings. */
    public GaussianArea area() {
        return GaussianArea.of(choices());
    }

    /**
     * Returns this method with other choices in place of its own. First it drops own values of settings that neither the new method nor
     * {@link FullMethod} has, and the tolerance if the others choose the thesis's preset.
     */
    public SceneMethod with(Choices others) {
        List<Setting<?>> inheritable = new ArrayList<>(FullMethod.TYPE.settings());
        inheritable.addAll(others.get(Methods.METHOD, type()).settings());
        inheritable.addAll(LightSettings.ALL);
        inheritable.add(Methods.METHOD);
        if (Preset.isThesis(others)) {
            inheritable.removeAll(List.of(TOLERANCE));
        }
        Choices own = chosen.only(inheritable);
        // Both branches give the same values. They differ in the source that complaints about defaults name: that of
        // the others if they choose the method or it is a default, else that of this method.
        return new SceneMethod(
                others.has(Methods.METHOD) || !chosen.has(Methods.METHOD)
                        ? others.over(own)
                        : own.without(others.chosen()).over(others));
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
