package sunbeam.app.cli.options;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Quoted;

/** Which method, and what a user fixes of it; to be used as a picocli mixin. */
public final class MethodOptions extends SettingOptions {
    @Option(names = "--explain", description = "Say why each part of the plan is as it is.")
    private boolean explain;

    /** Options for all methods. */
    public MethodOptions() {
        this(Methods.SETTINGS, Map.of());
    }

    private MethodOptions(List<Setting<?>> settings, Map<Setting<?>, String> told) {
        super(settings, told);
    }

    /** Options for some methods, all that at least one of them has. */
    public static MethodOptions of(MethodType... types) {
        return new MethodOptions(
                Arrays.stream(types)
                        .flatMap(type -> type.settings().stream())
                        .distinct()
                        .toList(),
                Map.of());
    }

    /**
     * Options for all methods, of a command that chooses the average where none is given.
     *
     * @param chosen what it chooses, for the help
     */
    public static MethodOptions choosingAverage(String chosen) {
        return new MethodOptions(Methods.SETTINGS, Map.of(MethodSettings.AVERAGE, chosen));
    }

    /** Choices with the ensemble average where the method has it and nobody chose: one coherence area shows its speckle. */
    public static Choices averaged(Choices chosen) {
        boolean open = !chosen.has(MethodSettings.AVERAGE) && !Preset.isThesis(chosen);
        return open && chosen.get(Methods.METHOD).has(MethodSettings.AVERAGE)
                ? chosen.with(MethodSettings.AVERAGE, Average.ENSEMBLE)
                : chosen;
    }

    /** Whether reasons are asked for. */
    public boolean explains() {
        return explain;
    }

    /** Prints a plan with its reasons where they are asked for. */
    public void explain(SpectrumPlan plan, PrintWriter out) {
        if (explain) {
            print("plan: ", plan.summary(), plan.reasons(), out);
        }
    }

    /** Prints a method's plan, with reasons where they are asked for, and what breaks its tolerance. */
    public void print(MethodPlan method, PrintWriter out) {
        print("", method, out);
    }

    /** As {@link #print(MethodPlan, PrintWriter)}, for one of several patches; without a name for the only one. */
    public void print(String patch, MethodPlan method, PrintWriter out) {
        String name = patch.isEmpty() ? "" : Quoted.oneLine(patch) + ": ";
        print("plan: " + name, method.summary(), method.reasons(), out);
        method.warnings().forEach(line -> out.println(Messages.warning(line.in(OptionOrigin.INSTANCE))));
    }

    /** Prints what was found of a table when it was tried; nothing for what was not. */
    public void printTrial(String trial, PrintWriter out) {
        if (!trial.isEmpty()) {
            out.println("table: " + trial);
        }
    }

    private void print(String title, String summary, List<String> reasons, PrintWriter out) {
        out.println(title + summary);
        if (explain) {
            reasons.forEach(line -> out.println("  " + line));
        }
    }
}
