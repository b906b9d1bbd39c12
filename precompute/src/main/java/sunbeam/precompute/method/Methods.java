package sunbeam.precompute.method;

import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.List;
import java.util.stream.Collectors;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;

/** Registry of all methods. */
public final class Methods {
    public static final List<MethodType> ALL = List.of(
            FullMethod.TYPE, // every wavelength
            TableMethod.TYPE, // tabulated
            NmmMethod.TYPE, // one wavelength an order
            PqMethod.TYPE, // replicas with sharp edges
            GemMethod.TYPE, // a spacing
            ReferenceMethod.TYPE); // the truth

    public static final Setting<MethodType> METHOD = new Setting<>(
                    "method",
                    ValueKind.oneOf("METHOD", ALL, MethodType::label),
                    "How colors are computed: "
                            + ALL.stream().map(MethodType::label).collect(Collectors.joining(", "))
                            + ". "
                            + ALL.stream()
                                    .map(type -> type.label() + ": " + type.help())
                                    .collect(Collectors.joining(" "))
                            + " See docs/theory.md.")
            .withStandard(FullMethod.TYPE);

    /** The method, all methods' settings, and the light's, in the manual's order. */
    public static final List<Setting<?>> SETTINGS = Setting.union(
            List.of(METHOD),
            ALL.stream().<Setting<?>>flatMap(type -> type.settings().stream()).toList(),
            MethodSettings.LIGHT);

    private Methods() {}

    /** Returns the chosen method; throws SettingException for a choice that the method does not have, or that contradicts another. */
    public static Method of(Choices choices) {
        MethodType type = choices.get(METHOD);
        for (Setting<?> setting : choices.only(SETTINGS)
                .without(METHOD)
                .without(MethodSettings.LIGHT)
                .chosen()) {
            if (!type.has(setting)) {
                checkFixed(type, setting, choices);
            }
        }
        return type.create(choices);
    }

    /** Describes choices and defaults for metadata: "tolerance 0.001, coherence length 65 um, average coherent". */
    public static String describe(Choices choices) {
        boolean thesis = Preset.isThesis(choices);
        Choices all = Choices.none();
        for (Setting<?> setting : choices.get(METHOD).settings()) {
            Choices one = choices.only(List.of(setting));
            all = (thesis && setting.equals(TOLERANCE) ? one : one.orStandard(setting)).over(all);
        }
        return choices.only(MethodSettings.LIGHT).over(all).describe();
    }

    private static void checkFixed(MethodType type, Setting<?> setting, Choices choices) {
        String fixed = type.fixed().written(setting);
        if (fixed.isEmpty()) {
            throw choices.complaint(
                    setting,
                    "belongs to ",
                    METHOD,
                    " " + owners(setting) + ", not " + type.label() + "; leave it out or use ",
                    METHOD,
                    " " + labels(setting).get(0));
        }
        if (!fixed.equals(choices.written(setting))) {
            throw choices.complaint(
                    setting,
                    "is not for ",
                    METHOD,
                    Text.format(" %s, which has %s only; leave it out or use ", type.label(), fixed),
                    METHOD,
                    " " + owners(setting));
        }
    }

    private static String owners(Setting<?> setting) {
        List<String> labels = labels(setting);
        String last = labels.get(labels.size() - 1);
        return labels.size() == 1 ? last : String.join(", ", labels.subList(0, labels.size() - 1)) + " or " + last;
    }

    private static List<String> labels(Setting<?> setting) {
        return ALL.stream()
                .filter(type -> type.has(setting))
                .map(MethodType::label)
                .toList();
    }
}
