package sunbeam.app.viewer;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.viewer.ControlPanel.ControlOrigin;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.spectrum.PeriodInterpolation;

/** Entry of the method list: a method that can draw meshes, in one of its forms that look different (interpolation or preset). */
public record MethodChoice(String label, Choices own) {
    public static final List<MethodChoice> ALL = Methods.ALL.stream()
            .filter(SceneMethod::draws)
            .flatMap(type -> forms(type).stream())
            .toList();

    /** Methods without color tables, which can be drawn beside the scene's own method. */
    static final List<MethodChoice> COMPARED = ALL.stream()
            .filter(choice -> !choice.type().equals(TableMethod.TYPE))
            .toList();

    private static List<MethodChoice> forms(MethodType type) {
        Choices plain = Choices.at(ControlOrigin.INSTANCE).with(Methods.METHOD, type);
        if (type.has(MethodSettings.INTERPOLATION)) {
            return List.of(
                    new MethodChoice(type.label() + ", sinc", plain),
                    new MethodChoice(
                            type.label() + ", linear",
                            plain.with(MethodSettings.INTERPOLATION, PeriodInterpolation.LINEAR)));
        }
        MethodChoice first = new MethodChoice(type.label(), plain);
        return type.has(MethodSettings.PRESET)
                ? List.of(
                        first,
                        new MethodChoice(type.label() + ", thesis", plain.with(MethodSettings.PRESET, Preset.THESIS)))
                : List.of(first);
    }

    /** Returns the entry of a scene's method; if several agree, the one with the most settings. */
    public static MethodChoice of(Scene scene) {
        Choices choices = scene.method().choices();
        return ALL.stream()
                .filter(choice -> choices.only(choice.own.chosen()).equals(choice.own))
                .max(Comparator.comparingInt(choice -> choice.own.chosen().size()))
                .orElseThrow();
    }

    /**
     * Returns this method with the settings of the method that it replaces. Settings that only the old method has are dropped. So are the
     * average for {@code pq}, which has only one, and tolerance and average for the thesis's preset. Entered settings come first.
     */
    SceneMethod inPlaceOf(SceneMethod other, Choices entered) {
        List<Setting<?>> kept = new ArrayList<>(
                List.of(MethodSettings.TOLERANCE, MethodSettings.COHERENCE_LENGTH, MethodSettings.AVERAGE));
        if (has(MethodSettings.REPLICAS)) {
            kept.add(MethodSettings.REPLICAS);
        }
        if (has(MethodSettings.TOLERANCE) && !has(MethodSettings.AVERAGE)) {
            kept.remove(MethodSettings.AVERAGE);
        }
        if (isThesis()) {
            kept.removeAll(List.of(MethodSettings.TOLERANCE, MethodSettings.AVERAGE));
        }
        return new SceneMethod(own.over(other.choices().only(kept)).over(entered));
    }

    private MethodType type() {
        return own.get(Methods.METHOD);
    }

    private boolean isThesis() {
        return own.has(MethodSettings.PRESET);
    }

    /** True if the tolerance affects the picture. */
    public boolean hasTolerance() {
        return has(MethodSettings.TOLERANCE) && !isThesis();
    }

    boolean has(Setting<?> setting) {
        return type().has(setting);
    }

    @Override
    public String toString() {
        return label;
    }
}
