package sunbeam.app.cli.benchmark;

import static sunbeam.precompute.plan.MethodSettings.AVERAGE;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.method.TableMethod;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.plan.MethodSettings.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;

/** A method to measure, with a name that distinguishes it from others of the run. */
record Contender(String name, Method method) {
    static final Contender THESIS = new Contender("full, thesis", FullMethod.thesis());

    /** True if the user has chosen neither a method nor a setting that only some methods have. */
    static boolean isMethodOpen(Choices choices) {
        List<Setting<?>> common = new ArrayList<>(List.of(TOLERANCE));
        common.addAll(GaussianArea.SETTINGS);
        common.addAll(LightSettings.ALL);
        return choices.only(Methods.SETTINGS).without(common).chosen().isEmpty();
    }

    /**
     * Returns the chosen method or, if none is chosen, all but the reference. {@code full} and {@code table} appear at several tolerances
     * unless one is chosen.
     */
    static List<Contender> of(Choices choices) {
        if (!isMethodOpen(choices)) {
            return List.of(of(choices, Methods.of(choices)));
        }
        List<Contender> all = new ArrayList<>();
        for (MethodType type : Methods.ALL) {
            if (type.equals(ReferenceMethod.TYPE)) {
                continue;
            }
            List<Double> tolerances = choices.has(TOLERANCE) ? List.of() : tolerances(type);
            if (tolerances.isEmpty()) {
                all.add(of(choices, type.create(choices)));
            }
            for (double tolerance : tolerances) {
                Choices finer = choices.with(TOLERANCE, tolerance);
                all.add(of(finer, type.create(finer)));
            }
        }
        return all;
    }

    private static List<Double> tolerances(MethodType type) {
        if (type.equals(FullMethod.TYPE)) {
            return List.of(1e-2, 1e-3, 1e-4);
        }
        return type.equals(TableMethod.TYPE) ? List.of(1e-2, 1e-3) : List.of();
    }

    private static Contender of(Choices choices, Method method) {
        MethodType type = method.type();
        StringBuilder name = new StringBuilder(type.label());
        if (Preset.isThesis(choices)) {
            name.append(", preset thesis");
        } else if (type.has(TOLERANCE)) {
            name.append(", tolerance ").append(power(choices.get(TOLERANCE)));
        }
        if (type.has(AVERAGE) && choices.get(AVERAGE) == Average.ENSEMBLE) {
            name.append(", ensemble");
        }
        return new Contender(name.toString(), method);
    }

    private static String power(double tolerance) {
        return Text.format("%.1e", tolerance).replace(".0e", "e").replace("e-0", "e-");
    }
}
