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
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * Diffraction method of a scene. Defaults are color tables, as a pixel covers more than a point, and the ensemble average, as it covers
 * many coherence areas.
 *
 * @param chosen values of {@link Methods#SETTINGS}; those that only other methods use are stored but ignored
 */
public record SceneMethod(Choices chosen) {
    public static final MethodType STANDARD = TableMethod.TYPE;

    /** Finer color tables take longer and look the same on a screen. */
    public static final double TABLE_TOLERANCE = 1e-2;

    /** Throws SettingException for a method that cannot draw meshes, or other unusable choices. */
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

    public static boolean draws(MethodType type) {
        return !type.equals(ReferenceMethod.TYPE);
    }

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

    /** Limits the coherence length to the size of a patch's scan. */
    public SceneMethod seeing(Patch patch) {
        return new SceneMethod(ScanLimit.of(choices(), patch).choices());
    }

    public MethodType type() {
        return chosen.get(Methods.METHOD, STANDARD);
    }

    public <T> T get(Setting<T> setting) {
        return choices().get(setting);
    }

    /** True for color tables, whose pixels are averages over footprints; other methods evaluate points. */
    public boolean isTable() {
        return type().equals(TableMethod.TYPE);
    }

    public boolean isThesis() {
        return Preset.isThesis(chosen);
    }

    public Choices light() {
        return chosen.only(MethodSettings.LIGHT);
    }

    public GaussianArea area() {
        return GaussianArea.of(choices());
    }

    /**
     * Puts other choices in place of its own. Own values of settings that neither the new method nor {@link FullMethod} has are dropped,
     * and the tolerance if the others choose the thesis's preset.
     */
    public SceneMethod with(Choices others) {
        List<Setting<?>> inheritable = new ArrayList<>(FullMethod.TYPE.settings());
        inheritable.addAll(others.get(Methods.METHOD, type()).settings());
        inheritable.addAll(MethodSettings.LIGHT);
        inheritable.add(Methods.METHOD);
        if (Preset.isThesis(others)) {
            inheritable.removeAll(List.of(TOLERANCE));
        }
        Choices own = chosen.only(inheritable);
        // Complaints about defaults name the source of the others, or of this method.
        return new SceneMethod(
                others.has(Methods.METHOD) || !chosen.has(Methods.METHOD)
                        ? others.over(own)
                        : own.without(others.chosen()).over(others));
    }

    /** A scene file may contain settings that the method ignores: with a tolerance the window's, without one the full method's. */
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
